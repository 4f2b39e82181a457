// What goes wrong on a shop floor, through real programs and a real serial port: the world is a process, the supervisor
// a thread with Qt's port. This file makes two programs: vehicles compiled for this machine, and emulated ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "system/supervision.h"
#include "system/wire_host.h"
#include "system/world.h"

namespace tessera::system_test {
namespace {

using supervisor::EventKind;

const std::string kPaper = TESSERA_SITES "/paper.tessera.json";
constexpr MetresPerSecond kSpeed{0.2};
// What a command of this machine's clock may be late: its way through the air, the braking from 0.2 m/s, and the pauses
// of a busy machine. The exact bound is tried in virtual time.
constexpr Seconds kSlack{0.6};

class Adversity : public ::testing::TestWithParam<std::string> {
protected:
  void begin(const std::vector<std::string>& further = {}) {
    std::vector<std::string> words{"--kind", GetParam()};
    words.insert(words.end(), further.begin(), further.end());
    world = std::make_unique<World>(folder, kPaper, words);
    ASSERT_NE(world->port(), "") << world->program().errors();
  }
  void drive() {
    begin();
    supervision = std::make_unique<Supervision>(kPaper, world->port());
    ASSERT_TRUE(supervision->drive(kSpeed, Metres{0.2})) << supervision->sentences() << world->program().errors();
  }
  /// Of the command that holds at the moment.
  [[nodiscard]] Seconds expiry() const {
    const auto command = supervision->view().command;
    EXPECT_TRUE(command && command->mode == wire::CommandMode::Drive && command->expiry > Seconds{});
    return command ? command->expiry : Seconds{};
  }
  void expectStandstill(Seconds since, Seconds expiry) {
    const Seconds moved = world->movedOnFor(since);
    RecordProperty("moved_on_for_s", std::to_string(moved.value()));
    EXPECT_LT(moved, expiry + kSlack) << "moved on for " << moved.value() << " s, the command for " << expiry.value()
                                      << " s\n"
                                      << supervision->sentences();
  }
  void expectSentence(EventKind kind, bool over = false) {
    EXPECT_TRUE(supervision->hears(kind, over)) << supervisor::nameOf(kind) << (over ? " over" : "") << " is not in\n"
                                                << supervision->sentences();
  }
  // Told once, and once that it is over. A pause of a busy machine may have torn a frame before.
  void expectDamageByOrder(const std::string& order) {
    const auto quiet = [&] {
      return supervision->told(EventKind::DamagedFrames) == supervision->told(EventKind::DamagedFrames, true);
    };
    ASSERT_TRUE(supervision->until(quiet)) << supervision->sentences();
    const int before = supervision->told(EventKind::DamagedFrames);
    ASSERT_TRUE(world->order(order)) << world->answer();
    EXPECT_TRUE(supervision->until([&] { return supervision->told(EventKind::DamagedFrames) > before; }))
        << "nobody noticed " << order << "\n"
        << supervision->sentences();
    EXPECT_TRUE(supervision->until(quiet)) << supervision->sentences();
    EXPECT_EQ(supervision->told(EventKind::DamagedFrames), before + 1) << supervision->sentences();
  }
  // Silence and restart begin and end each under its own name, whichever was noticed first.
  void expectItIsBackAfterARestart() {
    for (const bool over : {false, true}) {
      expectSentence(EventKind::Silent, over);
      expectSentence(EventKind::Restarted, over);
    }
  }
  // By itself: nobody orders anything again. Where the mishap took long, it may have gone on to the route's end.
  void expectItGoesOn() {
    const Point from = world->where();
    EXPECT_TRUE(supervision->until([&] {
      return supervision->view().finished || distance(world->where(), from) > Metres{0.25};
    })) << supervision->sentences();
    EXPECT_TRUE(supervision->until([&] { return supervision->connected(); })) << supervision->sentences();
  }

