// Floors laid otherwise than drawn, driven over with a noise of 5 cm: what is named, and what its fix makes of the
// site.
#include "tilecheck/tile_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "floor/laid_tile.h"
#include "floor/new_floor.h"
#include "floor/site_map.h"

namespace tessera::tilecheck {
namespace {

using floor::Placement;
using floor::Site;

class DrivenFloor : public testing::Test {
protected:
  void lay(std::uint64_t seed, int columns = 6, int rows = 5) {
    random.seed(seed);
    drawn = floor::layNewFloor({"f", floor::usualTileTypes().front(), columns, rows, true}).value();
    drawn.looseTags.clear();
    real = drawn;
  }
  Placement& tile(const std::string& serial) {
    return *std::find_if(real.placements.begin(), real.placements.end(),
                         [&](const Placement& p) { return p.serial == serial; });
  }
  [[nodiscard]] const floor::TileType& type() const { return drawn.tileTypes.front(); }
  void turn(const std::string& serial, int by) {
    Placement& p = tile(serial);
    p = placedAt(serial, type(), floor::boxOf(p, type()).low, (p.quarterTurns + by) % 4);
  }
  void swap(const std::string& a, const std::string& b) {
    Placement& first = tile(a);
    Placement& second = tile(b);
    std::swap(first.origin, second.origin);
    std::swap(first.quarterTurns, second.quarterTurns);
  }
  /// Each tag of a real floor read so many times, its place off by the noise.
  std::vector<PlacedRead> drive(std::size_t times = 1, double noise = 0.05, double share = 1.0) {
    const auto map = floor::SiteMap::build(real).value();
    std::normal_distribution<double> off{0.0, noise};
    std::vector<PlacedRead> reads;
    for (const auto& tag : map->tags())
      for (std::size_t n = 0; n < times; ++n)
        if (std::uniform_real_distribution<double>{}(random) < share)
          reads.push_back({tag.uid, tag.place + Offset{Metres{off(random)}, Metres{off(random)}}});
    std::shuffle(reads.begin(), reads.end(), random);
    return reads;
  }
  /// Every fix applied: the site as it really is.
  void expectMended(const std::vector<TileSuspect>& suspects) {
    Site site = drawn;
    for (const TileSuspect& suspect : suspects) ASSERT_TRUE(relay(suspect.fix, site)) << suspect.sentence;
    for (const Placement& p : real.placements) {
      const auto mended = std::find_if(site.placements.begin(), site.placements.end(),
                                       [&](const Placement& q) { return q.serial == p.serial; });
      ASSERT_LT(distance(mended->origin, p.origin), Metres{1e-6}) << p.serial;
      ASSERT_EQ(mended->quarterTurns, p.quarterTurns) << p.serial;
    }
  }

  std::mt19937_64 random;
  Site drawn;
  Site real;
};

TEST_F(DrivenFloor, saysNothingOfAFloorThatLiesAsDrawn) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    lay(seed);
    EXPECT_TRUE(checkTiles(drawn, drive(2)).empty());
    EXPECT_TRUE(checkTiles(drawn, drive(1, 0.05, 0.3)).empty()) << "with few reads as well";
  }
}

TEST_F(DrivenFloor, namesATurnedTileAndTurnsIt) {
  lay(1);
  turn("T-0008", 1);
  const auto suspects = checkTiles(drawn, drive());
  ASSERT_EQ(suspects.size(), 1U);
  EXPECT_EQ(suspects[0].kind, TileSuspect::Kind::Turned);
  EXPECT_EQ(suspects[0].sentence, "Tile \"T-0008\" lies turned by 90° against the site.");
  expectMended(suspects);
}

TEST_F(DrivenFloor, namesTilesThatChangedPlacesInPairsAndRings) {
  lay(2);
  swap("T-0003", "T-0021");
  swap("T-0010", "T-0011");
  swap("T-0011", "T-0030");
  turn("T-0030", 2);
  const auto suspects = checkTiles(drawn, drive());
  ASSERT_EQ(suspects.size(), 2U);
  EXPECT_EQ(suspects[0].sentence, "Tiles \"T-0003\" and \"T-0021\" lie at each other's places.");
  EXPECT_EQ(suspects[1].serials.size(), 3U);
  expectMended(suspects);
}

