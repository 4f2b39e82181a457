// What goes wrong on a shop floor: a sentence says it, the vehicle stands within its command's expiry, and goes on.
#include <gmock/gmock.h>

#include "scenario/scenario.h"
#include "wire/airtime.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tessera::scenario {
namespace {

using supervisor::EventKind;

// From the port to the vehicle at most: the longest packet at the world's air factor, and the serial lines.
const Seconds kAirWay{1.8 * wire::loRaAirtime(wire::kMaxFrame, 19200) + 0.02};
constexpr double kBraking = 3 * 0.5;  // m/s^2, of the firmware's wheel loop
constexpr Seconds kSlack{0.1};
constexpr MetresPerSecond kStanding{0.005};
constexpr Seconds kInstant{0.001};  // the world's step

class Adversity : public testing::Test {
protected:
  explicit Adversity(const ScenarioSetup& setup = {}) : scenario_{setup} {}

  void driveHalfAMetre() {
    scenario_.orderRoutes();
    ASSERT_TRUE(scenario_.until(Seconds{60}, [&] { return scenario_.view().progress > Metres{0.5}; }))
        << scenario_.sentences();
  }
  [[nodiscard]] Seconds toBrake() const { return Seconds{abs(scenario_.trueSpeed()).value() / kBraking} + kSlack; }
  /// When it must stand if the command that was sent last is the last that reaches it.
  [[nodiscard]] Seconds lastCommandEnds() const {
    const auto& command = scenario_.view().command;
    EXPECT_TRUE(command && command->mode == wire::CommandMode::Drive);
    return command ? command->sentAt + kAirWay + command->expiry + toBrake() : Seconds{};
  }
  /// It stands at that time and for a second more, looked at in each millisecond.
  void expectStandstill(Seconds latest) {
    EXPECT_GT(abs(scenario_.trueSpeed()), kStanding) << "nothing is shown by a vehicle that stands anyway";
    expectItStandsBy(latest);
  }
  void expectItStandsBy(Seconds latest) {
    Seconds moved = scenario_.lockstep().now();
    for (; scenario_.lockstep().now() < latest; scenario_.go(kInstant))
      if (abs(scenario_.trueSpeed()) >= kStanding) moved = scenario_.lockstep().now();
    testing::Test::RecordProperty("to_spare_s", std::to_string((latest - moved).value()));
    expectNoMove(Seconds{1});
  }
  /// Looks in each millisecond; tells whether `condition` held in one of them.
  bool expectNoMove(
      Seconds time, const std::function<bool()>& condition = [] { return false; }) {
    const Seconds end = scenario_.lockstep().now() + time;
    MetresPerSecond fastest{};
    bool held = false;
    for (; scenario_.lockstep().now() < end; scenario_.go(kInstant)) {
      fastest = std::max(fastest, abs(scenario_.trueSpeed()));
      held = condition() || held;
    }
    EXPECT_LT(fastest.value(), kStanding.value()) << "before " << end.value() << " s\n" << scenario_.sentences();
    return held;
  }
  void expectSentence(EventKind kind, bool over = false) {
    EXPECT_TRUE(scenario_.until(Seconds{20}, [&] { return scenario_.eventCount(kind, over) > 0; }))
        << "no event " << supervisor::nameOf(kind) << " in\n"
        << scenario_.sentences();
  }
  void expectArrival() {
    EXPECT_TRUE(scenario_.until(Seconds{240}, [&] { return scenario_.finished(); })) << scenario_.sentences();
    EXPECT_LT(scenario_.outcomes().front().metrics.endError.value(), 0.05);
    EXPECT_EQ(scenario_.outcomes().front().metrics.reversals, 0);
  }
  [[nodiscard]] static bool isFromHost(std::span<const std::uint8_t> packet) {
    return packet.size() > 3 && packet[3] == wire::kHostAddress;
  }

