// Which tags count as passed over, and which passes as read.
#include "tilecheck/pass_counter.h"

#include <gtest/gtest.h>

#include "floor/new_floor.h"

namespace tessera::tilecheck {
namespace {

// One loose tag at (1, 1); a vehicle with one reader 15 cm ahead.
class Passing : public testing::Test {
protected:
  Passing() {
    floor::Site site = floor::layNewFloor({"f", floor::usualTileTypes().front(), 1, 1, true}).value();
    site.tiles.clear();
    site.placements.clear();
    site.looseTags = {{tag, {Metres{1}, Metres{1}}}};
    site.vehicles[0].readers = {{Metres{0.15}, Metres{0}}};
    site.vehicles[0].readerRadius = Metres{0.06};
    map = floor::SiteMap::build(site).value();
  }
  [[nodiscard]] const floor::VehicleSetup& vehicle() const { return map->site().vehicles.front(); }
  /// From x = 0.5 to 1.5 in steps of 2 cm, so far beside the tag.
  void passBy(double aside, bool read) {
    for (int n = 0; n <= 50; ++n) {
      at += 0.1;
      counter.moved(*map, vehicle(), Seconds{at}, {{Metres{0.5 + 0.02 * n}, Metres{1.0 + aside}}, {}});
      if (n == 30 && read) counter.read(vehicle().id, tag, Seconds{at - 0.9});  // told late
    }
    at += 60;
  }
  [[nodiscard]] TagPasses counted() const {
    const auto all = counter.passes(Seconds{at});
    return all.empty() ? TagPasses{} : all.front();
  }

  const floor::TagUid tag = floor::TagUid::parse("04AABBCC").value();
  std::shared_ptr<const floor::SiteMap> map;
  PassCounter counter;
  double at = 0;
};

TEST_F(Passing, countsPassesOverATagAndInWhichItWasRead) {
  passBy(0.0, true);
  passBy(0.01, false);
  passBy(-0.01, true);
  EXPECT_EQ(counted().uid, tag);
  EXPECT_EQ(counted().passes, 3U);
  EXPECT_EQ(counted().hits, 2U);
  counter.clear();
  EXPECT_TRUE(counter.passes(Seconds{at}).empty());
}

TEST_F(Passing, doesNotCountWhatAReaderMayHavePassedBeside) {
  passBy(0.03, false);
  EXPECT_EQ(counted().passes, 0U);
}

TEST_F(Passing, waitsUntilTheReadsOfAPassMustHaveCome) {
  passBy(0.0, false);
  EXPECT_TRUE(counter.passes(Seconds{at - 60 - 1.5}).empty());
  EXPECT_EQ(counter.passes(Seconds{at}).size(), 1U);
}

TEST_F(Passing, dropsThePassOfAVehicleThatWasNotWhereItWasBelievedToBe) {
  for (const bool jumps : {true, false}) {
    counter.moved(*map, vehicle(), Seconds{1}, {{Metres{0.84}, Metres{1.0}}, {}});
    if (jumps)
      counter.moved(*map, vehicle(), Seconds{1.1}, {{Metres{2.84}, Metres{1.0}}, {}});
    else
      counter.lost(vehicle().id);
    counter.moved(*map, vehicle(), Seconds{1.2}, {{Metres{2.86}, Metres{1.0}}, {}});
    EXPECT_TRUE(counter.passes(Seconds{60}).empty());
  }
}

TEST_F(Passing, aReadLongBeforeOrAfterIsNotOfThisPass) {
  passBy(0.0, false);
  counter.read(vehicle().id, tag, Seconds{at - 30});
  EXPECT_EQ(counted().hits, 0U);
  counter.read(VehicleId{77}, tag, Seconds{2.0});
  EXPECT_EQ(counted().hits, 0U) << "another vehicle's";
}

}  // namespace
}  // namespace tessera::tilecheck
