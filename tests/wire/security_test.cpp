#include "wire/security.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "wire/random_messages.h"
#include "wire/sha256.h"

namespace tessera::wire {
namespace {

constexpr FrameHeader kHeader{7, 0, 3, 0};
const Key kKey{1, 2, 3};

struct Wire {
  FrameHeader header;
  std::vector<std::uint8_t> body;
  std::vector<std::uint8_t> mac;
};

Wire sealedWire(const Key& key, std::uint32_t counter, std::vector<std::uint8_t> body = {42},
                FrameHeader header = kHeader) {
  std::array<std::uint8_t, kMaxFrame> out{};
  const std::size_t n = sealFrame(key, counter, header, body, out);
  Wire wire;
  FrameDecoder decoder;
  decoder.feed(Bytes{out}.first(n), [&wire](const Frame& f) {
    const auto parts = splitMac(f.payload);
    wire = {f.header, {parts->body.begin(), parts->body.end()}, {parts->mac.begin(), parts->mac.end()}};
  });
  return wire;
}

Refusal offer(ReplayGuard& guard, const Wire& wire, const Key& key = kKey) {
  return guard.accept(key, wire.header, wire.body, wire.mac);
}

TEST(Mac, isTheCutHmacOfCounterAddressesTypeAndBody) {
  const std::array<std::uint8_t, 8> text{0x78, 0x56, 0x34, 0x12, 7, 0, 3, 42};
  Hmac hmac{kKey};
  hmac.update(text);
  const Digest digest = hmac.finish();
  const Mac mac = macOf(kKey, 0x12345678, kHeader, std::array<std::uint8_t, 1>{42});
  EXPECT_TRUE(sameMac(mac, Bytes{digest}.first(4)));
  EXPECT_FALSE(sameMac(mac, Bytes{digest}.first(3)));
  EXPECT_FALSE(sameMac(mac, Bytes{digest}.subspan(1, 4)));
}

TEST(SessionKey, differsWithEachPartOfTheNonce) {
  const SessionNonce nonce{1, 2, 3};
  std::set<Key> keys{deriveSessionKey(kKey, nonce)};
  keys.insert(deriveSessionKey(kKey, {2, 2, 3}));
  keys.insert(deriveSessionKey(kKey, {1, 3, 3}));
  keys.insert(deriveSessionKey(kKey, {1, 2, 4}));
  keys.insert(deriveSessionKey(Key{9}, nonce));
  keys.insert(kKey);
  EXPECT_EQ(keys.size(), 6U);
  EXPECT_EQ(deriveSessionKey(kKey, nonce), deriveSessionKey(kKey, nonce));
}

TEST(SealedFrame, isRefusedAfterAnyChangedBit) {
  const Wire good = sealedWire(kKey, 5, {1, 2, 3, 4});
  const auto refused = [](const Wire& w) {
    ReplayGuard guard;
    return offer(guard, w) == Refusal::Forged && guard.last() == 0;
  };
  for (int bit = 0; bit < 8; ++bit) {
    const auto flip = static_cast<std::uint8_t>(1U << bit);
    for (std::size_t i = 0; i < good.body.size(); ++i) {
      Wire w = good;
      w.body[i] ^= flip;
      EXPECT_TRUE(refused(w));
    }
    for (std::size_t i = 0; i < good.mac.size(); ++i) {
      Wire w = good;
      w.mac[i] ^= flip;
      EXPECT_TRUE(refused(w));
    }
    for (auto field : {&FrameHeader::to, &FrameHeader::from, &FrameHeader::type}) {
      Wire w = good;
      w.header.*field ^= flip;
      EXPECT_TRUE(refused(w));
    }
    Wire w = good;
    w.header.counter ^= flip;
    EXPECT_TRUE(refused(w));
  }
}

TEST(SealedFrame, holdsAtMostFortyFiveBytesOfBody) {
  std::array<std::uint8_t, 100> out{};
  EXPECT_EQ(sealFrame(kKey, 1, kHeader, std::vector<std::uint8_t>(45), out), kMaxFrame);
  EXPECT_EQ(sealFrame(kKey, 1, kHeader, std::vector<std::uint8_t>(46), out), 0U);
}

TEST(ReplayGuard, acceptsGrowingCountersWithGaps) {
  ReplayGuard guard{10};
  for (std::uint32_t c : {11U, 12U, 20U, 60'000U}) EXPECT_EQ(offer(guard, sealedWire(kKey, c)), Refusal::None) << c;
  EXPECT_EQ(guard.last(), 60'000U);
}

TEST(ReplayGuard, refusesAFrameSeenBefore) {
  ReplayGuard guard;
  const Wire first = sealedWire(kKey, 1);
  const Wire second = sealedWire(kKey, 2);
  EXPECT_EQ(offer(guard, first), Refusal::None);
  EXPECT_EQ(offer(guard, first), Refusal::Replayed);
  EXPECT_EQ(offer(guard, second), Refusal::None);
  EXPECT_EQ(offer(guard, first), Refusal::Replayed);
  EXPECT_EQ(guard.last(), 2U);
}

TEST(ReplayGuard, refusesAFrameOvertakenByALaterOne) {
  ReplayGuard guard;
  const Wire late = sealedWire(kKey, 1);
  EXPECT_EQ(offer(guard, sealedWire(kKey, 2)), Refusal::None);
  EXPECT_EQ(offer(guard, late), Refusal::Replayed);
}

TEST(ReplayGuard, countsOnWhereSixteenBitsEnd) {
  ReplayGuard guard{65'534};
  EXPECT_EQ(offer(guard, sealedWire(kKey, 65'535)), Refusal::None);
  EXPECT_EQ(offer(guard, sealedWire(kKey, 65'536)), Refusal::None);
  EXPECT_EQ(guard.last(), 65'536U);
  EXPECT_EQ(offer(guard, sealedWire(kKey, 65'535)), Refusal::Replayed) << "from before the wrap";
  EXPECT_EQ(offer(guard, sealedWire(kKey, 131'071)), Refusal::None);
  EXPECT_EQ(offer(guard, sealedWire(kKey, 131'073)), Refusal::None);
  EXPECT_EQ(guard.last(), 131'073U);
}

TEST(ReplayGuard, refusesTheSameLowBitsOfAnotherTurn) {
  ReplayGuard guard;
  const Wire old = sealedWire(kKey, 100);
  EXPECT_EQ(offer(guard, old), Refusal::None);
  EXPECT_EQ(offer(guard, sealedWire(kKey, 65'600)), Refusal::None);
  EXPECT_EQ(offer(guard, old), Refusal::Replayed) << "its low 16 bits would be new, its MAC is not";
}

TEST(ReplayGuard, losesTheThreadAfterMissing65536Frames) {
  ReplayGuard guard{5};
  EXPECT_EQ(offer(guard, sealedWire(kKey, 5 + 65'536)), Refusal::None);
  EXPECT_EQ(offer(guard, sealedWire(kKey, 5 + 65'536 + 65'537)), Refusal::Forged) << "a new session is needed";
}

TEST(ReplayGuard, refusesOtherKeysOtherSessionsAndShortMacs) {
  ReplayGuard guard;
  EXPECT_EQ(offer(guard, sealedWire(Key{9}, 1)), Refusal::Forged);
  EXPECT_EQ(offer(guard, sealedWire(deriveSessionKey(kKey, {1, 1, 1}), 1), deriveSessionKey(kKey, {1, 1, 2})),
            Refusal::Forged);
  Wire shortened = sealedWire(kKey, 1);
  shortened.mac.pop_back();
  EXPECT_EQ(offer(guard, shortened), Refusal::TooShort);
  EXPECT_EQ(guard.last(), 0U);
}

TEST(ReplayGuard, takesEachOfManyShuffledFramesAtMostOnce) {
  Random random{16};
  ReplayGuard guard;
  std::set<std::uint32_t> taken;
  std::uint32_t newest = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::uint32_t step = random() % 3 == 0 ? static_cast<std::uint32_t>(random() % 3000) : 1;
    const bool replay = newest > 0 && random() % 4 == 0;
    const std::uint32_t counter =
        replay ? newest - static_cast<std::uint32_t>(random() % std::min(newest, 40'000U)) : newest + step;
    const Refusal refusal = offer(guard, sealedWire(kKey, counter));
    ASSERT_EQ(refusal == Refusal::None, counter > newest) << counter << " after " << newest;
    if (refusal == Refusal::None) {
      ASSERT_TRUE(taken.insert(counter).second);
      newest = counter;
    }
  }
}

TEST(SplitMac, needsFourBytes) {
  const std::array<std::uint8_t, 5> five{1, 2, 3, 4, 5};
  EXPECT_FALSE(splitMac(Bytes{five}.first(3)));
  EXPECT_TRUE(splitMac(Bytes{five}.first(4))->body.empty());
  EXPECT_EQ(splitMac(five)->body.size(), 1U);
  EXPECT_EQ(splitMac(five)->mac.front(), 2);
}

}  // namespace
}  // namespace tessera::wire
