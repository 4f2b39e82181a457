#include "firmware/vehicle/session.h"

#include <gtest/gtest.h>

#include "tests/firmware/test_host.h"

namespace tessera::firmware::test {
namespace {

constexpr std::uint8_t kVehicle = 7;
const wire::Key kKey{1, 2, 3};

struct SessionBench {
  Session session;
  TestHost host{kVehicle, kKey};
  Micros now{1s};

  explicit SessionBench(std::uint32_t starts = 3) {
    Person person;
    person.address = kVehicle;
    person.key = kKey;
    person.starts = starts;
    person.cause = wire::ResetCause::Software;
    session.start(person);
  }
  Heard send(const TestHost::Frame& bytes) {
    wire::FrameDecoder decoder;
    Heard heard;
    decoder.feed(bytes, [&](const wire::Frame& frame) { heard = session.receive(frame, now); });
    return heard;
  }
  // Sends what is owed now; says what it was.
  Owed reply() {
    const Owed owed = session.due(now);
    std::array<std::uint8_t, wire::kMaxFrame> out;
    std::size_t size = 0;
    if (owed == Owed::Identity) size = session.writeIdentity(out);
    if (owed == Owed::Hail) size = session.writeHail(out);
    if (owed == Owed::Report) size = session.writeReport({}, now, out);
    if (owed == Owed::Value) size = session.writeValue(out);
    host.take(wire::Bytes{out}.first(size));
    return owed;
  }
  void open(std::uint32_t nonce = 99) {
    send(host.hello(nonce));
    ASSERT_EQ(reply(), Owed::Identity);
    ASSERT_TRUE(send(host.poll()).newSession);
    ASSERT_EQ(reply(), Owed::Report);
    ASSERT_TRUE(host.report);
  }
};

TEST(Session, answersAHelloAndOpensWithTheFirstGenuineFrame) {
  SessionBench bench;
  bench.send(bench.host.hello(99));
  EXPECT_FALSE(bench.session.open()) << "a Hello alone opens nothing";
  EXPECT_EQ(bench.reply(), Owed::Identity);
  ASSERT_TRUE(bench.host.identity);
  EXPECT_EQ(bench.host.identity->boot, 3U);
  EXPECT_EQ(bench.host.identity->hello, 1U);
  const Heard heard = bench.send(bench.host.poll());
  EXPECT_EQ(heard.kind, Heard::Kind::Entry);
  EXPECT_TRUE(heard.newSession);
  EXPECT_TRUE(bench.session.open());
  bench.now += 12ms;
  EXPECT_EQ(bench.reply(), Owed::Report);
  ASSERT_TRUE(bench.host.report);
  EXPECT_EQ(bench.host.report->ack, bench.host.counter());
  EXPECT_EQ(bench.host.report->hold, 12);
}

TEST(Session, hailsWhenAddressedWithoutASession) {
  SessionBench bench;
  const Heard heard = bench.send(bench.host.drive(100, 0));
  EXPECT_EQ(heard.kind, Heard::Kind::Nothing);
  EXPECT_EQ(bench.reply(), Owed::Hail);
  ASSERT_TRUE(bench.host.hail);
  EXPECT_EQ(bench.host.hail->boot, 3U);
  EXPECT_EQ(bench.host.hail->cause, static_cast<std::uint8_t>(wire::ResetCause::Software));
  EXPECT_EQ(bench.session.faults(), 0);
}

TEST(Session, keepsSilentForOthersEntriesFramesAndHellos) {
  SessionBench bench;
  bench.open();
  TestHost other{8, kKey};
  bench.send(other.hello(5));
  EXPECT_EQ(bench.reply(), Owed::Nothing);
  bench.send(other.poll());
  EXPECT_EQ(bench.reply(), Owed::Nothing);
  EXPECT_EQ(bench.session.faults(), 0);
}

TEST(Session, refusesAReplayedCommandAndSaysSoOnce) {
  SessionBench bench;
  bench.open();
  const auto drive = bench.host.drive(100, 0);
  EXPECT_EQ(bench.send(drive).kind, Heard::Kind::Entry);
  EXPECT_EQ(bench.reply(), Owed::Report);
  EXPECT_EQ(bench.send(drive).kind, Heard::Kind::Nothing);
  EXPECT_EQ(bench.reply(), Owed::Nothing);
  EXPECT_NE(bench.session.faults(), 0);
  EXPECT_EQ(bench.session.framesRefused(), 1U);
  bench.send(bench.host.poll());
  bench.reply();
  EXPECT_EQ(bench.session.faults(), 0);
}

TEST(Session, tellsAReplayFromAForgeryAfterManyFrames) {
  SessionBench bench;
  bench.host.skipCounterTo(0x2'0000);
  bench.open();
  const auto old = bench.host.drive(100, 0);
  EXPECT_EQ(bench.send(old).kind, Heard::Kind::Entry);
  bench.send(old);
  EXPECT_EQ(bench.session.faults(), wire::kFaultReplayed);
}

TEST(Session, refusesAChangedByteAnywhereInAnEntry) {
  SessionBench bench;
  bench.open();
  for (std::size_t i = 0; i < 8; ++i) {
    auto frame = bench.host.drive(100, 0);
    frame[8 + i] ^= 0x01;  // behind the slot; the checksum is made good again, as a forger would
    const std::uint16_t crc = wire::crc16(wire::Bytes{frame}.subspan(1, frame.size() - 3));
    frame[frame.size() - 2] = static_cast<std::uint8_t>(crc);
    frame[frame.size() - 1] = static_cast<std::uint8_t>(crc >> 8);
    EXPECT_EQ(bench.send(frame).kind, Heard::Kind::Nothing) << "byte " << i;
    if (i >= 2) {
      EXPECT_EQ(bench.session.faults(), wire::kFaultForged) << "byte " << i;
    }
  }
}

TEST(Session, isNotDisturbedByAReplayedHello) {
  SessionBench bench;
  const auto hello = bench.host.hello(99);
  bench.send(hello);
  bench.reply();
  bench.send(bench.host.poll());
  bench.reply();
  bench.send(hello);
  EXPECT_EQ(bench.session.due(bench.now), Owed::Identity) << "the vehicle cannot know yet";
  EXPECT_EQ(bench.send(bench.host.drive(50, 0)).kind, Heard::Kind::Entry) << "the running session goes on";
  EXPECT_EQ(bench.reply(), Owed::Report);
  EXPECT_EQ(bench.host.unauthentic, 0);
}

TEST(Session, answersARepeatedHelloWithTheSameIdentity) {
  SessionBench bench;
  const auto hello = bench.host.hello(99);
  bench.send(hello);
  bench.reply();
  bench.send(hello);
  bench.reply();
  EXPECT_EQ(bench.host.identity->hello, 1U);
  EXPECT_EQ(bench.send(bench.host.poll()).kind, Heard::Kind::Entry);
}

TEST(Session, refusesTheOldSessionsFramesAfterANewOne) {
  SessionBench bench;
  bench.open(1);
  const auto old = bench.host.drive(100, 0);
  bench.open(2);
  EXPECT_EQ(bench.host.identity->hello, 2U);
  EXPECT_EQ(bench.send(old).kind, Heard::Kind::Nothing);
}

// Two recorded Hellos in turn prepare a session each; were the count of sessions to come round, so would an old key.
TEST(Session, neverMakesAnOldKeyAgainHoweverOftenHellosAreReplayed) {
  SessionBench bench;
  bench.open(99);
  const auto first = bench.host.hello(99);
  const auto second = bench.host.hello(1);
  const auto old = bench.host.drive(100, 0);
  bench.send(old);
  for (int i = 0; i < 70'000; ++i) {
    bench.send(i % 2 == 0 ? second : first);
    if (i % 2 == 1) {
      ASSERT_EQ(bench.send(old).kind, Heard::Kind::Nothing) << "after " << i << " Hellos";
    }
  }
  EXPECT_EQ(bench.send(bench.host.drive(50, 0)).kind, Heard::Kind::Entry) << "the running session goes on";
}

TEST(Session, refusesAHelloOfSomeoneWithoutTheKey) {
  SessionBench bench;
  TestHost stranger{kVehicle, wire::Key{9}};
  bench.send(stranger.hello(1));
  EXPECT_EQ(bench.reply(), Owed::Nothing);
  EXPECT_EQ(bench.session.faults(), wire::kFaultForged);
}

TEST(Session, answersInItsSlotAndNotAfterIt) {
  SessionBench bench;
  bench.open();
  bench.send(bench.host.cycle({}, 10, 2));  // third entry, slots of 40 ms
  bench.now += 79ms;
  EXPECT_EQ(bench.session.due(bench.now), Owed::Nothing);
  bench.now += 1ms;
  EXPECT_EQ(bench.session.due(bench.now), Owed::Report);
  bench.now += 30ms;
  EXPECT_EQ(bench.session.due(bench.now), Owed::Nothing) << "too late: the next vehicle's turn is near";
}

TEST(Session, bringsRequestsAndTheirAnswers) {
  SessionBench bench;
  bench.open();
  const Heard heard = bench.send(bench.host.request(wire::MessageType::Set, 5, 250));
  EXPECT_EQ(heard.kind, Heard::Kind::Request);
  EXPECT_EQ(heard.request, (wire::Request{wire::MessageType::Set, 5, 250}));
  bench.session.answer(wire::Outcome::Done, 250);
  EXPECT_EQ(bench.reply(), Owed::Value);
  EXPECT_EQ(bench.host.value,
            (wire::Value{static_cast<std::uint16_t>(bench.host.counter()), 5, wire::Outcome::Done, 250}));
}

TEST(Session, choosesAnotherNumberForTheStartWhenStartsAreNotCounted) {
  SessionBench first{0};
  first.now += 1234us;
  first.open();
  SessionBench second{0};
  second.now += 1235us;
  second.open();
  EXPECT_NE(first.host.identity->boot, second.host.identity->boot);
  EXPECT_GE(first.host.identity->boot, 0x80000000U);
}

}  // namespace
}  // namespace tessera::firmware::test
