// What is told of the vehicle that somebody watches.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "base/polyline.h"
#include "supervisor/locating_view.h"
#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

using test::SupervisorRig;

TEST(Watching, tellsHowTheVehicleIsLocatedAndLed) {
  SupervisorRig rig;
  rig.runRoute(1, "paper", 0.12);
  ASSERT_TRUE(rig.runUntil([&] { return rig.last && rig.view(1).progress > Metres{0.3}; }, Seconds{30}));
  EXPECT_EQ(rig.last->watched, nullptr) << "nobody asked";
  rig.supervisor.post(Watch{VehicleId{1}});
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).progress > Metres{1.0}; }, Seconds{30}));
  ASSERT_NE(rig.last->watched, nullptr);
  const LocatingView& v = *rig.last->watched;
  EXPECT_EQ(v.vehicle, VehicleId{1});
  EXPECT_EQ(v.locator, "particles");
  EXPECT_TRUE(v.located);
  ASSERT_EQ(v.guesses.size(), LocatingView::kGuesses);
  // Their mean is the estimate, their spread its covariance.
  double x = 0.0;
  double xx = 0.0;
  for (const Point& p : v.guesses) {
    x += p.x.value() / LocatingView::kGuesses;
    xx += (p.x - v.estimate.position.x).value() * (p.x - v.estimate.position.x).value() / LocatingView::kGuesses;
  }
  EXPECT_NEAR(x, v.estimate.position.x.value(), 0.003);
  EXPECT_NEAR(std::sqrt(xx), std::sqrt(v.covariance[0]), 0.3 * std::sqrt(v.covariance[0]));
  EXPECT_EQ(v.motion.at, v.at);
  EXPECT_NEAR(v.motion.speed.value(), 0.12, 0.03);
  // Where it goes meanwhile.
  EXPECT_LE(v.at, rig.last->time);
  EXPECT_GT(v.effectiveAt, rig.last->time);
  EXPECT_GT(v.hold, Seconds{0.02});
  ASSERT_EQ(v.way.size(), LocatingView::kWay + 1);
  EXPECT_EQ(v.way.front(), v.estimate);
  EXPECT_EQ(v.way.back(), v.predicted);
  EXPECT_NEAR(distance(v.predicted.position, v.estimate.position).value(), 0.12 * v.delay().value(), 0.015);
  ASSERT_TRUE(v.aim);
  const Polyline line{rig.map->route("paper")->vertices};
  EXPECT_LT(std::abs(line.project(*v.aim).across.value()), 0.01) << "on the route";
  EXPECT_GT(distance(*v.aim, v.predicted.position), Metres{0.05});
  // What reads have said since.
  ASSERT_GT(v.innovations.size(), 3U);
  for (const locate::Innovation& i : v.innovations) {
    EXPECT_GE(i.nis, 0.0);
    EXPECT_LT(std::abs(i.ahead.value()) + std::abs(i.aside.value()), 0.2);
  }
  EXPECT_EQ(v.innovations.back().at, rig.view(1).recentReads.back().at);
  EXPECT_LE(v.innovations.size(), LocatingView::kInnovations);
}

// How much more is claimed along the way than across it since the report was made; m², on average.
double doubtOfTime(const test::FakeAir::Options& options) {
  SupervisorRig rig{"paper.tessera.json", options};
  rig.supervisor.post(Watch{VehicleId{1}});
  rig.runRoute(1, "paper", 0.2);
  double sum = 0.0;
  int count = 0;
  const bool came = rig.runUntil(
      [&] {
        if (!rig.last || !rig.last->watched || rig.view(1).speed < MetresPerSecond{0.15}) return false;
        const double heading = rig.view(1).pose.heading.value();
        const Eigen::Vector2d along{std::cos(heading), std::sin(heading)};
        const auto excess = [&](const std::array<double, 9>& c) {
          const Eigen::Matrix2d m{{c[0], c[1]}, {c[3], c[4]}};
          const Eigen::Vector2d across{-along.y(), along.x()};
          return along.dot(m * along) - across.dot(m * across);
        };
        sum += excess(rig.view(1).covariance) - excess(rig.last->watched->covariance);
        return ++count >= 150;
      },
      Seconds{60});
  EXPECT_TRUE(came);
  return sum / count;
}

TEST(Timing, isDoubtedAlongTheWayWhereTheLinkIsUnsteady) {
  test::FakeAir::Options options;
  // The doubts of heading and scale lead aside and along on what was driven since, whatever the link is like.
  const double steady = doubtOfTime(options);
  EXPECT_LT(std::abs(steady), 0.007 * 0.007);
  options.jitter = Seconds{0.2};  // evenly spread: a deviation of 58 ms each way, 1.2 cm at 20 cm/s
  const double doubt = std::sqrt(std::max(0.0, doubtOfTime(options) - steady));
  EXPECT_GT(doubt, 0.007);
  EXPECT_LT(doubt, 0.020);
}

TEST(Watching, isOfOneVehicleAtATime) {
  SupervisorRig rig{"three.tessera.json"};
  rig.run(Seconds{3});
  for (const std::uint8_t id : {std::uint8_t{2}, std::uint8_t{3}}) {
    rig.supervisor.post(Watch{VehicleId{id}});
    rig.run(Seconds{0.2});
    ASSERT_NE(rig.last->watched, nullptr);
    EXPECT_EQ(rig.last->watched->vehicle, VehicleId{id});
    EXPECT_FALSE(rig.last->watched->aim) << "it stands";
  }
  const auto kept = rig.last;
  rig.supervisor.post(Watch{});
  rig.run(Seconds{0.2});
  EXPECT_EQ(rig.last->watched, nullptr);
  EXPECT_EQ(kept->watched->vehicle, VehicleId{3}) << "a snapshot stays what it is";
  rig.supervisor.post(Watch{VehicleId{77}});
  rig.run(Seconds{0.2});
  EXPECT_EQ(rig.last->watched, nullptr);
}

TEST(Watching, changesNothingOfWhatIsDone) {
  std::vector<std::uint8_t> wrote[2];
  for (int i = 0; i < 2; ++i) {
    SupervisorRig rig;
    if (i == 1) rig.supervisor.post(Watch{VehicleId{1}});
    rig.runRoute(1, "paper", 0.12);
    rig.run(Seconds{15});
    wrote[i] = rig.wrote;
  }
  EXPECT_EQ(wrote[0], wrote[1]);
}

}  // namespace
}  // namespace tessera::supervisor
