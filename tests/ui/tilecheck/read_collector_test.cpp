// Where a reader was when it read a tag, as the pictures before that one have it.
#include "ui/tilecheck/read_collector.h"

#include <gtest/gtest.h>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

class Collecting : public testing::Test {
protected:
  const std::shared_ptr<const floor::SiteMap> map = tiledMap(2, 2);
  const floor::Site& site = map->site();
  ReadCollector collector;
  supervisor::VehicleView vehicle;
  Collecting() {
    vehicle.id = VehicleId{1};
    vehicle.located = true;
    vehicle.speed = MetresPerSecond{0.5};
  }
  void see(double time, double x) {
    vehicle.pose = {{Metres{x}, Metres{1.0}}, {}};
    supervisor::Snapshot snapshot;
    snapshot.time = Seconds{time};
    snapshot.vehicles = {vehicle};
    collector.take(snapshot, *map);
  }
  void read(double at, std::uint8_t reader = 0) {
    vehicle.recentReads.push_back({site.tiles[0].uids[0], reader, Seconds{at}, std::nullopt});
  }
};

TEST_F(Collecting, placesAReadWhereTheReaderWasAtThatInstant) {
  see(1.0, 2.0);
  see(1.2, 2.1);
  read(1.1);
  see(1.4, 2.2);  // what the read has made of the pose does not count
  ASSERT_EQ(collector.reads().size(), 1U);
  EXPECT_NEAR(collector.reads()[0].place.x.value(), 2.05 + 0.15, 1e-9) << "with the reader's place on the vehicle";
  EXPECT_NEAR(collector.reads()[0].place.y.value(), 1.0, 1e-9);
  see(1.6, 2.3);
  EXPECT_EQ(collector.taken(), 1U) << "each read once";
}

TEST_F(Collecting, goesStraightOnFromTheLastPicture) {
  see(1.0, 2.0);
  read(1.2);
  see(1.2, 5.0);
  ASSERT_EQ(collector.reads().size(), 1U);
  EXPECT_NEAR(collector.reads()[0].place.x.value(), 2.0 + 0.1 + 0.15, 1e-9);
}

TEST_F(Collecting, isNotLedAstrayByATileThatDrawsTheLocatorElsewhere) {
  see(1.0, 2.00);
  see(1.1, 2.05);
  see(1.2, 3.30);  // 1.2 m further on within a tenth of a second
  see(1.3, 3.35);
  read(1.3);
  see(1.4, 3.40);
  ASSERT_EQ(collector.reads().size(), 1U);
  EXPECT_NEAR(collector.reads()[0].place.x.value(), 2.15 + 0.15, 1e-9) << "wheels and heading lead on";
  see(1.5, 2.25);  // the next tile calls it back
  see(1.6, 2.30);
  read(1.6);
  see(1.7, 2.35);
  EXPECT_NEAR(collector.reads()[1].place.x.value(), 2.30 + 0.15, 1e-9);
}

TEST_F(Collecting, believesAPlaceThatJumpedWhenNothingCallsItBack) {
  see(1.0, 2.0);
  double x = 3.0;
  double time = 1.1;
  for (; x < 6.0; x += 0.05, time += 0.1) see(time, x);
  read(time - 0.1);
  see(time, x);
  ASSERT_EQ(collector.reads().size(), 1U);
  EXPECT_NEAR(collector.reads()[0].place.x.value(), x - 0.05 + 0.15, 1e-6);
}

TEST_F(Collecting, passesOverWhatItCannotPlace) {
  read(0.9);
  see(1.0, 2.0);
  EXPECT_EQ(collector.taken(), 0U) << "nothing was known then";
  read(2.0);
  see(2.0, 2.0);
  EXPECT_EQ(collector.taken(), 0U) << "the last picture is old";
  vehicle.located = false;
  see(2.1, 2.0);
  read(2.15);
  see(2.2, 2.0);
  EXPECT_EQ(collector.taken(), 0U) << "nobody knew where it was";
  vehicle.located = true;
  see(2.3, 2.0);
  read(2.35, 7);
  see(2.4, 2.0);
  EXPECT_EQ(collector.taken(), 0U) << "the site has no such reader";
}

TEST_F(Collecting, keepsTheLatestOfATagAndBeginsAnewWithAnotherRun) {
  for (int n = 0; n < 20; ++n) {
    see(1.0 + 0.1 * n, 0.05 * n);
    read(1.0 + 0.1 * n);
  }
  EXPECT_EQ(collector.reads().size(), ReadCollector::kMostOfATag);
  EXPECT_GT(collector.taken(), ReadCollector::kMostOfATag);
  collector.clear();
  EXPECT_TRUE(collector.reads().empty());
  vehicle.recentReads.clear();
  see(0.5, 3.0);
  read(0.6);
  see(0.7, 3.0);
  EXPECT_EQ(collector.reads().size(), 1U);
}

}  // namespace
}  // namespace tessera::ui
