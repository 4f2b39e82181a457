#include "link/air_timing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "wire/airtime.h"
#include "wire/messages.h"

namespace tessera::link {
namespace {

TEST(LoRaAirtime, givesTheDataSheetsFigures) {
  EXPECT_NEAR(wire::loRaAirtime(12, 19200), 0.010, 0.0005);
  EXPECT_NEAR(wire::loRaAirtime(58, 19200), 0.028, 0.0005);
  EXPECT_NEAR(wire::loRaAirtime(12, 9600), 0.021, 0.0005);
  EXPECT_NEAR(wire::loRaAirtime(58, 9600), 0.049, 0.0008);
  EXPECT_NEAR(wire::loRaAirtime(12, 2400), 0.144, 0.001);
  EXPECT_NEAR(wire::loRaAirtime(58, 2400), 0.308, 0.001);
}

// A round trip on a channel with a known factor.
Seconds roundTrip(double factor, std::size_t there, std::size_t back, double rate, int baud) {
  const double byte = 10.0 / baud;
  const double fixed = 2 * 0.005 + (2.0 * static_cast<double>(there + back) + 6.0) * byte;
  return Seconds{fixed + factor * (wire::loRaAirtime(there, rate) + wire::loRaAirtime(back, rate))};
}

TEST(AirTiming, findsTheFactorOfTheChannel) {
  for (const double factor : {1.0, 1.8, 3.2}) {
    AirTiming timing{19200, 115200};
    for (int i = 0; i < 20; ++i) timing.measured(22, 40, roundTrip(factor, 22, 40, 19200, 115200));
    EXPECT_NEAR(timing.factor(), factor, 0.01);
    EXPECT_GE(timing.oneWayAtMost(58), timing.oneWay(58));
  }
}

TEST(AirTiming, isReadyForTheSlowestModuleBeforeAnyMeasurement) {
  const AirTiming timing{19200, 115200};
  EXPECT_GE(timing.oneWayAtMost(58).value(), 3.2 * wire::loRaAirtime(58, 19200));
}

TEST(AirTiming, keepsTwoFullPacketsApart) {
  AirTiming timing{19200, 115200};
  for (int i = 0; i < 50; ++i) timing.measured(22, 40, roundTrip(1.8, 22, 40, 19200, 115200));
  EXPECT_GT(timing.slotUnits() * wire::kSlotUnitMs, 1000 * 1.8 * wire::loRaAirtime(58, 19200));
  EXPECT_LT(timing.slotUnits() * wire::kSlotUnitMs, 1000 * 2.5 * wire::loRaAirtime(58, 19200));
}

TEST(AirTiming, pollsOneVehicleAtATimeWhereASlotWouldNotFitItsField) {
  EXPECT_EQ(AirTiming(300, 9600).maxEntries(), 1U);
  EXPECT_EQ(AirTiming(19200, 115200).maxEntries(), wire::kMaxCycleEntries);
}

TEST(AirTiming, lengthensTheSlotsWhenAnswersStayAwayAndShortensThemAgain) {
  AirTiming timing{19200, 115200};
  for (int i = 0; i < 20; ++i) timing.measured(22, 40, roundTrip(1.2, 22, 40, 19200, 115200));
  const unsigned before = timing.slotUnits();
  for (int i = 0; i < 20; ++i) timing.missed();
  EXPECT_GT(timing.slotUnits(), before);
  for (int i = 0; i < 2000; ++i) timing.answered();
  EXPECT_EQ(timing.slotUnits(), before);
}

// Trips over a channel with a delay each way, answers of all lengths.
void measureDelayed(AirTiming& timing, double delay, double unsteady, int times) {
  std::mt19937 random{1};
  for (int i = 0; i < times; ++i) {
    const std::size_t back = std::uniform_int_distribution<std::size_t>{32, 58}(random);
    const double more = 2.0 * delay + std::uniform_real_distribution<>{0.0, 1.0}(random)*unsteady;
    timing.measured(22, back, roundTrip(1.8, 22, back, 19200, 115200) + Seconds{more});
  }
}

TEST(AirTiming, findsADelayBesideTheAirtimeAndGivesHalfOfItToEachWay) {
  for (const double delay : {0.02, 0.3, 0.9}) {
    AirTiming timing{19200, 115200};
    measureDelayed(timing, delay, 0.0, 200);
    EXPECT_NEAR(timing.delay().value(), delay, 0.002);
    EXPECT_NEAR(timing.factor(), 1.8, 0.1);
    const Seconds both = timing.oneWay(22) + timing.oneWay(45);
    EXPECT_NEAR(both.value(), (roundTrip(1.8, 22, 45, 19200, 115200) + Seconds{2 * delay}).value(), 0.002);
  }
}

TEST(AirTiming, waitsForTheLatestOfUnsteadyAnswers) {
  AirTiming timing{19200, 115200};
  measureDelayed(timing, 0.2, 0.2, 300);
  const Seconds latest = roundTrip(1.8, 22, 58, 19200, 115200) + Seconds{0.6};
  EXPECT_GE(timing.oneWayAtMost(22) + timing.oneWayAtMost(58), latest);
}

TEST(AirTiming, doubtsAnInstantByWhatTripsSpread) {
  AirTiming steady{19200, 115200};
  measureDelayed(steady, 0.2, 0.0, 300);
  EXPECT_LT(steady.oneWayDoubt(45), Seconds{0.001});
  AirTiming unsteady{19200, 115200};
  measureDelayed(unsteady, 0.2, 0.2, 300);
  const double deviation = 0.2 / std::sqrt(12.0);
  EXPECT_NEAR(unsteady.oneWayDoubt(45).value(), deviation / std::sqrt(2.0), 0.5 * deviation);
}

TEST(AirTiming, waitsAsLongAsACallHasTakenUntilAFrameIsMeasured) {
  AirTiming timing{19200, 115200};
  const Seconds before = timing.oneWayAtMost(22) + timing.oneWayAtMost(58);
  EXPECT_LT(before, Seconds{0.3});
  timing.called(21, 30, Seconds{1.0});
  EXPECT_GE(timing.oneWayAtMost(22) + timing.oneWayAtMost(58), Seconds{1.0});
  measureDelayed(timing, 0.0, 0.0, 1);
  EXPECT_LE(timing.oneWayAtMost(22) + timing.oneWayAtMost(58), before);
}

TEST(AirTiming, waitsAsLongAsACallHasTakenSinceAFrameWasMeasured) {
  AirTiming timing{19200, 115200};
  measureDelayed(timing, 0.0, 0.0, 50);
  const Seconds before = timing.oneWayAtMost(22) + timing.oneWayAtMost(58);
  timing.called(21, 30, Seconds{0.1});
  EXPECT_EQ(timing.oneWayAtMost(22) + timing.oneWayAtMost(58), before);
  timing.called(21, 30, Seconds{1.0});
  EXPECT_GE(timing.oneWayAtMost(22) + timing.oneWayAtMost(58), Seconds{1.0});
  measureDelayed(timing, 0.0, 0.0, 1);
  EXPECT_LE(timing.oneWayAtMost(22) + timing.oneWayAtMost(58), 1.2 * before);
}

TEST(AirTiming, survivesMeasurementsThatMakeNoSense) {
  AirTiming timing{19200, 115200};
  timing.measured(22, 40, Seconds{-5.0});
  timing.measured(22, 40, Seconds{1e9});
  EXPECT_GE(timing.factor(), 0.0);
  EXPECT_LE(timing.slotUnits(), 255U);
}

}  // namespace
}  // namespace tessera::link
