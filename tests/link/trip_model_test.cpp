#include "link/trip_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "wire/airtime.h"

namespace tessera::link {
namespace {

// Round trips over a channel of which everything is known, with answers of any length.
class Way {
public:
  Way(double rate, double ofAir, double beside, std::uint32_t seed)
      : factor{ofAir}, extra{beside}, rate_{rate}, random_{seed} {}

  void measure(TripModel& model, int times, std::size_t shortest = 32, std::size_t longest = 58) {
    for (int i = 0; i < times; ++i) {
      const std::size_t back = std::uniform_int_distribution<std::size_t>{shortest, longest}(random_);
      const double air = wire::loRaAirtime(22, rate_) + wire::loRaAirtime(back, rate_);
      const double unsteady = std::uniform_real_distribution<>{-0.001, 0.001}(random_);
      model.measured(Seconds{air}, trip(air) + Seconds{unsteady});
    }
  }
  [[nodiscard]] Seconds trip(double air) const { return Seconds{factor * air + extra}; }
  [[nodiscard]] double usualAir() const { return wire::loRaAirtime(22, rate_) + wire::loRaAirtime(45, rate_); }
  [[nodiscard]] static Seconds expected(const TripModel& model, double air) {
    return Seconds{model.factor() * air} + model.extra();
  }

  double factor;
  double extra;

private:
  double rate_;
  std::mt19937 random_;
};

struct WayCase {
  double rate;
  double factor;
  double extra;
};

class AnyWay : public ::testing::TestWithParam<WayCase> {};

TEST_P(AnyWay, isTakenApartWhenLengthsDiffer) {
  const auto [rate, factor, extra] = GetParam();
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Way way{rate, factor, extra, seed};
    TripModel model;
    way.measure(model, 200);
    EXPECT_NEAR(model.factor(), factor, 0.15) << "seed " << seed;
    EXPECT_NEAR(model.extra().value(), extra, 0.15 * way.usualAir()) << "seed " << seed;
    EXPECT_LT(model.factorAtMost() - model.factor(), 0.25) << "seed " << seed;
  }
}

TEST_P(AnyWay, isForetoldAsAWholeFromTheBeginning) {
  const auto [rate, factor, extra] = GetParam();
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Way way{rate, factor, extra, seed};
    TripModel model;
    way.measure(model, 5);
    const double off = (Way::expected(model, way.usualAir()) - way.trip(way.usualAir())).value();
    EXPECT_LT(std::abs(off), 0.003 + 0.15 * factor * way.usualAir()) << "seed " << seed;
    way.measure(model, 100);
    EXPECT_NEAR(Way::expected(model, way.usualAir()).value(), way.trip(way.usualAir()).value(), 0.0015);
  }
}

TEST_P(AnyWay, hasItsFactorBelowWhatIsClaimed) {
  const auto [rate, factor, extra] = GetParam();
  int below = 0;
  int asked = 0;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    Way way{rate, factor, extra, seed};
    TripModel model;
    for (int round = 0; round < 10; ++round, ++asked) {
      way.measure(model, 10);
      below += factor <= model.factorAtMost() + 0.02 ? 1 : 0;
    }
  }
  EXPECT_GT(below, asked * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Ways, AnyWay,
                         ::testing::Values(WayCase{19200, 1.0, 0.0}, WayCase{19200, 1.0, 0.6}, WayCase{19200, 1.8, 0.1},
                                           WayCase{19200, 3.2, 1.0}, WayCase{9600, 1.8, 0.05}, WayCase{2400, 1.0, 0.0},
                                           WayCase{2400, 1.0, 0.2}, WayCase{2400, 3.2, 0.6}, WayCase{300, 3.2, 0.0}));

TEST(TripModel, givesTheFactorAllThatItCanHaveWhileAllLengthsAreAlike) {
  for (const double factor : {1.0, 1.8, 3.2}) {
    Way way{19200, factor, 0.0, 1};
    TripModel model;
    way.measure(model, 50, 40, 40);
    EXPECT_NEAR(model.factor(), factor, 0.05);
    EXPECT_LT(model.extra(), Seconds{0.002});
  }
}

TEST(TripModel, knowsTheSumWhereItCannotTellThePartsApart) {
  Way way{19200, 1.0, 0.6, 1};
  TripModel model;
  way.measure(model, 50, 40, 40);
  const double air = wire::loRaAirtime(22, 19200) + wire::loRaAirtime(40, 19200);
  EXPECT_NEAR(Way::expected(model, air).value(), way.trip(air).value(), 0.001);
  EXPECT_GT(model.factorAtMost(), 2.5) << "it claims to know what no measurement has told";
}

TEST(TripModel, isDeafToAnAnswerThatWasHeldOnTheWay) {
  Way way{19200, 1.8, 0.1, 3};
  TripModel model;
  way.measure(model, 60);
  const double factor = model.factor();
  const Seconds extra = model.extra();
  model.measured(Seconds{way.usualAir()}, way.trip(way.usualAir()) + Seconds{0.4});
  EXPECT_EQ(model.factor(), factor);
  EXPECT_EQ(model.extra(), extra);
  EXPECT_NEAR(model.late().value(), 0.4, 0.01) << "but the next may be as late";
  way.measure(model, 12);
  EXPECT_LT(model.late(), Seconds{0.001});
}

TEST(TripModel, followsAWayThatHasBecomeAnotherOne) {
  for (const double to : {0.0, 0.05, 1.0}) {
    Way way{19200, 1.8, 0.3, 4};
    TripModel model;
    way.measure(model, 60);
    way.extra = to;
    way.measure(model, 4);
    EXPECT_NEAR(Way::expected(model, way.usualAir()).value(), way.trip(way.usualAir()).value(), 0.005) << to;
    way.measure(model, 100);
    EXPECT_NEAR(model.factor(), 1.8, 0.15) << to;
    EXPECT_NEAR(model.extra().value(), to, 0.005) << to;
  }
}

TEST(TripModel, beginsAnewWhenItsFirstTripWasNoneOfTheWay) {
  Way way{19200, 1.0, 0.0, 5};
  TripModel model;
  model.measured(Seconds{way.usualAir()}, Seconds{2.0});
  way.measure(model, 40);
  EXPECT_NEAR(model.factor(), 1.0, 0.15);
  EXPECT_LT(model.extra(), Seconds{0.006});
}

TEST(TripModel, passesOverTripsOfAMachineThatSlept) {
  TripModel model;
  for (const double trip : {-5.0, 0.0, 1e9, std::numeric_limits<double>::quiet_NaN()})
    model.measured(Seconds{0.04}, Seconds{trip});
  EXPECT_FALSE(model.any());
}

TEST(TripModel, staysWithinItsBoundsWhateverItIsTold) {
  std::mt19937 random{7};
  TripModel model;
  const Seconds longest = TripModel::kLongestExtra + Seconds{TripModel::kLargestFactor * 0.6};
  for (int i = 0; i < 20000; ++i) {
    const double air = std::uniform_real_distribution<>{0.02, 0.6}(random);
    const double trip = std::exp(std::uniform_real_distribution<>{-7.0, 1.5}(random));
    model.measured(Seconds{air}, Seconds{trip});
    ASSERT_GE(model.factor(), TripModel::kSmallestFactor);
    ASSERT_LE(model.factor(), TripModel::kLargestFactor);
    ASSERT_GE(model.extra(), Seconds{});
    ASSERT_LE(model.extra(), longest);
    ASSERT_GE(model.factorAtMost(), model.factor());
    ASSERT_LE(model.deviation(), longest);
  }
}

}  // namespace
}  // namespace tessera::link
