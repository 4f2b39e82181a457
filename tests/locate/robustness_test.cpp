// What a locator has to bear: contradiction, carrying, wrong maps, lateness, nonsense.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "locate/filters.h"
#include "locate/synthetic_drive.h"

namespace tessera::test {
namespace {

using locate::Motion;
using locate::TagLeft;
using locate::TagRead;

Motion motionAt(double at, double travel, double speed = 0.1) {
  return {Seconds{at}, Metres{travel}, MetresPerSecond{speed}, Radians{}};
}

TEST(Robustness, knowsNothingBeforeTheFirstReadAndItsPlaceAfterIt) {
  const auto map = paperMap();
  const auto locator = kalman(map);
  EXPECT_FALSE(locator->at(Seconds{0.0}).located);
  locator->add(motionAt(0.0, 0.0, 0.0));
  EXPECT_FALSE(locator->at(Seconds{0.0}).located);
  const floor::PlacedTag tag = map->tags().front();
  locator->add(TagRead{1, tag.uid, Seconds{0.0}});
  const locate::Estimate e = locator->at(Seconds{0.0});
  EXPECT_TRUE(e.located);
  EXPECT_LT(distance(placeOf(e.pose, {Metres{0.15}, Metres{0.0}}), tag.place), Metres{0.06});
  EXPECT_LT(e.positionSigma(), Metres{0.06});
}

TEST(Robustness, aReadBeforeTheFirstMotionCountsOnceTheHeadingIsKnown) {
  const auto map = paperMap();
  const auto locator = kalman(map);
  locator->add(TagRead{1, map->tags().front().uid, Seconds{0.5}});
  EXPECT_FALSE(locator->at(Seconds{0.5}).located);
  locator->add(motionAt(0.6, 0.0, 0.0));
  locator->add(TagRead{1, map->tags().front().uid, Seconds{0.7}});
  EXPECT_TRUE(locator->at(Seconds{0.7}).located);
}

TEST(Robustness, putsALateReadWhereItBelongs) {
  const auto map = paperMap();
  const Pose start{{Metres{0.15}, Metres{0.3}}, Radians{}};
  std::optional<floor::TagUid> uid;
  map->forEachNear({Metres{0.375}, Metres{0.375}}, Metres{0.01}, [&](const floor::PlacedTag& t) { uid = t.uid; });
  ASSERT_TRUE(uid);
  const TagRead read{0, *uid, Seconds{0.25}};
  const TagLeft left{0, Seconds{1.25}};
  const auto inTime = kalman(map, start);
  const auto late = kalman(map, start);
  for (int i = 0; i <= 30; ++i) {
    const Motion motion = motionAt(0.1 * i, 0.01 * i);
    inTime->add(motion);
    late->add(motion);
    if (i == 3) inTime->add(read);
    if (i == 15) inTime->add(left);
  }
  const locate::Estimate before = late->at(Seconds{3.0});
  late->add(left);
  late->add(read);
  const locate::Estimate a = inTime->at(Seconds{3.0});
  const locate::Estimate b = late->at(Seconds{3.0});
  EXPECT_GT(distance(before.pose.position, b.pose.position), Metres{0.001}) << "the read must tell something";
  EXPECT_LT(distance(a.pose.position, b.pose.position), Metres{1e-9});
  EXPECT_LT((a.covariance - b.covariance).norm(), 1e-12);
}

TEST(Robustness, countsWhatItCannotUse) {
  const auto map = paperMap();
  const auto locator = kalman(map, Pose{{Metres{0.3}, Metres{0.3}}, Radians{}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  locator->add(motionAt(0.0, 0.0));
  locator->add(motionAt(10.0, 0.1));
  locator->add(motionAt(1.0, 0.05));
  locator->add(motionAt(nan, 0.1));
  locator->add(TagRead{1, *floor::TagUid::parse("DEADBEEF"), Seconds{10.0}});
  locator->add(TagRead{7, map->tags().front().uid, Seconds{10.0}});
  locator->add(TagRead{1, map->tags().front().uid, Seconds{nan}});
  locator->add(TagRead{1, map->tags().front().uid, Seconds{2.0}});
  EXPECT_EQ(locator->counters().reads, 4U);
  EXPECT_EQ(locator->counters().unknownTags, 1U);
  EXPECT_EQ(locator->counters().invalid, 3U);
  EXPECT_EQ(locator->counters().tooLate, 2U);
}

TEST(Robustness, isTheSameEveryTime) {
  const auto map = paperMap();
  DriveOptions options;
  options.shuffled = true;
  const auto once = kalman(map);
  const auto again = kalman(map);
  const auto a = drive(*map, paperVehicle(), map->route("paper")->vertices, options, *once);
  const auto b = drive(*map, paperVehicle(), map->route("paper")->vertices, options, *again);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].estimate.pose, b[i].estimate.pose);
    EXPECT_EQ(a[i].estimate.covariance, b[i].estimate.covariance);
  }
}

// Normalised squared error of the place: 2 on average when the covariance tells the truth.
TEST(Robustness, claimsNoMoreCertaintyThanItHas) {
  const auto map = paperMap();
  double sum = 0.0;
  int count = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.speedNoise = 0.05;
    const auto locator = kalman(map);
    for (const Sample& s : drive(*map, paperVehicle(), map->route("paper")->vertices, options, *locator)) {
      if (s.at < 5.0) continue;
      const Offset off = s.truth.position - s.estimate.pose.position;
      const Eigen::Vector2d e{off.x.value(), off.y.value()};
      sum += e.dot(s.estimate.covariance.topLeftCorner<2, 2>().ldlt().solve(e));
      ++count;
    }
  }
  std::printf("normalised squared error of the place: %.2f (2 is honest)\n", sum / count);
  EXPECT_LT(sum / count, 3.0);
  EXPECT_GT(sum / count, 0.3);
}

