#include "ui/charts/drive_samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tessera::ui {
namespace {

supervisor::Snapshot drivePicture(double time, double crossTrack) {
  supervisor::VehicleView v;
  v.id = VehicleId{1};
  v.contact = supervisor::Contact::Connected;
  v.task = supervisor::Task::Running;
  v.route = "one";
  v.located = true;
  v.link.lastHeard = Seconds{time};
  v.crossTrack = Metres{crossTrack};
  v.pose.position.x = Metres{time};
  supervisor::Snapshot snapshot;
  snapshot.time = Seconds{time};
  snapshot.vehicles = {v};
  return snapshot;
}

void drive(DriveSamples& samples, double from, double to, double step) {
  for (int i = 0; from + i * step < to; ++i) samples.take(drivePicture(from + i * step, 0.0));
}

TEST(DriveSamples, TakesTwentyPicturesASecondOfFifty) {
  DriveSamples samples;
  drive(samples, 0.0, 10.0, 0.02);
  const auto found = samples.window(VehicleId{1}, samples.now(), 5.0);
  // Every third picture: the first one at least 50 ms after the last.
  EXPECT_NEAR(static_cast<double>(found.size()), 5.0 / 0.06, 2.0);
  EXPECT_GE(found.front().time, samples.now() - 5.0);
  EXPECT_NEAR(found.back().time, samples.now(), 0.06);
}

TEST(DriveSamples, CoversAQuarterOfAnHourInBoundedMemory) {
  DriveSamples samples;
  drive(samples, 0.0, 1000.0, 0.05);
  const auto found = samples.window(VehicleId{1}, samples.now(), 900.0);
  EXPECT_LE(found.size(), 3002U);
  EXPECT_NEAR(found.front().time, samples.now() - 900.0, 2.0);
  for (std::size_t i = 1; i < found.size(); ++i) {
    ASSERT_GT(found[i].time, found[i - 1].time);
    ASSERT_LT(found[i].time - found[i - 1].time, 1.1);
  }
}

TEST(DriveSamples, KeepsTheWorstErrorWhenItThinsOut) {
  DriveSamples samples;
  drive(samples, 0.0, 100.0, 0.05);
  samples.take(drivePicture(100.0, -0.08));
  drive(samples, 100.05, 300.0, 0.05);
  double worst = 0.0;
  for (const DriveSample& s : samples.window(VehicleId{1}, samples.now(), 300.0))
    worst = std::min(worst, static_cast<double>(s.crossTrack));
  EXPECT_NEAR(worst, -0.08, 1e-6);
}

TEST(DriveSamples, LeavesGapsWhereNothingIsKnown) {
  DriveSamples samples;
  auto snapshot = drivePicture(1.0, 0.02);
  snapshot.vehicles[0].located = false;
  snapshot.vehicles[0].contact = supervisor::Contact::Silent;
  samples.take(snapshot);
  const auto found = samples.window(VehicleId{1}, 1.0, 10.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(std::isnan(found[0].x));
  EXPECT_TRUE(std::isnan(found[0].crossTrack));
  EXPECT_TRUE(std::isnan(found[0].speed));
  EXPECT_TRUE(std::isnan(found[0].commanded));
}

TEST(DriveSamples, BeginsAnewWithAnotherSupervision) {
  DriveSamples samples;
  drive(samples, 100.0, 110.0, 0.05);
  samples.take(drivePicture(0.5, 0.0));
  EXPECT_EQ(samples.window(VehicleId{1}, samples.now(), 900.0).size(), 1U);
}

TEST(SampleRing, KeepsTheNewest) {
  SampleRing ring{3};
  for (int i = 0; i < 5; ++i) {
    DriveSample s;
    s.time = i;
    ring.push(s);
  }
  ASSERT_EQ(ring.size(), 3U);
  EXPECT_EQ(ring.at(0).time, 2.0);
  EXPECT_EQ(ring.back().time, 4.0);
}

}  // namespace
}  // namespace tessera::ui
