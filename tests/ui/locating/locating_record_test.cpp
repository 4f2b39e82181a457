// What is counted of reads and errors.
#include "ui/locating/locating_record.h"

#include <gtest/gtest.h>

#include "tests/ui/locating/locating_values.h"

namespace tessera::ui {
namespace {

using Is = LocatingRecord::Verdict::Is;

TEST(LocatingRecord, TakesEachReadOnceAndAveragesTheLast) {
  LocatingRecord record;
  EXPECT_TRUE(record.take(watchedSnapshot(10.0, 1.0, {innovationAt(9.0, 1.0), innovationAt(9.5, 3.0)})));
  EXPECT_TRUE(record.take(watchedSnapshot(10.1, 1.0, {innovationAt(9.5, 3.0), innovationAt(10.05, 5.0)})));
  EXPECT_FALSE(record.take(watchedSnapshot(10.1, 1.0, {innovationAt(10.08, 9.0)}))) << "the same picture";
  ASSERT_EQ(record.reads().size(), 3U);
  EXPECT_DOUBLE_EQ(record.reads().back().mean, 3.0);
  EXPECT_EQ(record.verdict().is, Is::Open) << "three tell nothing";
  // The mean is of the last 25.
  std::vector<locate::Innovation> many;
  for (int i = 0; i < LocatingRecord::kWindow; ++i) many.push_back(innovationAt(11.0 + 0.1 * i, 2.0));
  record.take(watchedSnapshot(14.0, 1.0, many));
  EXPECT_NEAR(record.verdict().mean, 2.0, 1e-12);
  EXPECT_EQ(record.verdict().count, LocatingRecord::kWindow);
  EXPECT_EQ(record.verdict().is, Is::Honest);
  EXPECT_NEAR(record.verdict().bounds.low, 1.294, 0.01);
}

TEST(LocatingRecord, NamesALocatorThatIsTooSureOrTooCautious) {
  for (const auto& [nis, is] : {std::pair{4.0, Is::TooSure}, std::pair{0.5, Is::TooCautious}}) {
    LocatingRecord record;
    std::vector<locate::Innovation> many;
    for (int i = 0; i < 20; ++i) many.push_back(innovationAt(11.0 + 0.1 * i, nis));
    record.take(watchedSnapshot(14.0, 1.0, many));
    EXPECT_EQ(record.verdict().is, is);
  }
}

TEST(LocatingRecord, ComparesTheTruthWithWhatWasBelievedAtThatInstant) {
  LocatingRecord record;
  record.take(watchedSnapshot(10.0, 1.0));
  // 1 cm beside what is believed half-way between two pictures; it is known only with the second.
  record.take(TruthSample{VehicleId{1}, Seconds{10.05}, {{Metres{1.005}, Metres{0.41}}, {}}});
  EXPECT_EQ(record.errors().count, 0U);
  record.take(watchedSnapshot(10.1, 1.01));
  ASSERT_EQ(record.errors().count, 1U);
  EXPECT_NEAR(record.errors().now.value(), 0.01, 1e-9);
  EXPECT_NEAR(record.errors().nees, 1.0, 1e-6) << "one deviation";
  record.take(TruthSample{VehicleId{1}, Seconds{10.08}, {{Metres{1.008}, Metres{0.43}}, {}}});
  EXPECT_EQ(record.errors().count, 2U);
  EXPECT_NEAR(record.errors().mean.value(), 0.02, 1e-9);
  EXPECT_NEAR(record.errors().p95.value(), 0.03, 1e-9);
  EXPECT_NEAR(record.errors().nees, 5.0, 1e-6);
  record.take(TruthSample{VehicleId{2}, Seconds{10.09}, {}});
  record.take(TruthSample{VehicleId{1}, Seconds{3.0}, {}});
  EXPECT_EQ(record.errors().count, 2U) << "of another vehicle, and of before";
  record.clear();
  EXPECT_EQ(record.errors().count, 0U);
}

TEST(LocatingRecord, JudgesNothingThatNobodyBelievedAnything) {
  LocatingRecord record;
  auto lost = watchedSnapshot(10.0, 1.0);
  lost.vehicles.front().located = false;
  record.take(lost);
  record.take(watchedSnapshot(10.5, 1.0));
  record.take(watchedSnapshot(11.5, 1.0));
  record.take(TruthSample{VehicleId{1}, Seconds{10.2}, {}});
  record.take(TruthSample{VehicleId{1}, Seconds{11.0}, {}});
  EXPECT_EQ(record.errors().count, 0U) << "lost, then a second without a picture";
}

TEST(LocatingRecord, BeginsAnewWithAnotherVehicleAndAnotherRun) {
  LocatingRecord record;
  record.take(watchedSnapshot(10.0, 1.0, {innovationAt(9.0, 1.0)}));
  record.take(watchedSnapshot(5.0, 1.0, {innovationAt(4.0, 1.0), innovationAt(4.5, 1.0)}));
  EXPECT_EQ(record.reads().size(), 2U);
  supervisor::Snapshot other = watchedSnapshot(5.1, 1.0, {innovationAt(4.9, 1.0)});
  auto view = std::make_shared<supervisor::LocatingView>(*other.watched);
  view->vehicle = other.vehicles.front().id = VehicleId{2};
  other.watched = view;
  record.take(other);
  EXPECT_EQ(record.reads().size(), 1U);
  supervisor::Snapshot none = fakeSnapshot(2, 6.0);
  EXPECT_FALSE(record.take(none));
}

}  // namespace
}  // namespace tessera::ui
