// The particle locator and its parts. What it has in common with the others stands in robustness_test.cpp.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "locate/counter_random.h"
#include "locate/filters.h"
#include "locate/kalman_locator.h"
#include "locate/poll_clock.h"
#include "locate/synthetic_drive.h"

namespace tessera::test {
namespace {

using locate::Motion;
using locate::ParticleLocator;
using locate::TagLeft;
using locate::TagRead;

Motion movedTo(double at, double travel) { return {Seconds{at}, Metres{travel}, MetresPerSecond{0.1}, Radians{}}; }

struct Figures {
  double mean = 0.0;
  double nees = 0.0;
};

template <class Make>
Figures figuresOf(DriveOptions options, Make make) {
  const auto map = paperMap();
  Figures figures;
  int count = 0;
  for (options.seed = 1; options.seed <= 10; ++options.seed) {
    const auto locator = make(map);
    for (const Sample& s : drive(*map, paperVehicle(), map->route("paper")->vertices, options, *locator)) {
      if (s.at < 5.0) continue;
      const Offset off = s.truth.position - s.estimate.pose.position;
      const Eigen::Vector2d e{off.x.value(), off.y.value()};
      figures.mean += e.norm();
      figures.nees += e.dot(s.estimate.covariance.topLeftCorner<2, 2>().ldlt().solve(e));
      ++count;
    }
  }
  return {figures.mean / count, figures.nees / count};
}

Figures kalmanFigures(const DriveOptions& options) {
  return figuresOf(options,
                   [](const auto& map) { return std::make_unique<locate::KalmanLocator>(map, paperVehicle()); });
}
Figures particleFigures(const DriveOptions& options) {
  return figuresOf(options, [](const auto& map) { return particles(map); });
}

TEST(Particles, areNearerToTheTruthThanTheKalmanFilterAndHonest) {
  DriveOptions usual, slow, good;
  slow.pollPeriod = 0.2;
  good.speedNoise = 0.02;
  for (const DriveOptions& options : {usual, slow, good}) {
    const Figures kalman = kalmanFigures(options);
    const Figures here = particleFigures(options);
    std::printf("polls %.1f s, odometer noise %2.0f %%: kalman %.2f cm, particles %.2f cm, NEES %.2f\n",
                options.pollPeriod, 100 * options.speedNoise, 100 * kalman.mean, 100 * here.mean, here.nees);
    EXPECT_LT(here.mean, 0.95 * kalman.mean);
    EXPECT_GT(here.nees, 0.5);
    EXPECT_LT(here.nees, 2.5);
  }
}

TEST(Particles, learnFromSilence) {
  // The same drive with the silence kept from it.
  class Deaf final : public locate::Locator {
  public:
    explicit Deaf(const std::shared_ptr<const floor::SiteMap>& map) : inner_{particles(map)} {}
    void add(const Motion& motion) override { inner_->add(motion); }
    void add(const TagRead& read) override { inner_->add(read); }
    void add(const TagLeft& left) override { inner_->add(left); }
    [[nodiscard]] locate::Estimate at(Seconds now) const override { return inner_->at(now); }
    [[nodiscard]] Seconds lastMotion() const override { return inner_->lastMotion(); }
    void reset(std::optional<Pose> pose) override { inner_->reset(pose); }
    void useMap(std::shared_ptr<const floor::SiteMap> map) override { inner_->useMap(std::move(map)); }
    [[nodiscard]] const locate::LocatorCounters& counters() const override { return inner_->counters(); }
    [[nodiscard]] std::string_view name() const override { return "deaf"; }

  private:
    std::unique_ptr<ParticleLocator> inner_;
  };
  const Figures deaf = figuresOf({}, [](const auto& map) { return std::make_unique<Deaf>(map); });
  EXPECT_LT(particleFigures({}).mean, 0.9 * deaf.mean);
}

TEST(Particles, learnMoreFromAReadIfTheSilenceBeforeItIsToldFirst) {
  // Where on its disc's edge a reader met the tag, only the silence says.
  DriveOptions inOrder;
  inOrder.reportPeriod = 0.4;
  DriveOptions silenceLast = inOrder;
  silenceLast.silenceLast = true;
  EXPECT_LT(particleFigures(inOrder).mean, 0.95 * particleFigures(silenceLast).mean);
}

TEST(Particles, bearTagsThatAnswerNobody) {
  // A fifth of the tags is dead: their silence must not push the estimate away.
  floor::Site site = paperSite();
  int n = 0;
  for (floor::Tile& tile : site.tiles)
    for (floor::TagUid& uid : tile.uids)
      if (n++ % 5 == 2) uid = floor::TagUid{};
  const auto alive = floor::SiteMap::build(site).value();
  ASSERT_LT(alive->tags().size(), paperMap()->tags().size());
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    DriveOptions options;
    options.seed = seed;
    const auto locator = particles(paperMap());
    const auto samples = drive(*alive, paperVehicle(), paperMap()->route("paper")->vertices, options, *locator);
    EXPECT_LT(summarise(samples, 5.0).mean, 0.02) << "seed " << seed;
  }
}

TEST(Particles, putALateReadWhereItBelongs) {
  const auto map = paperMap();
  const Pose start{{Metres{0.15}, Metres{0.3}}, Radians{}};
  std::optional<floor::TagUid> uid;
  map->forEachNear({Metres{0.375}, Metres{0.375}}, Metres{0.01}, [&](const floor::PlacedTag& t) { uid = t.uid; });
  ASSERT_TRUE(uid);
  const TagRead read{0, *uid, Seconds{0.25}};
  const TagLeft left{0, Seconds{1.25}};
  const auto inTime = particles(map, start);
  const auto late = particles(map, start);
  for (int i = 0; i <= 30; ++i) {
    const Motion motion = movedTo(0.1 * i, 0.01 * i);
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
  EXPECT_GT(distance(before.pose.position, a.pose.position), Metres{0.01}) << "the read must tell something";
  EXPECT_LT(distance(a.pose.position, b.pose.position), Metres{0.008});
}

TEST(Particles, countWhatTheyCannotUse) {
  const auto map = paperMap();
  const auto locator = particles(map, Pose{{Metres{0.3}, Metres{0.3}}, Radians{}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  locator->add(movedTo(0.0, 0.0));
  locator->add(movedTo(10.0, 0.1));
  locator->add(movedTo(1.0, 0.05));
  locator->add(movedTo(nan, 0.1));
  locator->add(TagRead{1, *floor::TagUid::parse("DEADBEEF"), Seconds{10.0}});
  locator->add(TagRead{7, map->tags().front().uid, Seconds{10.0}});
  locator->add(TagRead{1, map->tags().front().uid, Seconds{nan}});
  locator->add(TagRead{1, map->tags().front().uid, Seconds{2.0}});
  EXPECT_EQ(locator->counters().reads, 4U);
  EXPECT_EQ(locator->counters().unknownTags, 1U);
  EXPECT_EQ(locator->counters().invalid, 3U);
  EXPECT_EQ(locator->counters().tooLate, 2U);
}

TEST(Particles, sayThatTheyDoubtTheirPlaceAndHowFarFromTheFirstTagThatSpeaksForAnother) {
  const auto map = paperMap();
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    DriveOptions options;
    options.seed = seed;
    const auto undisturbed = drive(*map, paperVehicle(), map->route("paper")->vertices, options, *particles(map));
    EXPECT_TRUE(
        std::none_of(undisturbed.begin(), undisturbed.end(), [](const Sample& s) { return s.estimate.doubted; }))
        << "seed " << seed;
    options.carriedAt = 5.0;
    const auto carried = drive(*map, paperVehicle(), map->route("paper")->vertices, options, *particles(map));
    const auto wrong = [](const Sample& s) {
      return distance(s.estimate.pose.position, s.truth.position) > Metres{0.2};
    };
    const auto first = std::find_if(carried.begin(), carried.end(), [](const Sample& s) { return s.estimate.doubted; });
    if (first == carried.end()) continue;  // a second tag came with the same report and decided
    EXPECT_TRUE(wrong(*first)) << "seed " << seed;
    EXPECT_GT(first->estimate.positionSigma(), Metres{0.05}) << "seed " << seed;
    EXPECT_FALSE(carried.back().estimate.doubted) << "seed " << seed;
  }
}

TEST(Particles, areTheSameEveryTime) {
  const auto map = paperMap();
  const auto once = particles(map);
  const auto again = particles(map);
  const auto a = drive(*map, paperVehicle(), map->route("paper")->vertices, {}, *once);
  const auto b = drive(*map, paperVehicle(), map->route("paper")->vertices, {}, *again);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].estimate.pose, b[i].estimate.pose);
    ASSERT_EQ(a[i].estimate.covariance, b[i].estimate.covariance);
  }
}

TEST(PollClock, learnsHowOftenReadersTry) {
  locate::CounterRandom random{3};
  for (const double period : {0.05, 0.1, 0.2, 0.4}) {
    locate::PollClock clock;
    EXPECT_EQ(clock.period(), locate::PollClock::kUsual);
    for (int i = 0; i < 12; ++i) {
      const double attempts = 1.0 + std::floor(std::min(4.0, 0.8 / period) * random.uniform());
      clock.visit(attempts * period + 0.006 * (random.uniform() - 0.5));
    }
    EXPECT_NEAR(clock.period(), period, 0.06 * period);
  }
}

TEST(CounterRandom, isNormalAndTheSameForTheSameKey) {
  locate::CounterRandom random{1}, same{1}, other{2};
  double sum = 0.0, squares = 0.0;
  int different = 0;
  for (int i = 0; i < 100000; ++i) {
    const double v = random.normal();
    EXPECT_EQ(v, same.normal());
    different += v != other.normal();
    sum += v;
    squares += v * v;
  }
  EXPECT_NEAR(sum / 100000, 0.0, 0.01);
  EXPECT_NEAR(squares / 100000, 1.0, 0.01);
  EXPECT_GT(different, 99000);
}

}  // namespace
}  // namespace tessera::test
