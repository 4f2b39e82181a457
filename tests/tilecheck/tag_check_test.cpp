// Tags that are others than the site says: what a drive tells of them, and what the fix makes of the site.
#include "tilecheck/tag_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "floor/new_floor.h"
#include "floor/site_map.h"

namespace tessera::tilecheck {
namespace {

using floor::Site;
using floor::TagUid;
using testing::HasSubstr;

TagUid uidNumber(unsigned n) {
  const std::array<std::uint8_t, 4> bytes{0xEE, 0x01, static_cast<std::uint8_t>(n >> 8), static_cast<std::uint8_t>(n)};
  return TagUid::fromBytes(bytes).value();
}

class DrivenTags : public testing::Test {
protected:
  void lay(std::uint64_t seed) {
    random.seed(seed);
    drawn = floor::layNewFloor({"f", floor::usualTileTypes().front(), 6, 5, true}).value();
    drawn.looseTags.clear();
    real = drawn;
  }
  /// Every tag of the real floor passed so many times and read in that share of them, its place off by 5 cm.
  void drive(std::size_t times, double detection = 0.9) {
    const auto map = floor::SiteMap::build(real).value();
    const auto known = floor::SiteMap::build(drawn).value();
    std::normal_distribution<double> off{0.0, 0.05};
    reads.clear();
    passes.clear();
    for (const auto& tag : map->tags()) {
      TagPasses of{tag.uid, times, 0};
      for (std::size_t n = 0; n < times; ++n) {
        if (std::uniform_real_distribution<double>{}(random) >= detection) continue;
        ++of.hits;
        reads.push_back({tag.uid, tag.place + Offset{Metres{off(random)}, Metres{off(random)}}});
      }
      if (known->find(tag.uid)) passes.push_back(of);
    }
    for (const auto& tag : known->tags())
      if (!map->find(tag.uid)) passes.push_back({tag.uid, times, 0});
    std::shuffle(reads.begin(), reads.end(), random);
  }
  [[nodiscard]] std::vector<TagFinding> findings() const {
    return checkTags(drawn, reads, passes, checkFloor(drawn, reads));
  }

  std::mt19937_64 random;
  Site drawn;
  Site real;
  std::vector<PlacedRead> reads;
  std::vector<TagPasses> passes;
};

TEST_F(DrivenTags, saysNothingWhereEveryTagIsAsTheSiteSays) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    lay(seed);
    for (const double detection : {0.95, 0.6, 0.2}) {
      drive(4, detection);
      for (const TagFinding& f : findings()) ADD_FAILURE() << seed << ", " << detection << ": " << f.sentence;
    }
  }
}

TEST_F(DrivenTags, namesACardThatWasExchangedAndPutsItIn) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    lay(seed);
    const std::size_t tile = random() % real.tiles.size();
    const std::size_t tag = random() % 8;
    real.tiles[tile].uids[tag] = uidNumber(1);
    drive(5);
    const auto all = findings();
    for (const TagFinding& f : all) {
      if (f.kind != TagFinding::Kind::Exchanged) continue;
      EXPECT_THAT(f.sentence.english(), HasSubstr("which no tile has, was read"));
      Site mended = drawn;
      ASSERT_TRUE(put(*f.fix, mended));
      EXPECT_EQ(mended, real) << seed;
      ++found;
    }
    EXPECT_EQ(all.size(), 1U) << seed << ": the place is told once";
  }
  EXPECT_GE(found, 18U);
}

TEST_F(DrivenTags, putsATagInThatWasNeverRegistered) {
  lay(3);
  drawn.tiles[7].uids[4] = {};
  drive(5);
  const auto all = findings();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, TagFinding::Kind::Unregistered);
  ASSERT_TRUE(put(*all[0].fix, drawn));
  EXPECT_EQ(drawn, real);
}

