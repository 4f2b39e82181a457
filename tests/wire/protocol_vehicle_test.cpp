// A vehicle in another language, written from docs/protocol.md alone, understands what core/wire says and is
// understood. Where it must keep silent, the next thing that it says is the answer to the next frame.
#include <gtest/gtest.h>

#include "wire/messages.h"
#include "wire/stranger.h"

namespace tessera::wire {
namespace {

constexpr std::uint8_t kAddress = 7;
constexpr Key kLongTerm{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
using Buffer = std::array<std::uint8_t, kMaxFrame>;

class ProtocolVehicle : public ::testing::Test {
protected:
  std::optional<Stranger::Said> hello(std::uint32_t nonce, std::uint32_t counter) {
    std::array<std::uint8_t, 8> body{};
    encode(Hello{nonce, counter}, body);
    Buffer out{};
    const FrameHeader header{kAddress, 0, static_cast<std::uint8_t>(MessageType::Hello), 0};
    vehicle_.say(Bytes{out}.first(sealFrame(kLongTerm, 0, header, body, out)));
    return vehicle_.listen();
  }
  std::optional<Identity> identityIn(const std::optional<Stranger::Said>& said) {
    const auto body = genuine(said, MessageType::Identity, kLongTerm, 0);
    return body ? decodeIdentity(*body) : std::nullopt;
  }
  void meet(std::uint32_t nonce, std::uint32_t counter) {
    const auto identity = identityIn(hello(nonce, counter));
    ASSERT_TRUE(identity);
    ASSERT_EQ(identity->hostNonce, nonce);
    session_ = deriveSessionKey(kLongTerm, {nonce, identity->boot, identity->hello});
    reports_ = 0;
  }
  static std::vector<std::uint8_t> cycle(std::uint32_t counter, const CycleEntry& entry, const Key& key,
                                         bool second = false) {
    CycleWriter writer{second ? std::uint8_t{25} : std::uint8_t{0}, counter};
    if (second) writer.add({.vehicle = 9}, {});
    writer.add(entry, key);
    Buffer out{};
    const std::size_t n = writer.finish(out);
    return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(n)};
  }
  void poll(std::uint32_t counter, std::uint8_t nextEvent = 0) {
    vehicle_.say(cycle(counter, {.vehicle = kAddress, .nextEvent = nextEvent}, session_));
  }
  std::optional<Report> report() {
    last_ = vehicle_.listen();
    const auto body = genuine(last_, MessageType::Report, session_, ++reports_);
    return body ? decodeReport(*body) : std::nullopt;
  }

  Stranger vehicle_{
      {"python3", TESSERA_PROTOCOL_VEHICLE},
      {"7", "000102030405060708090A0B0C0D0E0F", "90", "0:04B15F823A2F48", "1:DEADBEEF", "2:04000000000000000001"}};
  Key session_{};
  std::uint32_t reports_ = 0;
  std::optional<Stranger::Said> last_;

private:
  static std::optional<std::vector<std::uint8_t>> genuine(const std::optional<Stranger::Said>& said, MessageType type,
                                                          const Key& key, std::uint32_t counter) {
    if (!said ||
        said->header != FrameHeader{0, kAddress, static_cast<std::uint8_t>(type), static_cast<std::uint16_t>(counter)})
      return std::nullopt;
    const auto sealed = splitMac(said->payload);
    if (!sealed || !sameMac(macOf(key, counter, said->header, sealed->body), sealed->mac)) return std::nullopt;
    return std::vector<std::uint8_t>(sealed->body.begin(), sealed->body.end());
  }
};

TEST_F(ProtocolVehicle, isIdentifiedAndReportsItsTagsUntilTheyAreAcknowledged) {
  meet(0x1A2B3C4D, 1000);
  poll(1001);
  auto r = report();
  ASSERT_TRUE(r);
  EXPECT_EQ(r->ack, 1001);
  EXPECT_EQ(r->bearing, 0x4000);
  EXPECT_EQ(r->firstEvent, 0);
  ASSERT_EQ(r->eventCount, 2) << "the third does not fit";
  EXPECT_EQ(r->events[0].reader, 0);
  EXPECT_EQ(r->events[0].kind, EventKind::Uid7);
  EXPECT_EQ(r->events[0].uid[6], 0x48);
  EXPECT_EQ(r->events[1].kind, EventKind::Uid4);
  poll(1002, 1);
  r = report();
  ASSERT_TRUE(r);
  EXPECT_EQ(r->firstEvent, 1);
  ASSERT_EQ(r->eventCount, 2);
  EXPECT_EQ(r->events[1].kind, EventKind::Uid10);
  poll(1003, 3);
  r = report();
  ASSERT_TRUE(r);
  EXPECT_EQ(r->firstEvent, 3);
  EXPECT_EQ(r->eventCount, 0);
}

TEST_F(ProtocolVehicle, keepsSilentToReplaysForgeriesAndDamageAndFindsFramesInNoise) {
  meet(1, 50);
  const auto good = cycle(51, {.vehicle = kAddress}, session_);
  vehicle_.say(std::vector<std::uint8_t>{0xA5, 0xA5, 3, 0, 0xFF});
  vehicle_.say(good);
  auto r = report();
  ASSERT_TRUE(r);
  EXPECT_EQ(r->ack, 51);
  vehicle_.say(good);
  vehicle_.say(cycle(60, {.vehicle = kAddress}, kLongTerm));
  vehicle_.say(cycle(60, {.vehicle = 8}, session_));
  auto damaged = cycle(60, {.vehicle = kAddress}, session_);
  damaged.back() ^= 1;
  vehicle_.say(damaged);
  poll(61);
  r = report();
  ASSERT_TRUE(r) << "its second report, or it has answered what it must refuse";
  EXPECT_EQ(r->ack, 61);
}

TEST_F(ProtocolVehicle, countsOnWhereSixteenBitsEnd) {
  meet(2, 65'534);
  for (std::uint32_t counter : {65'535U, 65'536U, 131'000U, 131'500U}) {
    poll(counter);
    const auto r = report();
    ASSERT_TRUE(r) << counter;
    EXPECT_EQ(r->ack, static_cast<std::uint16_t>(counter));
  }
}

TEST_F(ProtocolVehicle, hailsWhenItHasNoSession) {
  vehicle_.say(cycle(1, {.vehicle = kAddress}, kLongTerm));
  const auto said = vehicle_.listen();
  ASSERT_TRUE(said);
  EXPECT_EQ(said->header, (FrameHeader{0, kAddress, static_cast<std::uint8_t>(MessageType::Hail), 0}));
  const auto sealed = splitMac(said->payload);
  EXPECT_TRUE(sameMac(macOf(kLongTerm, 0, said->header, sealed->body), sealed->mac));
  EXPECT_TRUE(decodeHail(sealed->body));
}

TEST_F(ProtocolVehicle, aReplayedHelloDoesNotEndTheSession) {
  const auto first = hello(3, 10);
  const auto again = hello(3, 10);
  ASSERT_TRUE(first && again);
  EXPECT_EQ(first->payload, again->payload) << "the Identity got lost: the same once more";
  meet(3, 10);
  poll(11);
  ASSERT_TRUE(report());
  ASSERT_TRUE(identityIn(hello(3, 10))) << "to a replay it cannot tell from a new call";
  poll(12);
  const auto r = report();
  ASSERT_TRUE(r) << "the running session goes on";
  EXPECT_EQ(r->ack, 12);
  meet(4, 12);
  poll(13);
  EXPECT_TRUE(report()) << "and a real call opens a new one";
}

TEST_F(ProtocolVehicle, answersInItsSlot) {
  meet(5, 0);
  vehicle_.say(cycle(1, {.vehicle = kAddress}, session_, true));
  const auto r = report();
  ASSERT_TRUE(r);
  EXPECT_GE(last_->after, std::chrono::milliseconds{100});
  EXPECT_GE(r->hold, 100);
}

TEST_F(ProtocolVehicle, saysThatItKnowsNoParameters) {
  meet(6, 0);
  std::array<std::uint8_t, 1> body{2};
  Buffer out{};
  const FrameHeader header{kAddress, 0, static_cast<std::uint8_t>(MessageType::Get), 0};
  vehicle_.say(Bytes{out}.first(sealFrame(session_, 1, header, body, out)));
  const auto said = vehicle_.listen();
  ASSERT_TRUE(said);
  const auto value = decodeValue(splitMac(said->payload)->body);
  ASSERT_TRUE(value);
  EXPECT_EQ(value->outcome, Outcome::Unknown);
  EXPECT_EQ(value->ack, 1);
}

}  // namespace
}  // namespace tessera::wire