TEST_F(DrivenFloor, infersTheOtherOfTwoFromTheOneThatWasDrivenOver) {
  lay(3);
  swap("T-0003", "T-0021");
  auto reads = drive();
  const auto& uids = drawn.tiles[20].uids;  // T-0021's
  std::erase_if(reads, [&](const PlacedRead& r) { return std::find(uids.begin(), uids.end(), r.uid) != uids.end(); });
  const auto suspects = checkTiles(drawn, reads);
  ASSERT_EQ(suspects.size(), 1U);
  expectMended(suspects);
}

TEST_F(DrivenFloor, isNotMisledByReadsThatAreQuiteWrong) {
  lay(4);
  turn("T-0015", 3);
  auto reads = drive(2);
  for (std::size_t i = 0; i < reads.size(); i += 12) reads[i].place = {Metres{1.0}, Metres{2.0}};
  const auto suspects = checkTiles(drawn, reads);
  ASSERT_EQ(suspects.size(), 1U);
  EXPECT_EQ(suspects[0].serials, std::vector<std::string>{"T-0015"});
}

TEST_F(DrivenFloor, tellsOfEachTileHowFarItIsChecked) {
  lay(7);
  turn("T-0008", 1);
  auto reads = drive();
  const auto readsOf = [&](const PlacedRead& read, std::size_t tile) {
    const auto& uids = drawn.tiles[tile].uids;
    return std::find(uids.begin(), uids.end(), read.uid) != uids.end();
  };
  std::erase_if(
      reads, [&](const PlacedRead& r) { return readsOf(r, 0) || (readsOf(r, 1) && r.uid != drawn.tiles[1].uids[0]); });
  const auto result = checkFloor(drawn, reads);
  ASSERT_EQ(result.states.size(), drawn.placements.size());
  EXPECT_EQ(result.suspects.size(), 1U);
  EXPECT_EQ(result.states[0], TileState::Untouched);
  EXPECT_EQ(result.states[1], TileState::Seen);
  EXPECT_EQ(result.states[7], TileState::Suspect);
  EXPECT_EQ(std::count(result.states.begin(), result.states.end(), TileState::Confirmed),
            static_cast<std::ptrdiff_t>(drawn.placements.size()) - 3);
  Site mended = drawn;
  ASSERT_TRUE(relay(result.suspects[0].fix, mended));
  EXPECT_EQ(checkFloor(mended, reads).states[7], TileState::Confirmed);
}

TEST_F(DrivenFloor, saysNothingFromTooFewReads) {
  lay(5);
  swap("T-0003", "T-0021");
  auto reads = drive();
  reads.resize(2);
  EXPECT_TRUE(checkTiles(drawn, reads).empty());
  EXPECT_TRUE(checkTiles(drawn, {}).empty());
  EXPECT_TRUE(checkTiles(Site{}, drive()).empty());
}

TEST_F(DrivenFloor, leavesASiteAloneThatWasEditedSince) {
  lay(6);
  turn("T-0008", 1);
  const auto suspects = checkTiles(drawn, drive());
  ASSERT_EQ(suspects.size(), 1U);
  Site later = drawn;
  later.placements[7].origin.x += Metres{0.01};
  const Site before = later;
  EXPECT_FALSE(relay(suspects[0].fix, later));
  EXPECT_EQ(later, before);
}

TEST_F(DrivenFloor, findsWhateverWasSwappedAndTurnedAndNothingElse) {
  std::size_t laid = 0;
  std::size_t found = 0;
  for (std::uint64_t seed = 100; seed < 160; ++seed) {
    lay(seed);
    std::vector<std::string> serials;
    for (const auto& p : real.placements) serials.push_back(p.serial);
    std::shuffle(serials.begin(), serials.end(), random);
    const std::size_t swaps = random() % 4;
    const std::size_t turns = random() % 4;
    for (std::size_t i = 0; i < swaps; ++i) swap(serials[2 * i], serials[2 * i + 1]);
    for (std::size_t i = 0; i < turns; ++i) turn(serials[2 * swaps + i], 1 + static_cast<int>(random() % 3));
    const auto suspects = checkTiles(drawn, drive(2));
    laid += swaps + turns;
    found += suspects.size();
    ASSERT_NO_FATAL_FAILURE(expectMended(suspects)) << "seed " << seed;
  }
  EXPECT_EQ(found, laid);
}

}  // namespace
}  // namespace tessera::tilecheck