TEST_F(DrivenTags, namesATagThatNobodyKnowsWithoutGuessingWhereItBelongs) {
  lay(4);
  drive(3);
  for (int n = 0; n < 2; ++n) reads.push_back({uidNumber(9), {Metres{1.23}, Metres{0.45}}});
  auto all = findings();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, TagFinding::Kind::Unknown);
  EXPECT_EQ(all[0].sentence.english(), "Tag EE010009 was read 2 times at (1.23, 0.45) m, but no tile has it.");
  EXPECT_FALSE(all[0].fix);
  reads.resize(reads.size() - 1);
  EXPECT_TRUE(findings().empty()) << "once is nothing yet";
  reads.push_back(reads.back());
  drawn.looseTags.push_back({uidNumber(9), {Metres{1.2}, Metres{0.4}}});
  EXPECT_TRUE(findings().empty()) << "a loose tag is known";
  drawn.looseTags.clear();
  drawn.tiles.push_back({"S-1", drawn.tiles[0].type, {uidNumber(9)}});
  all = findings();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_THAT(all[0].sentence.english(), HasSubstr("its tile \"S-1\" is not laid"));
}

TEST_F(DrivenTags, namesATagThatIsNeverReadOnceChanceIsImprobableAndSaysHow) {
  lay(5);
  const auto deaden = [this] {
    const TagUid dead = drawn.tiles[11].uids[2];
    std::erase_if(reads, [&](const PlacedRead& r) { return r.uid == dead; });
    for (TagPasses& p : passes)
      if (p.uid == dead) p.hits = 0;
  };
  drive(5, 0.9);
  deaden();
  const auto all = findings();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, TagFinding::Kind::Missed);
  EXPECT_THAT(all[0].sentence.english(), HasSubstr("Tag 3 of tile \"T-0012\" was never read in 5 passes over it"));
  EXPECT_THAT(all[0].sentence.english(), testing::ContainsRegex("read in (8|9). % of passes"));
  EXPECT_THAT(all[0].sentence.english(), HasSubstr("once in "));
  EXPECT_FALSE(all[0].fix);
  drive(2, 0.9);
  deaden();
  EXPECT_TRUE(findings().empty()) << "not often enough";
  drive(5, 0.3);
  deaden();
  EXPECT_TRUE(findings().empty()) << "readers that see badly";
}

TEST_F(DrivenTags, namesAWholeTileOnceAndNothingOfTilesThatLieElsewhere) {
  lay(6);
  drive(5);
  const auto ofTile = [&](const TagUid& uid) {
    const auto& uids = drawn.tiles[8].uids;
    return std::find(uids.begin(), uids.end(), uid) != uids.end();
  };
  std::erase_if(reads, [&](const PlacedRead& r) { return ofTile(r.uid); });
  for (TagPasses& p : passes)
    if (ofTile(p.uid)) p.hits = 0;
  const auto all = findings();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_THAT(all[0].sentence.english(), HasSubstr("8 tags of tile \"T-0009\" were never read in 40 passes"));
  std::swap(real.placements[8].origin, real.placements[21].origin);
  drive(4);
  EXPECT_EQ(checkFloor(drawn, reads).suspects.size(), 1U);
  EXPECT_TRUE(findings().empty()) << "that they lie at each other's places is said already";
}

TEST_F(DrivenTags, isSilentOfSingleTagsWhenManyAreMissed) {
  lay(7);
  drive(5);
  for (std::size_t n = 0; n < passes.size(); n += 4) {
    std::erase_if(reads, [&](const PlacedRead& r) { return r.uid == passes[n].uid; });
    passes[n].hits = 0;
  }
  EXPECT_TRUE(findings().empty()) << "then the vehicle is not where it is believed to be";
}

TEST_F(DrivenTags, leavesASiteAloneThatWasEditedSince) {
  lay(8);
  const PutUid change{"T-0003", 1, uidNumber(5), uidNumber(6)};
  const Site before = drawn;
  EXPECT_FALSE(put(change, drawn));
  EXPECT_FALSE(put({"nobody", 0, {}, uidNumber(6)}, drawn));
  EXPECT_EQ(drawn, before);
}

}  // namespace
}  // namespace tessera::tilecheck
