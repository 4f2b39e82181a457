// Who gets which zone: first come, first served, all together or none, and nobody waits for ever.
#include "traffic/right_of_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "traffic/parts.h"

namespace tessera::traffic {
namespace {

using Why = RightOfWay::Why;

constexpr std::size_t kA = 0, kB = 1, kC = 2;

void expectWait(const RightOfWay& rights, VehicleId who, Why why, VehicleId whom) {
  const auto wait = rights.waitsFor(who);
  ASSERT_TRUE(wait);
  EXPECT_EQ(wait->why, why);
  EXPECT_EQ(wait->whom, whom);
}

TEST(RightOfWay, isTheFirstOnesUntilItHasLeft) {
  RightOfWay rights;
  EXPECT_TRUE(rights.ask(kOne, {kA}));
  EXPECT_FALSE(rights.ask(kTwo, {kA}));
  expectWait(rights, kTwo, Why::HasRight, kOne);
  rights.standsIn(kOne, {kA});
  expectWait(rights, kTwo, Why::Inside, kOne);
  rights.keepOnly(kOne, {}, true);
  EXPECT_FALSE(rights.ask(kTwo, {kA})) << "its body is still in the zone";
  rights.standsIn(kOne, {});
  EXPECT_TRUE(rights.ask(kTwo, {kA}));
  EXPECT_FALSE(rights.waitsFor(kTwo));
}

TEST(RightOfWay, goesInTheOrderOfComing) {
  RightOfWay rights;
  EXPECT_TRUE(rights.ask(kThree, {kA}));
  EXPECT_FALSE(rights.ask(kTwo, {kA}));
  EXPECT_FALSE(rights.ask(kOne, {kA}));
  rights.keepOnly(kThree, {}, true);
  EXPECT_FALSE(rights.ask(kOne, {kA})) << "asked first in this round, but came later";
  expectWait(rights, kOne, Why::CameFirst, kTwo);
  EXPECT_TRUE(rights.ask(kTwo, {kA}));
}

TEST(RightOfWay, isForgottenByWhoDoesNotWaitAnyMore) {
  RightOfWay rights;
  EXPECT_TRUE(rights.ask(kThree, {kA}));
  EXPECT_FALSE(rights.ask(kTwo, {kA}));
  EXPECT_FALSE(rights.ask(kOne, {kA}));
  rights.keepOnly(kTwo, {}, false);
  rights.keepOnly(kThree, {}, true);
  EXPECT_TRUE(rights.ask(kOne, {kA}));
}

TEST(RightOfWay, givesOverlappingZonesTogetherOrNotAtAll) {
  RightOfWay rights;
  EXPECT_TRUE(rights.ask(kOne, {kA}));
  EXPECT_FALSE(rights.ask(kTwo, {kA, kB}));
  EXPECT_FALSE(rights.ask(kThree, {kB})) << "the second came first, though B stands empty";
  rights.keepOnly(kOne, {}, true);
  EXPECT_TRUE(rights.ask(kTwo, {kA, kB}));
  expectWait(rights, kThree, Why::HasRight, kTwo);
  rights.keepOnly(kTwo, {kA}, true);
  EXPECT_TRUE(rights.ask(kThree, {kB}));
}

TEST(RightOfWay, letsOutWhoStandsInAZoneThatOthersWaitFor) {
  RightOfWay rights;
  rights.standsIn(kOne, {kA});
  EXPECT_FALSE(rights.ask(kTwo, {kA, kB}));
  EXPECT_TRUE(rights.ask(kOne, {kA, kB})) << "the second waits for it: to let it wait in turn would last for ever";
  // The same over a third.
  RightOfWay round;
  round.standsIn(kOne, {kA});
  round.standsIn(kThree, {kC});
  EXPECT_FALSE(round.ask(kTwo, {kB, kC}));
  EXPECT_FALSE(round.ask(kThree, {kA, kC}));
  EXPECT_TRUE(round.ask(kOne, {kA, kB}));
}

TEST(RightOfWay, namesThoseThatStandInEachOthersWay) {
  RightOfWay rights;
  rights.standsIn(kOne, {kA});
  rights.standsIn(kTwo, {kB});
  EXPECT_FALSE(rights.ask(kOne, {kA, kB}));
  EXPECT_FALSE(rights.ask(kTwo, {kA, kB}));
  expectWait(rights, kOne, Why::EachOther, kTwo);
  expectWait(rights, kTwo, Why::EachOther, kOne);
  rights.standsIn(kTwo, {});
  EXPECT_TRUE(rights.ask(kOne, {kA, kB}));
}

TEST(RightOfWay, letsTwoThatAreInOneZoneBothLeaveIt) {
  RightOfWay rights;
  rights.standsIn(kOne, {kA});
  rights.standsIn(kTwo, {kA});
  EXPECT_TRUE(rights.ask(kOne, {kA}));
  EXPECT_TRUE(rights.ask(kTwo, {kA}));
}

// Vehicles that come at random, each with some zones in a row, that it asks for all at once or one after the other.
TEST(RightOfWay, bringsEveryOneThroughAndNeverTwoIntoOneZone) {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    std::mt19937 random{seed};
    const auto below = [&](std::uint32_t n) { return static_cast<std::size_t>(random() % n); };
    constexpr std::size_t kVehicles = 8, kZones = 5;
    struct Drive {
      std::vector<RightOfWay::Zones> blocks;
      std::size_t next = 0;
      bool in = false;
    };
    std::vector<Drive> drives(kVehicles);
    for (Drive& drive : drives) {
      for (std::size_t n = 1 + below(4); n > 0; --n) {
        RightOfWay::Zones zones;
        for (std::size_t zone = 0; zone < kZones; ++zone)
          if (below(3) == 0) zones.push_back(zone);
        if (!zones.empty()) drive.blocks.push_back(zones);
      }
    }
    RightOfWay rights;
    int rounds = 0;
    const auto done = [&] {
      return std::all_of(drives.begin(), drives.end(), [](const Drive& d) { return d.next == d.blocks.size(); });
    };
    for (; rounds < 2000 && !done(); ++rounds) {
      std::vector<int> within(kZones, 0);
      for (std::size_t i = 0; i < kVehicles; ++i) {
        Drive& drive = drives[i];
        const VehicleId id{static_cast<std::uint8_t>(i + 1)};
        if (drive.next == drive.blocks.size()) continue;
        const RightOfWay::Zones& zones = drive.blocks[drive.next];
        if (drive.in && below(3) == 0) {
          drive.in = false;
          ++drive.next;
          rights.standsIn(id, {});
          rights.keepOnly(id, {}, true);
        } else if (!drive.in && rights.ask(id, zones)) {
          drive.in = true;
          rights.standsIn(id, zones);
        }
      }
      for (const Drive& drive : drives)
        if (drive.in)
          for (const std::size_t zone : drive.blocks[drive.next]) ++within[zone];
      for (const int count : within) ASSERT_LE(count, 1) << "seed " << seed;
    }
    ASSERT_LT(rounds, 2000) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tessera::traffic