  /// The newest Cycle on the air that lets the vehicle drive; empty: none.
  [[nodiscard]] std::vector<std::uint8_t> newestDrive() {
    std::vector<std::uint8_t> drive;
    for (const auto& packet : scenario_.world().tap().heard()) {
      if (isCycle(packet) && wire::findEntry(payloadOf(packet), 1)->entry.mode == wire::CommandMode::Drive)
        drive = packet;
    }
    return drive;
  }
  /// As somebody without the keys would make it: the next counter, one byte changed, and a checksum that fits. A byte
  /// of the checksum itself: only the counter is another one.
  [[nodiscard]] std::vector<std::uint8_t> forgedFrom(std::vector<std::uint8_t> frame, std::size_t byte) {
    for (const auto& packet : scenario_.world().tap().heard()) {
      if (isFromHost(packet)) std::copy(packet.begin() + 5, packet.begin() + 7, frame.begin() + 5);
    }
    if (++frame[5] == 0) ++frame[6];
    constexpr std::size_t kMode = 9;
    frame[byte] ^= byte == kMode ? 0x03 : 0x01;  // Drive becomes Stop
    const std::size_t end = frame.size() - 2;
    const std::uint16_t crc = wire::crc16(wire::Bytes{frame}.subspan(1, end - 1));
    frame[end] = static_cast<std::uint8_t>(crc & 0xFF);
    frame[end + 1] = static_cast<std::uint8_t>(crc >> 8);
    return frame;
  }
  void stopAndStand() {
    scenario_.supervisor().post(supervisor::Stop{VehicleId{1}});
    scenario_.go(Seconds{3});
    ASSERT_LT(abs(scenario_.trueSpeed()), kStanding);
  }
  [[nodiscard]] static bool isCycle(std::span<const std::uint8_t> packet) {
    return isFromHost(packet) && packet[4] == static_cast<std::uint8_t>(wire::MessageType::Cycle) &&
           wire::findEntry(payloadOf(packet), 1);
  }
  [[nodiscard]] static wire::Bytes payloadOf(std::span<const std::uint8_t> packet) {
    return packet.subspan(7, packet.size() - wire::kFrameOverhead);
  }

