// A Cycle carries up to four commands, each believed by its own vehicle alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "wire/messages.h"
#include "wire/random_messages.h"

namespace tessera::wire {
namespace {

std::vector<std::uint8_t> payloadOf(const CycleWriter& writer, FrameHeader* header = nullptr) {
  std::array<std::uint8_t, kMaxFrame> out{};
  const std::size_t n = writer.finish(out);
  std::vector<std::uint8_t> payload;
  FrameDecoder decoder;
  decoder.feed(Bytes{out}.first(n), [&](const Frame& f) {
    payload.assign(f.payload.begin(), f.payload.end());
    if (header) *header = f.header;
  });
  return payload;
}

TEST(Cycle, entriesRoundTripEachUnderItsOwnKey) {
  Random random{2};
  for (int i = 0; i < 2000; ++i) {
    const std::size_t n = 1 + random() % kMaxCycleEntries;
    const auto counter = static_cast<std::uint32_t>(random() % 100'000 + 1);
    const auto slot = static_cast<std::uint8_t>(random());
    CycleWriter writer{slot, counter};
    std::vector<CycleEntry> entries;
    std::vector<Key> keys;
    for (std::size_t k = 0; k < n; ++k) {
      entries.push_back(randomEntry(random));
      entries[k].vehicle = static_cast<std::uint8_t>(k * 60 + 1 + random() % 60);
      keys.push_back(randomKey(random));
      ASSERT_TRUE(writer.add(entries[k], keys[k]));
    }
    FrameHeader header;
    const auto payload = payloadOf(writer, &header);
    ASSERT_EQ(header, (FrameHeader{255, 0, 2, static_cast<std::uint16_t>(counter)}));
    for (std::size_t k = 0; k < n; ++k) {
      const auto part = findEntry(payload, entries[k].vehicle);
      ASSERT_TRUE(part);
      ASSERT_EQ(part->entry, entries[k]);
      ASSERT_EQ(part->index, k);
      ASSERT_EQ(part->slot, slot);
      ReplayGuard own{counter - 1};
      ASSERT_EQ(own.accept(keys[k], header, part->authenticated, part->mac), Refusal::None);
      ReplayGuard other{counter - 1};
      ASSERT_EQ(other.accept(keys[(k + 1) % n], header, part->authenticated, part->mac),
                n == 1 ? Refusal::None : Refusal::Forged);
    }
    ASSERT_FALSE(findEntry(payload, 0));
  }
}

TEST(Cycle, takesFourEntriesAndIsOnePacket) {
  CycleWriter writer{9, 1};
  for (std::uint8_t v = 1; v <= 4; ++v) EXPECT_TRUE(writer.add({.vehicle = v}, {}));
  EXPECT_FALSE(writer.add({.vehicle = 5}, {}));
  EXPECT_EQ(writer.count(), 4U);
  std::array<std::uint8_t, 100> out{};
  EXPECT_EQ(writer.finish(out), kMaxFrame);
  EXPECT_EQ(writer.finish(std::span{out}.first(57)), 0U);
  EXPECT_FALSE(findEntry(payloadOf(writer), 5));
}

TEST(Cycle, anEntryMovedToAnotherPlaceOrSlotIsRefused) {
  const Key key{1};
  CycleWriter writer{9, 1};
  writer.add({.vehicle = 1, .mode = CommandMode::Drive, .speed = 100}, key);
  writer.add({.vehicle = 2, .mode = CommandMode::Stop}, {2});
  FrameHeader header;
  const auto good = payloadOf(writer, &header);
  const auto believed = [&](const std::vector<std::uint8_t>& payload) {
    const auto part = findEntry(payload, 1);
    ReplayGuard guard;
    return part && guard.accept(key, header, part->authenticated, part->mac) == Refusal::None;
  };
  EXPECT_TRUE(believed(good));
  auto swapped = good;
  std::swap_ranges(swapped.begin() + 1, swapped.begin() + 13, swapped.begin() + 13);
  EXPECT_FALSE(believed(swapped));
  auto otherSlot = good;
  otherSlot[0] = 10;
  EXPECT_FALSE(believed(otherSlot));
  for (std::size_t byte = 2; byte < 13; ++byte) {
    auto changed = good;
    changed[byte] ^= 1;
    EXPECT_FALSE(believed(changed)) << byte;
  }
}

TEST(Cycle, malformedPayloadsHoldNoEntry) {
  EXPECT_FALSE(findEntry({}, 1));
  CycleWriter writer{9, 1};
  EXPECT_FALSE(findEntry(payloadOf(writer), 1)) << "a cycle without entries";
  writer.add({.vehicle = 1}, {});
  auto payload = payloadOf(writer);
  EXPECT_TRUE(findEntry(payload, 1));
  payload[2] = 4;  // a mode that does not exist
  EXPECT_FALSE(findEntry(payload, 1));
  payload[2] = 0;
  payload.pop_back();
  EXPECT_FALSE(findEntry(payload, 1));
}

}  // namespace
}  // namespace tessera::wire
