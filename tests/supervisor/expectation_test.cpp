// What is expected of a vehicle when commands may have been lost on the air.
#include "supervisor/expectation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

using test::SupervisorRig;

drive::Command go(double speed, double heading = 0.0) { return {MetresPerSecond{speed}, Radians{heading}}; }

double sumOf(const std::vector<CommandHistory::Case>& cases) {
  return std::accumulate(cases.begin(), cases.end(), 0.0,
                         [](double sum, const CommandHistory::Case& c) { return sum + c.chance; });
}

TEST(CommandHistory, letsALaterCommandTakeOver) {
  CommandHistory history;
  history.drive(go(0.1), Seconds{1.0}, Seconds{0.5}, 1);
  history.drive(go(0.2), Seconds{1.2}, Seconds{0.5}, 2);
  const auto commands = history.cases().front().commands;
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_EQ(commands[0].until, Seconds{1.2});
  EXPECT_EQ(commands[1].until, Seconds{1.7});
}

TEST(CommandHistory, endsACommandWithAStopButProlongsNone) {
  CommandHistory history;
  history.drive(go(0.1), Seconds{1.0}, Seconds{0.5}, 1);
  history.stand(Seconds{3.0}, 2);
  EXPECT_EQ(history.cases().front().commands[0].until, Seconds{1.5});
  history.stand(Seconds{1.1}, 3);
  EXPECT_EQ(history.cases().front().commands[0].until, Seconds{1.1});
  EXPECT_TRUE(history.holdsAfter(Seconds{1.0})) << "until the Stop, and beyond if that is lost";
  EXPECT_FALSE(history.holdsAfter(Seconds{1.5}));
}

TEST(CommandHistory, staysSortedWhenTheLatencyIsMeasuredAnew) {
  CommandHistory history;
  history.drive(go(0.1), Seconds{1.0}, Seconds{0.5}, 1);
  history.drive(go(0.2), Seconds{0.9}, Seconds{0.5}, 2);
  const auto commands = history.cases().front().commands;
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].command.speed, MetresPerSecond{0.2});
}

TEST(CommandHistory, doesNotGrowWithoutEnd) {
  CommandHistory history;
  for (int i = 0; i < 10000; ++i) history.drive(go(0.1, 0.1 * i), Seconds{0.1 * i}, Seconds{0.4}, i);
  EXPECT_LT(history.cases().front().commands.size(), 100U);
  EXPECT_LE(history.cases().size(), 8U);
  EXPECT_NEAR(sumOf(history.cases()), 1.0, 1e-9);
}

TEST(CommandHistory, takesACommandWithoutAnswerForLostAsLikelyAsNot) {
  CommandHistory history;
  history.drive(go(0.1), Seconds{1.0}, Seconds{1.5}, 1);
  history.taken(1);
  EXPECT_EQ(history.cases().size(), 1U);
  history.stand(Seconds{1.4}, 2);
  ASSERT_EQ(history.cases().size(), 2U) << "under way";
  EXPECT_GT(history.cases()[0].chance, 0.9);
  EXPECT_NEAR(sumOf(history.cases()), 1.0, 1e-12);
  history.unanswered(2);
  const auto cases = history.cases();
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_NEAR(cases[0].chance, 0.5, 1e-12);
  EXPECT_EQ(cases[0].commands.back().until, Seconds{1.4});
  EXPECT_EQ(cases[1].commands.back().until, Seconds{2.5}) << "it drives on";
  history.taken(2);
  EXPECT_EQ(history.cases().size(), 1U) << "the answer was late";
}

TEST(CommandHistory, doesNotAskWhetherACommandWasLostThatChangesNothing) {
  CommandHistory history;
  history.drive(go(0.1), Seconds{1.0}, Seconds{1.5}, 1);
  history.taken(1);
  history.drive(go(0.1, 0.01), Seconds{1.4}, Seconds{1.5}, 2);
  history.unanswered(2);
  EXPECT_EQ(history.cases().size(), 1U);
}

