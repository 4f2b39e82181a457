#include "link/session.h"

#include <gtest/gtest.h>

#include "link/channel_fixture.h"

namespace tessera::link {
namespace {

using test::FakeVehicle;
using test::keyOf;

// One host session and one vehicle, with nothing between them.
class SessionTest : public ::testing::Test {
protected:
  // The vehicle's answer to a frame of the host; empty: none.
  std::vector<std::uint8_t> answerTo(wire::Bytes frame) {
    std::vector<std::uint8_t> out;
    wire::FrameDecoder decoder;
    decoder.feed(frame, [&](const wire::Frame& f) {
      if (auto a = vehicle.hear(f, Seconds{1})) out = a->bytes;
    });
    return out;
  }
  Heard hear(wire::Bytes frame) {
    Heard heard = Disbelief::Strange;
    wire::FrameDecoder decoder;
    decoder.feed(frame, [&](const wire::Frame& f) { heard = session.hear(f); });
    return heard;
  }
  std::vector<std::uint8_t> call() {
    std::array<std::uint8_t, wire::kMaxFrame> out{};
    const std::size_t size = session.hello(++nonce, counter, out);
    return answerTo(wire::Bytes{out}.first(size));
  }
  std::vector<std::uint8_t> poll() {
    wire::CycleWriter writer{10, ++counter};
    writer.add({1, wire::CommandMode::Poll, 0, 0, 0, 0}, session.key());
    std::array<std::uint8_t, wire::kMaxFrame> out{};
    return answerTo(wire::Bytes{out}.first(writer.finish(out)));
  }