  QTemporaryDir folder;
  std::unique_ptr<World> world;
  std::unique_ptr<Supervision> supervision;
};

TEST_P(Adversity, aPulledPortStopsTheVehicleAndAReplacedOneLetsItGoOn) {
  ASSERT_NO_FATAL_FAILURE(drive());
  const Seconds given = expiry();
  const Seconds pulled = host::steadyNow();
  ASSERT_TRUE(world->order("pull")) << world->answer();
  expectSentence(EventKind::PortLost);
  EXPECT_EQ(supervision->port(), supervisor::PortState::Lost);
  expectStandstill(pulled, given);
  ASSERT_TRUE(world->order("plug")) << world->answer();
  expectSentence(EventKind::PortLost, true);
  expectItGoesOn();
  EXPECT_EQ(supervision->told(EventKind::PortLost), 1) << supervision->sentences();
}

TEST_P(Adversity, aDeadVehicleIsCalledSilentAndGoesOnWhenItIsStartedAgain) {
  ASSERT_NO_FATAL_FAILURE(drive());
  const Seconds given = expiry();
  const Seconds killed = host::steadyNow();
  ASSERT_TRUE(world->order("kill 1")) << world->answer();
  expectSentence(EventKind::Silent);
  expectStandstill(killed, given);
  ASSERT_TRUE(world->order("start 1")) << world->answer();
  expectItIsBackAfterARestart();
  expectItGoesOn();
}

TEST_P(Adversity, noiseDamageAndReplaysAreToldAndTheDriveGoesOn) {
  ASSERT_NO_FATAL_FAILURE(drive());
  expectDamageByOrder("noise 500");
  expectDamageByOrder("corrupt 5 from 1");  // its answers: a damaged command is dropped in silence
  // While it drives, question and answer follow so closely that what is repeated meets one of them, and both are lost;
  // the answer is waited for then, and the next repetition falls into that pause. It may get lost like anything else:
  // again after some more reports, until one came through.
  std::uint32_t next = 0;
  EXPECT_TRUE(supervision->until([&] {
    const auto reports = supervision->view().link.reports;
    if (reports >= next && world->order("replay 2 3")) next = reports + 3;
    return supervision->told(EventKind::ReplayedFrames) > 0;
  })) << supervision->sentences();
  EXPECT_THAT(supervision->sentences(), testing::HasSubstr("old frames"));
  expectItGoesOn();
}

TEST_P(Adversity, aRestartedVehicleCountsItsStartsOverPowerCutsAndRefusesWhatWasSaidBefore) {
  ASSERT_NO_FATAL_FAILURE(begin({"--loss", "0"}));
  const auto site = Supervision::mapOf(kPaper);
  std::uint32_t boot = 0;
  std::vector<std::uint8_t> old;
  {
    WireHost host{world->port(), site->site().vehicles.front()};
    const auto first = host.call();
    ASSERT_TRUE(first);
    old = host.command(wire::CommandMode::Drive, 150);
    host.say(old);
    ASSERT_TRUE(host.report());
    host.say(host.command(wire::CommandMode::Poll));
    auto report = host.report();
    ASSERT_TRUE(report);
    EXPECT_NE(report->state, wire::VehicleState::Standing) << "the command was a real one";
    ASSERT_TRUE(world->order("kill 1") && world->order("start 1"));
    const auto second = host.call();
    ASSERT_TRUE(second);
    EXPECT_EQ(second->boot, first->boot + 1);
    host.say(host.command(wire::CommandMode::Poll));
    ASSERT_TRUE(host.report());
    host.say(old);  // must stay without answer: a report would have the next number, and the next one fail
    host.say(host.command(wire::CommandMode::Poll));
    report = host.report();
    ASSERT_TRUE(report);
    EXPECT_EQ(report->state, wire::VehicleState::Standing);
    EXPECT_NE(report->faults & (wire::kFaultForged | wire::kFaultReplayed), 0);
    boot = second->boot;
  }
  ASSERT_TRUE(world->order("quit"));
  EXPECT_EQ(world->program().exitCode(), 0);
  ASSERT_NO_FATAL_FAILURE(begin({"--loss", "0"}));
  WireHost host{world->port(), site->site().vehicles.front()};
  const auto third = host.call();
  ASSERT_TRUE(third);
  EXPECT_EQ(third->boot, boot + 1) << "kept over the end of the world";
}

#ifdef TESSERA_EMULATED
TEST_P(Adversity, aVehicleWhoseEmulatorIsShotIsCalledSilentAndGoesOnWhenItIsStartedAgain) {
  ASSERT_NO_FATAL_FAILURE(drive());
  const int emulator = world->emulatorId();
  ASSERT_GT(emulator, 0);
  const Seconds given = expiry();
  const Seconds shot = host::steadyNow();
  ASSERT_EQ(::kill(emulator, SIGKILL), 0);
  expectSentence(EventKind::Silent);
  expectStandstill(shot, given);
  EXPECT_TRUE(world->program().complains("vehicle 1 ended by itself")) << world->program().errors();
  EXPECT_EQ(world->emulatorId(), 0);
  ASSERT_TRUE(world->order("start 1")) << world->answer();
  expectItIsBackAfterARestart();
  expectItGoesOn();
}
#endif

INSTANTIATE_TEST_SUITE_P(OfVehicles, Adversity, ::testing::Values(TESSERA_KIND),
                         [](const auto& tried) { return tried.param; });

}  // namespace
}  // namespace tessera::system_test