TEST(CommandHistory, takesARepeatedCommandForLostAsWellWhereTheFirstMayBe) {
  CommandHistory history;
  history.drive(go(0.1), Seconds{1.0}, Seconds{1.5}, 1);
  history.taken(1);
  for (std::uint32_t i = 2; i <= 3; ++i) {
    history.drive(go(0.0, 1.0), Seconds{0.4 + 0.5 * i}, Seconds{1.5}, i);
    history.unanswered(i);
  }
  const auto cases = history.cases();
  ASSERT_EQ(cases.size(), 4U);
  EXPECT_NEAR(sumOf(cases), 1.0, 1e-12);
  const auto straightOn = [](const CommandHistory::Case& c) { return c.commands.size() == 1; };
  const auto both = std::find_if(cases.begin(), cases.end(), straightOn);
  ASSERT_NE(both, cases.end()) << "both lost: it drives on as before";
  EXPECT_NEAR(both->chance, 0.25, 1e-12);
}

TEST(CommandHistory, learnsHowManyAreLost) {
  CommandHistory good;
  CommandHistory bad;
  for (std::uint32_t i = 0; i < 200; ++i) {
    good.drive(go(0.1), Seconds{0.1 * i}, Seconds{0.4}, i);
    good.taken(i);
    bad.drive(go(0.1), Seconds{0.1 * i}, Seconds{0.4}, i);
    i % 3 == 0 ? bad.unanswered(i) : bad.taken(i);
  }
  good.stand(Seconds{20.0}, 300);
  bad.taken(199);
  bad.stand(Seconds{20.0}, 300);
  EXPECT_GT(good.cases().front().chance, 0.98);
  EXPECT_LT(bad.cases().front().chance, 0.9);
  EXPECT_GT(bad.cases().front().chance, 0.75);
}

TEST(Expectation, liesBetweenWhatMayHaveHappenedAndSpansIt) {
  drive::VehicleState known;
  known.speed = MetresPerSecond{0.2};
  CommandHistory history;
  history.drive(go(0.2), Seconds{0.0}, Seconds{5.0}, 1);
  history.taken(1);
  history.stand(Seconds{0.1}, 2);
  history.unanswered(2);
  const drive::VehicleAbility ability;
  const auto cases = history.cases();
  ASSERT_EQ(cases.size(), 2U);
  const Seconds until{2.0};
  const double stopped = drive::predict(known, cases[0].commands, until, ability).pose.position.x.value();
  const double driving = drive::predict(known, cases[1].commands, until, ability).pose.position.x.value();
  EXPECT_NEAR(driving, 0.4, 0.01);
  EXPECT_LT(stopped, 0.1);
  const Expectation e = expectedOver(known, cases, until, ability);
  EXPECT_NEAR(e.state.pose.position.x.value(), 0.5 * (stopped + driving), 1e-6);
  EXPECT_NEAR(std::sqrt(e.spread(0, 0)), 0.5 * (driving - stopped), 1e-6);
  EXPECT_NEAR(e.spread(1, 1), 0.0, 1e-9);
}

TEST(Expectation, claimsNoMoreThanIsKnownWhenTheRadioFallsSilentAsAVehicleStarts) {
  SupervisorRig rig;
  rig.runRoute(1, "paper", 0.2);
  ASSERT_TRUE(rig.runUntil([&] { return rig.last && rig.view(1).speed > MetresPerSecond{0.15}; }, Seconds{30}));
  rig.air->options().loss = 1.0;
  rig.supervisor.post(Stop{VehicleId{1}});
  double worst = 0.0;
  double error = 0.0;
  const Seconds until = rig.air->now + Seconds{0.9};
  rig.runUntil(
      [&] {
        const double off = distance(rig.view(1).pose.position, rig.vehicles[0]->pose.position).value();
        const auto& c = rig.view(1).covariance;
        error = std::max(error, off);
        worst = std::max(worst, off / std::sqrt(c[0] + c[4]));
        return rig.air->now >= until;
      },
      Seconds{5});
  EXPECT_GT(error, 0.03) << "it drives on, while it was told to stop";
  EXPECT_LT(worst, 3.0) << "deviations";
}

}  // namespace
}  // namespace tessera::supervisor