  FakeVehicle vehicle{1, keyOf(1)};
  Session session{VehicleId{1}, keyOf(1)};
  std::uint32_t nonce = 100;
  std::uint32_t counter = 70000;
};

TEST_F(SessionTest, opensWhenTheVehicleAnswersTheCall) {
  const Heard heard = hear(call());
  ASSERT_TRUE(std::holds_alternative<HeardIdentity>(heard));
  EXPECT_TRUE(std::get<HeardIdentity>(heard).first);
  EXPECT_TRUE(session.open());
  EXPECT_TRUE(std::holds_alternative<HeardReport>(hear(poll())));
}

TEST_F(SessionTest, seesThatTheVehicleHasAnotherKey) {
  vehicle.key = keyOf(9);
  vehicle.checksHello = false;
  EXPECT_EQ(std::get<Disbelief>(hear(call())), Disbelief::WrongKey);
  EXPECT_FALSE(session.open());
}

TEST_F(SessionTest, seesAnotherKeyByTheHailOfAVehicleThatIgnoresTheCall) {
  vehicle.key = keyOf(9);
  EXPECT_TRUE(call().empty());
  EXPECT_EQ(std::get<Disbelief>(hear(poll())), Disbelief::WrongKey);
}

TEST_F(SessionTest, refusesAnotherVersionOfTheProtocol) {
  vehicle.protocol = 7;
  const Heard heard = hear(call());
  ASSERT_TRUE(std::holds_alternative<HeardVersion>(heard));
  EXPECT_EQ(std::get<HeardVersion>(heard).protocol, 7);
  EXPECT_FALSE(session.open());
}

// The vehicle has dropped the session that it prepared for the first call, so a host that opened it would be alone
// there.
TEST_F(SessionTest, opensNothingByAnAnswerToARepeatedCallButSaysWhichOneItAnswers) {
  const auto first = call();
  const auto second = call();
  const Heard late = hear(first);
  ASSERT_TRUE(std::holds_alternative<HeardLate>(late));
  EXPECT_EQ(std::get<HeardLate>(late).hostNonce, 101U);
  EXPECT_FALSE(session.open());
  EXPECT_TRUE(std::holds_alternative<HeardIdentity>(hear(second)));
  EXPECT_TRUE(std::holds_alternative<HeardReport>(hear(poll())));
}

TEST_F(SessionTest, opensNothingByARecordedIdentityWhileACallIsUnderWay) {
  const auto recorded = call();
  hear(recorded);
  hear(poll());
  vehicle.on = false;
  call();
  EXPECT_TRUE(std::holds_alternative<HeardLate>(hear(recorded)));
  vehicle.on = true;
  EXPECT_TRUE(std::holds_alternative<HeardReport>(hear(poll()))) << "the standing session has ended";
}

TEST_F(SessionTest, refusesARecordedIdentity) {
  const auto identity = call();
  hear(identity);
  EXPECT_EQ(std::get<Disbelief>(hear(identity)), Disbelief::Replayed);
}

TEST_F(SessionTest, refusesAReportSeenBefore) {
  hear(call());
  const auto report = poll();
  EXPECT_TRUE(std::holds_alternative<HeardReport>(hear(report)));
  EXPECT_EQ(std::get<Disbelief>(hear(report)), Disbelief::Replayed);
}

TEST_F(SessionTest, refusesAReportOfAnEarlierSession) {
  hear(call());
  const auto old = poll();
  hear(call());
  EXPECT_TRUE(std::holds_alternative<Disbelief>(hear(old)));
}

TEST_F(SessionTest, refusesAReportWithAChangedByte) {
  hear(call());
  auto report = poll();
  report[12] ^= 1U;
  const std::uint16_t crc = wire::crc16(wire::Bytes{report}.subspan(1, report.size() - 3));
  report[report.size() - 2] = static_cast<std::uint8_t>(crc);
  report[report.size() - 1] = static_cast<std::uint8_t>(crc >> 8);
  EXPECT_EQ(std::get<Disbelief>(hear(report)), Disbelief::Forged);
}

TEST_F(SessionTest, learnsOfARestartByTheHail) {
  hear(call());
  vehicle.restart();
  const Heard heard = hear(poll());
  ASSERT_TRUE(std::holds_alternative<HeardHail>(heard));
  EXPECT_TRUE(std::get<HeardHail>(heard).restarted);
  EXPECT_FALSE(session.open());
  const Heard again = hear(call());
  ASSERT_TRUE(std::holds_alternative<HeardIdentity>(again));
  EXPECT_TRUE(std::get<HeardIdentity>(again).restarted);
}

TEST_F(SessionTest, callsAgainWhenTheVehicleNeverCameIntoTheSession) {
  const auto hail = poll();
  hear(call());
  const Heard heard = hear(hail);
  ASSERT_TRUE(std::holds_alternative<HeardHail>(heard));
  EXPECT_FALSE(std::get<HeardHail>(heard).restarted);
  EXPECT_FALSE(session.open());
}

TEST_F(SessionTest, doesNotBelieveARecordedHail) {
  const auto hail = poll();
  hear(hail);
  hear(call());
  hear(poll());
  EXPECT_EQ(std::get<Disbelief>(hear(hail)), Disbelief::Replayed);
  EXPECT_TRUE(session.open());
}

TEST_F(SessionTest, noticesTheRestartOfAVehicleThatCannotCountItsStarts) {
  vehicle.countsStarts = false;
  hear(call());
  hear(call());
  vehicle.restart();
  const Heard again = hear(call());
  ASSERT_TRUE(std::holds_alternative<HeardIdentity>(again));
  EXPECT_TRUE(std::get<HeardIdentity>(again).restarted);
}

TEST_F(SessionTest, isNotARestartWhenTheSameVehicleIsCalledTwice) {
  hear(call());
  const Heard again = hear(call());
  ASSERT_TRUE(std::holds_alternative<HeardIdentity>(again));
  EXPECT_FALSE(std::get<HeardIdentity>(again).restarted);
}

TEST_F(SessionTest, livesOnWhenACallWasNotHeard) {
  hear(call());
  vehicle.on = false;
  EXPECT_TRUE(call().empty());
  vehicle.on = true;
  EXPECT_TRUE(std::holds_alternative<HeardReport>(hear(poll())));
}

}  // namespace
}  // namespace tessera::link