  Scenario scenario_;
};

class OnAClearChannel : public Adversity {
protected:
  OnAClearChannel() : Adversity{lossless()} {}
  static ScenarioSetup lossless() {
    ScenarioSetup setup;
    setup.world.loss = 0;
    return setup;
  }
};

TEST_F(Adversity, aPulledPortStopsTheVehicleAndAReplacedOneLetsItGoOn) {
  driveHalfAMetre();
  const Seconds latest = lastCommandEnds();
  scenario_.lockstep().pullPort();
  expectStandstill(latest);
  expectSentence(EventKind::PortLost);
  EXPECT_EQ(scenario_.lockstep().snapshot()->port.state, supervisor::PortState::Lost);
  scenario_.lockstep().plugPort();
  expectSentence(EventKind::PortLost, true);
  expectArrival();
}

TEST_F(Adversity, aDeadVehicleIsCalledSilentAndGoesOnWhenItIsStartedAgain) {
  driveHalfAMetre();
  const Seconds latest = lastCommandEnds();
  ASSERT_TRUE(scenario_.world().kill(VehicleId{1}));
  expectStandstill(latest);
  expectSentence(EventKind::Silent);
  ASSERT_TRUE(scenario_.world().start(VehicleId{1}).has_value());
  // Both begin and end, each under its own name, whichever was noticed first.
  expectSentence(EventKind::Silent, true);
  expectSentence(EventKind::Restarted);
  expectSentence(EventKind::Restarted, true);
  expectArrival();
}

TEST_F(Adversity, aVehicleThatRestartsIsRecognisedAndGetsANewSession) {
  driveHalfAMetre();
  ASSERT_TRUE(scenario_.world().kill(VehicleId{1}));
  ASSERT_TRUE(scenario_.world().start(VehicleId{1}).has_value());
  expectSentence(EventKind::Restarted);
  expectArrival();
}

TEST_F(Adversity, garbageOnTheAirIsToldAndDisturbsNothing) {
  driveHalfAMetre();
  for (int burst = 0; burst < 20; ++burst) {
    scenario_.world().noise(200);
    scenario_.go(Seconds{0.5});
  }
  expectSentence(EventKind::DamagedFrames);
  expectArrival();
}

TEST_F(OnAClearChannel, aChangedByteIsNoticedWhereverItStandsInTheFrame) {
  driveHalfAMetre();
  const auto damage = [this] {
    const auto& channel = scenario_.lockstep().snapshot()->channel;
    return channel.damaged + channel.skippedBytes;
  };
  const auto changes = [this] { return scenario_.world().tap().counters().corrupted; };
  const auto before = damage();
  scenario_.go(Seconds{2});
  ASSERT_EQ(damage(), before) << "nothing else does damage";
  for (std::size_t byte = 0; byte < 40; ++byte) {
    const auto known = damage();
    const auto changed = changes() + 1;
    scenario_.world().tap().corruptNext(
        1, [](auto packet) { return !isFromHost(packet); }, byte);
    ASSERT_TRUE(scenario_.until(Seconds{3}, [&] { return changes() == changed; })) << "no report to change";
    EXPECT_TRUE(scenario_.until(Seconds{1}, [&] { return damage() > known; })) << "byte " << byte;
    scenario_.go(Seconds{0.2});  // the silence behind it has ended what looked like a frame
  }
  expectSentence(EventKind::DamagedFrames);
  EXPECT_EQ(scenario_.view().link.forged, 0U);  // the checksum already refuses it
  expectArrival();
}

TEST_F(Adversity, aChangedByteInACommandNeverMovesTheVehicle) {
  driveHalfAMetre();
  const Seconds latest = lastCommandEnds();
  scenario_.world().tap().corruptNext(1000, isFromHost, 20);
  expectStandstill(latest);
  scenario_.world().tap().corruptNext(0);
  expectArrival();
}

TEST_F(Adversity, aForgedCommandWithAFittingChecksumIsRefusedByTheVehicleAndTold) {
  driveHalfAMetre();
  const auto old = newestDrive();
  ASSERT_FALSE(old.empty());
  stopAndStand();
  const auto saysItIsForged = [this] { return (scenario_.view().faults & wire::kFaultForged) != 0; };
  ASSERT_FALSE(saysItIsForged());
  // The slot, each byte of the entry behind the vehicle's address, and the MAC; at last nothing but the counter.
  for (std::size_t byte = 7; byte < old.size() - 1; ++byte) {
    if (byte == 8) continue;
    // Nobody else may be on the air at that moment: try until it came through.
    bool told = false;
    for (int tries = 0; tries < 50 && !told; ++tries) {
      scenario_.world().inject(forgedFrom(old, byte));
      told = expectNoMove(Seconds{0.537}, saysItIsForged);
    }
    EXPECT_TRUE(told) << "with byte " << byte << " changed\n" << scenario_.sentences();
    ASSERT_TRUE(scenario_.until(Seconds{5}, [&] { return !saysItIsForged(); }));
  }
  EXPECT_THAT(scenario_.sentences(), testing::HasSubstr("refused a command that does not bear its key"));
  EXPECT_GT(scenario_.eventCount(EventKind::ForgedFrames), 0U) << scenario_.sentences();
  EXPECT_EQ(scenario_.eventCount(EventKind::ReplayedFrames), 0U) << scenario_.sentences();
}

TEST_F(Adversity, anOldCommandIsRefusedByTheVehicleAndTold) {
  driveHalfAMetre();
  const auto old = newestDrive();
  ASSERT_FALSE(old.empty());
  stopAndStand();
  // Nobody else may be on the air at that moment, or both would be lost: try until the vehicle has told of one.
  for (int tries = 0; tries < 200 && scenario_.eventCount(EventKind::ReplayedFrames) == 0; ++tries) {
    scenario_.world().inject(old);
    expectNoMove(Seconds{0.137});
  }
  EXPECT_GT(scenario_.eventCount(EventKind::ReplayedFrames), 0U) << scenario_.sentences();
  EXPECT_THAT(scenario_.sentences(), testing::HasSubstr("refused a command that it had seen before"));
}

TEST_F(Adversity, anOldReportIsRefusedByTheSupervisorAndTold) {
  driveHalfAMetre();
  std::vector<std::uint8_t> old;
  for (const auto& packet : scenario_.world().tap().heard()) {
    if (!isFromHost(packet) && packet[4] == 0x82) old = packet;
  }
  ASSERT_FALSE(old.empty());
  for (int tries = 0; tries < 200 && scenario_.eventCount(EventKind::ReplayedFrames) == 0; ++tries) {
    scenario_.world().inject(old);
    scenario_.go(Seconds{0.137});
  }
  EXPECT_GT(scenario_.eventCount(EventKind::ReplayedFrames), 0U) << scenario_.sentences();
  expectArrival();
}

TEST_F(Adversity, anObstacleStopsTheVehicleAndItGoesOnWhenTheWayIsFree) {
  driveHalfAMetre();
  // As broad as somebody's legs: the rangers look straight ahead from the front corners, and what is thinner than 11 cm
  // stands unseen between their cones at the stop distance.
  scenario_.world().addObstacle({{Metres{0.30}, Metres{1.35}}, Metres{0.10}});
  expectSentence(EventKind::Obstacle);  // the report with it comes while it brakes, or when it has
  expectItStandsBy(scenario_.lockstep().now() + toBrake());
  EXPECT_NE(scenario_.view().waits, "") << "the operator is not told why it waits";
  EXPECT_LT(distance(scenario_.view().predicted.position, scenario_.view().pose.position), Metres{0.002});
  scenario_.world().clearObstacles();
  expectSentence(EventKind::Obstacle, true);
  expectArrival();
}

TEST_F(Adversity, aDeadRangerStopsTheVehicleUntilItAnswersAgain) {
  driveHalfAMetre();
  auto& rangers = scenario_.world().body(VehicleId{1})->rangers();
  rangers.setDead(1, true);
  expectStandstill(scenario_.lockstep().now() + Seconds{6 * 0.08} + toBrake());  // at most six of its pings
  expectSentence(EventKind::Fault);
  EXPECT_EQ(scenario_.view().waits, "AGV 1 waits: one of its rangers does not answer.");
  rangers.setDead(1, false);
  expectSentence(EventKind::Fault, true);
  EXPECT_EQ(scenario_.eventCount(EventKind::Obstacle), 0U) << scenario_.sentences();
  expectArrival();
}

TEST_F(Adversity, aVehicleCarriedAwayIsFoundAgain) {
  driveHalfAMetre();
  ASSERT_TRUE(scenario_.world().push(VehicleId{1}, {Metres{0.45}, Metres{-0.2}}, Radians{0}));
  EXPECT_TRUE(scenario_.until(Seconds{240}, [&] { return scenario_.finished(); })) << scenario_.sentences();
  EXPECT_LT(scenario_.outcomes().front().metrics.endError.value(), 0.05);
}

TEST_F(Adversity, stopAllStandsEveryVehicleAndNothingMovesWithoutANewOrder) {
  driveHalfAMetre();
  const Seconds latest = lastCommandEnds();
  scenario_.supervisor().post(supervisor::StopAll{});
  expectStandstill(latest);
  expectNoMove(Seconds{10});
  EXPECT_FALSE(scenario_.finished());
}

}  // namespace
}  // namespace tessera::scenario
