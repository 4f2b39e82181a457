#include "exchange/tag_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "floor/site_json.h"
#include "sitecheck/sites.h"

namespace tessera::exchange {
namespace {

using floor::Site;
using floor::TagUid;
using sitecheck::at;
using sitecheck::goodFloor;
using testing::HasSubstr;

std::string errorOf(const Site& onto, const std::string& csv) {
  const auto preview = importTags(onto, csv, "f.csv");
  return preview ? std::string{} : preview.error().sentence.english();
}

std::string goldenTable(const std::string& name) {
  std::ifstream in{std::string{TESSERA_GOLDEN} + "/" + name, std::ios::binary};
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

TEST(TagTables, ofTheDemoFloorIsTheOneThatIsKept) {
  const auto site = floor::loadSite(std::string{TESSERA_SITES} + "/paper.tessera.json");
  ASSERT_TRUE(site);
  EXPECT_EQ(writeTileTags(*site), goldenTable("paper.csv"));
  EXPECT_EQ(writeTagPlaces(*site), goldenTable("paper.places.csv"));
}

TEST(TagTables, fillAFloorThatHasNoneYet) {
  Site bare = goodFloor();
  bare.tiles[3].uids[2] = {};
  const std::string table = writeTileTags(bare);
  const Site full = bare;
  for (auto& tile : bare.tiles) tile.uids.clear();
  const auto preview = importTags(bare, table, "f.csv");
  ASSERT_TRUE(preview) << preview.error().sentence;
  EXPECT_EQ(preview->site, full);
  EXPECT_EQ(preview->changes.size(), 20U) << "one for each tile";
  EXPECT_TRUE(importTags(full, table, "f.csv")->changes.empty());
}

TEST(TagTables, aFloorBrokenAtRandomComesBackFromItsTables) {
  std::mt19937_64 random{8};
  for (int round = 0; round < 200; ++round) {
    Site site = goodFloor();
    for (int i = 0; i < 4; ++i) sitecheck::editAtRandom(site, random);
    // Where a UID stands twice already, on a tile that is not laid, a table that says so again is refused.
    if (!floor::SiteMap::build(site) || !sitecheck::faultsOf(site, sitecheck::FaultKind::UidTwice).empty()) continue;
    for (const std::string& table : {writeTileTags(site), writeTagPlaces(site)}) {
      const auto preview = importTags(site, table, "f.csv");
      ASSERT_TRUE(preview) << round << preview.error().sentence;
      ASSERT_EQ(preview->site, site) << round;
    }
  }
}

/// Four tiles turned each way, off the lattice by fractions of a millimetre, and loose tags between them.
Site turnedFloor() {
  Site site = goodFloor();
  for (std::size_t n = 0; n < 4; ++n) {
    site.placements[n].origin = at(10.0 / 3 + 2.0 * static_cast<double>(n), -1.0 / 7);
    site.placements[n].quarterTurns = static_cast<int>(n);
  }
  site.tiles[1].uids[3] = {};
  site.looseTags = {{TagUid::parse("04AABBCC").value(), at(1.0 / 3, 40)},
                    {TagUid::parse("04AABBCD").value(), at(-0.0, 1e-7)}};
  return site;
}

TEST(TagPlaces, ofEveryTagFillAFloorThatHasNoneYet) {
  const Site full = turnedFloor();
  const std::string table = writeTagPlaces(full);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 159 + 2);
  EXPECT_EQ(importTags(full, table, "f.csv")->site, full);
  EXPECT_TRUE(importTags(full, table, "f.csv")->changes.empty());
  Site bare = full;
  bare.looseTags.clear();
  for (auto& tile : bare.tiles) tile.uids.clear();
  const auto preview = importTags(bare, table, "f.csv");
  ASSERT_TRUE(preview) << preview.error().sentence;
  EXPECT_EQ(preview->site, full);
  ASSERT_EQ(preview->notes.size(), 1U);
  EXPECT_THAT(preview->notes[0].english(),
              HasSubstr("where a tile has a tag (within 1 cm), whose UID they give: 159."));
  EXPECT_EQ(preview->changes.size(), 22U) << "tiles and loose tags";
  // From a surveyor, to the millimetre.
  Site like = bare;
  const auto coarse = importTags(like, "x,y,uid\n0.083,0.068,04AABBCC\n0.086,0.075,04AABBCD\n", "f.csv");
  ASSERT_TRUE(coarse) << coarse.error().sentence;
  EXPECT_EQ(coarse->site.looseTags.size(), 2U) << "tile 1 has been moved away";
}

TEST(TagTables, sayWhichTagsTheyLack) {
  Site site = goodFloor();
  EXPECT_TRUE(leftOutOfTileTags(site).empty());
  EXPECT_TRUE(leftOutOfTagPlaces(site).empty());
  site.looseTags = {{TagUid::parse("04AABBCC").value(), at(1, 1)}, {TagUid::parse("04AABBCD").value(), at(2, 1)}};
  site.placements.pop_back();
  site.tiles.back().uids[2] = {};
  ASSERT_EQ(leftOutOfTileTags(site).size(), 1U);
  EXPECT_THAT(leftOutOfTileTags(site)[0].english(), HasSubstr("left out: 2."));
  ASSERT_EQ(leftOutOfTagPlaces(site).size(), 1U);
  EXPECT_THAT(leftOutOfTagPlaces(site)[0].english(), HasSubstr("left out: 7."));
}

TEST(TagPlaces, meanTheTagOfATileWithinACentimetre) {
  const Site site = goodFloor();
  const std::string old = site.tiles[0].uids[0].text();
  const auto preview = importTags(site, "x,y,uid\n0.083,0.069,04AABBCC\n0.0852,0.225,04AABBCD\n", "f.csv");
  ASSERT_TRUE(preview) << preview.error().sentence;
  EXPECT_EQ(preview->site.tiles[0].uids[0].text(), "04AABBCC") << "in the place of " << old;
  ASSERT_EQ(preview->site.looseTags.size(), 1U) << "beyond it is a tag of its own";
  EXPECT_EQ(preview->changes.size(), 2U);
  EXPECT_THAT(preview->changes[0].sentence.english(), HasSubstr("replaced: 1"));
}

TEST(TagPlaces, areRefusedAsAWholeWhereATagWouldStandTwice) {
  const Site site = goodFloor();
  const std::string first = site.tiles[0].uids[0].text();
  EXPECT_THAT(errorOf(site, "x,y,uid\n9,9,04AABBCC\n0.675,0.075," + first + "\n"),
              HasSubstr("f.csv: line 3: tag " + first + " would be registered twice"));
  EXPECT_THAT(errorOf(site, "x,y,uid\n0.075,0.075,04AABBCC\n0.076,0.075,04AABBCD\n"),
              HasSubstr("line 3: this tag stands already in line 2"));
}

TEST(TagTables, mayExchangeTwoTags) {
  Site site = goodFloor();
  const std::string a = site.tiles[0].uids[0].text();
  const std::string b = site.tiles[1].uids[4].text();
  const auto preview = importTags(site, "serial,index,uid\nT-0001,1," + b + "\nT-0002,5," + a + "\n", "f.csv");
  ASSERT_TRUE(preview) << preview.error().sentence;
  EXPECT_EQ(preview->site.tiles[0].uids[0].text(), b);
  EXPECT_EQ(preview->changes.size(), 2U);
}

TEST(TagTables, takeUidsOfFourSevenAndTenBytesAsPeopleWriteThem) {
  const auto preview =
      importTags(goodFloor(),
                 "\xEF\xBB\xBFserial,index,uid\r\n\"T-0001\", 1 ,04:aa:bb:cc\r\nT-0001,2,04AABBCCDDEEFF\r\nT-0001,3,"
                 "0102030405060708090A\r\nT-0001,4,\r\n",
                 "f.csv");
  ASSERT_TRUE(preview) << preview.error().sentence;
  const auto& uids = preview->site.tiles[0].uids;
  EXPECT_EQ(uids[0].text(), "04AABBCC");
  EXPECT_EQ(uids[1].text(), "04AABBCCDDEEFF");
  EXPECT_EQ(uids[2].text(), "0102030405060708090A");
  EXPECT_TRUE(uids[3].empty());
}

TEST(TagTables, moveAndAddLooseTagsAndReadTheOtherHeader) {
  Site site = goodFloor();
  site.looseTags = {{TagUid::parse("04AABBCC").value(), at(1, 1)}};
  const auto preview = importTags(site, "x,y,uid\n2.5,-3e-1,04AABBCC\n0,0,04AABBCD\n", "f.csv");
  ASSERT_TRUE(preview) << preview.error().sentence;
  ASSERT_EQ(preview->site.looseTags.size(), 2U);
  EXPECT_EQ(preview->site.looseTags[0].place, at(2.5, -0.3));
  EXPECT_EQ(preview->changes[0].kind, sitediff::ChangeKind::Moved);
}

TEST(TagTables, sayInWhichLineWhatIsWrong) {
  const Site site = goodFloor();
  const std::string uid = site.tiles[5].uids[1].text();
  const std::string head = "serial,index,uid\n";
  EXPECT_THAT(errorOf(site, ""), HasSubstr("f.csv: line 1: expected the header"));
  EXPECT_THAT(errorOf(site, "T-0001,1,04AABBCC\n"), HasSubstr("line 1: expected the header"));
  EXPECT_THAT(errorOf(site, head + "T-0001,1,\nT-9999,1,\n"), HasSubstr("line 3: the site has no tile \"T-9999\""));
  for (const char* bad : {"0", "9", "-1", "1.5", "x", ""})
    EXPECT_THAT(errorOf(site, head + "T-0001," + bad + ",\n"), HasSubstr("line 2: expected an index from 1 to 8"))
        << bad;
  EXPECT_THAT(errorOf(site, head + "T-0001,1,04AABB\n"), HasSubstr("line 2: \"04AABB\" is not a tag's UID"));
  EXPECT_THAT(errorOf(site, head + "T-0001,1,\nT-0001,1,\n"), HasSubstr("line 3: this tag stands already in line 2"));
  EXPECT_THAT(errorOf(site, head + "T-0001,1," + uid + "\n"),
              HasSubstr("would be registered twice: as tag 1 of tile \"T-0001\" and as tag 2 of tile \"T-0006\""));
  EXPECT_THAT(errorOf(site, "x_m,y_m,uid\n1,1," + uid + "\n"), HasSubstr("line 2: tag " + uid));

  for (const char* bad : {"nan", "inf", "1e9", "", "1,5"})
    EXPECT_THAT(errorOf(site, std::string{"x_m,y_m,uid\n"} + bad + ",1,04AABBCC\n"),
                HasSubstr("f.csv: line 2: expected"));
  EXPECT_THAT(errorOf(site, "x,y,uid\n1,1,04AABBCC\n2,2,04AABBCC\n"), HasSubstr("stands already in line 2"));
}

}  // namespace
}  // namespace tessera::exchange