void expectSound(const locate::Estimate& e, std::uint32_t seed) {
  ASSERT_TRUE(e.covariance.allFinite()) << "seed " << seed;
  ASSERT_TRUE(std::isfinite(e.pose.position.x.value() + e.pose.position.y.value() + e.pose.heading.value() +
                            e.headingBias.value() + e.speed.value() + e.turnRate.value()))
      << "seed " << seed;
  if (!e.located) return;
  ASSERT_LT((e.covariance - e.covariance.transpose()).norm(), 1e-12) << "seed " << seed;
  ASSERT_EQ(Eigen::LLT<Eigen::Matrix3d>(e.covariance).info(), Eigen::Success) << "seed " << seed;
}

TEST(Robustness, staysSoundUnderRandomObservations) {
  const auto map = paperMap();
  for (const std::string_view name : locate::locatorNames()) {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
      std::mt19937 random{seed};
      std::uniform_real_distribution<double> unit;
      const auto locator = locate::makeLocator(name, map, paperVehicle()).value();
      double now = 0.0;
      double travel = 0.0;
      double heading = 0.0;
      for (int i = 0; i < 600; ++i) {
        now += 0.2 * unit(random);
        travel += 0.05 * (unit(random) - 0.2);
        heading += unit(random) - 0.5;
        const double at = now - (unit(random) < 0.3 ? 6.0 * unit(random) : 0.0);
        const double kind = unit(random);
        const int reader = static_cast<int>(unit(random) * 5) - 1;
        const auto& tags = map->tags();
        const floor::TagUid uid =
            tags[static_cast<std::size_t>(unit(random) * 0.999 * static_cast<double>(tags.size()))].uid;
        const double wild = unit(random) < 0.02 ? 1e6 * (unit(random) - 0.5) : 0.0;
        if (kind < 0.5)
          locator->add(
              Motion{Seconds{at}, Metres{travel + wild}, MetresPerSecond{0.3 * unit(random)}, Radians{heading + wild}});
        else if (kind < 0.8)
          locator->add(TagRead{reader, uid, Seconds{at}});
        else if (kind < 0.98)
          locator->add(TagLeft{reader, Seconds{at}});
        else
          locator->reset(kind < 0.99 ? std::optional<Pose>{Pose{}} : std::nullopt);
        expectSound(locator->at(Seconds{now + unit(random) - 0.5}), seed);
      }
    }
  }
}

TEST(Factory, namesWhatItKnowsAndRefusesTheRest) {
  const auto map = paperMap();
  for (const std::string_view name : locate::locatorNames())
    EXPECT_EQ((*locate::makeLocator(name, map, paperVehicle()))->name(), name);
  const auto unknown = locate::makeLocator("oracle", map, paperVehicle());
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().sentence, "There is no locator \"oracle\"; there are: particles, kalman, tag-centre.");
  EXPECT_FALSE(locate::makeLocator("kalman", map, paperVehicle(0)));
  EXPECT_FALSE(locate::makeLocator("kalman", nullptr, paperVehicle()));
}

}  // namespace
}  // namespace tessera::test
