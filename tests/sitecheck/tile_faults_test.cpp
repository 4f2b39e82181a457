#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Site;
using testing::HasSubstr;

// The one fault of that kind.
Fault only(const Site& site, FaultKind kind) {
  const Faults faults = faultsOf(site, kind);
  EXPECT_EQ(faults.size(), 1U) << codeOf(kind) << "\n" << listOf(checkSite(site).faults());
  return faults.empty() ? Fault{} : faults.front();
}

// Tile 13 of the good floor lies in its third row, not on the edge.
constexpr std::size_t kInner = 12;

TEST(TileFaults, twoTilesUponOneAnother) {
  Site site = goodFloor();
  site.placements[kInner].origin.x -= Metres{0.2};
  const Fault fault = only(site, FaultKind::TilesOverlap);
  EXPECT_EQ(fault.severity, Severity::Error);
  EXPECT_THAT(fault.sentence.english(), HasSubstr("20.0 × 60.0 cm"));
  ASSERT_TRUE(fault.place);
  EXPECT_NEAR((fault.place->high.x - fault.place->low.x).value(), 0.2, 1e-9);
  EXPECT_FALSE(fault.fix) << "which of the two is wrong is not plain";
}

TEST(TileFaults, aTileLaidJustWhereAnotherLiesCanBeTakenUp) {
  Site site = goodFloor();
  site.tiles.push_back({"extra", site.tileTypes[0].name, {}});
  site.placements.push_back({"extra", site.placements[kInner].origin, 0});
  const Fault fault = only(site, FaultKind::TilesOverlap);
  ASSERT_TRUE(fault.fix);
  ASSERT_TRUE(mend(fault.fix->edit, site));
  EXPECT_TRUE(faultsOf(site, FaultKind::TilesOverlap).empty());
}

TEST(TileFaults, aTileALittleOffItsLatticeIsToldOnceAndMovedBack) {
  for (const Offset by : {Offset{Metres{0.01}, {}}, Offset{{}, Metres{-0.02}}, Offset{Metres{-0.012}, Metres{0.004}}}) {
    Site site = goodFloor();
    const Point before = site.placements[kInner].origin;
    site.placements[kInner].origin = before + by;
    const Fault fault = only(site, FaultKind::TileOffLattice);
    EXPECT_EQ(fault.objects.front().name, site.placements[kInner].serial);
    for (int i = 0; i < 2 && !faultsOf(site, FaultKind::TileOffLattice).empty(); ++i)
      ASSERT_TRUE(mend(faultsOf(site, FaultKind::TileOffLattice).front().fix->edit, site));
    EXPECT_NEAR(distance(site.placements[kInner].origin, before).value(), 0.0, 1e-5);
    EXPECT_EQ(listOf(checkSite(site).faults()), "");
  }
}

TEST(TileFaults, laidToHalfAMillimetreIsLaidWell) {
  Site site = goodFloor();
  site.placements[kInner].origin.x += Metres{0.0004};
  EXPECT_EQ(listOf(checkSite(site).faults()), "");
}

TEST(TileFaults, brickworkIsALatticeToo) {
  Site site = goodFloor();
  for (std::size_t i = 5; i < 10; ++i) site.placements[i].origin.x += Metres{0.3};
  site.zones.clear();
  EXPECT_TRUE(faultsOf(site, FaultKind::TileOffLattice).empty());
}

TEST(TileFaults, turnedTilesAreComparedWhereTheyLie) {
  Site site = goodFloor();
  site.placements[kInner].quarterTurns = 2;
  site.placements[kInner].origin = site.placements[kInner].origin + Offset{Metres{0.6}, Metres{0.6}};
  EXPECT_EQ(listOf(checkSite(site).faults()), "");
}

TEST(TileFaults, namesThatStandTwiceOrForNothing) {
  Site site = goodFloor();
  site.tiles.push_back(site.tiles[0]);
  EXPECT_TRUE(only(site, FaultKind::TileTwice).fix);
  site.tiles.back().uids.clear();
  // Of two that differ none is forgotten.
  EXPECT_THAT(only(site, FaultKind::TileTwice).fix->sentence.english(), HasSubstr("\"T-0001-2\" instead"));
  site.placements.push_back({"T-0001-2", at(9, 9), 0});
  EXPECT_THAT(only(site, FaultKind::TileTwice).fix->sentence.english(), HasSubstr("\"T-0001-3\" instead"))
      << "it would come to lie there";
  site = goodFloor();
  site.placements.push_back({site.tiles[0].serial, at(9, 9), 0});
  EXPECT_THAT(only(site, FaultKind::TileLaidTwice).sentence.english(), HasSubstr("(9.00, 9.00)"));
  site = goodFloor();
  site.placements.push_back({"ghost", at(9, 9), 0});
  EXPECT_THAT(only(site, FaultKind::TileUnknown).sentence.english(), HasSubstr("\"ghost\""));
  site = goodFloor();
  site.tiles[0].type = "moon";
  EXPECT_THAT(only(site, FaultKind::TileTypeUnknown).sentence.english(), HasSubstr("\"moon\""));
  site = goodFloor();
  site.tileTypes.push_back(site.tileTypes[0]);
  EXPECT_EQ(only(site, FaultKind::TileTypeTwice).severity, Severity::Error);
}

TEST(TileFaults, aPlaceThatIsNoNumber) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    Site site = goodFloor();
    site.placements[0].origin.x = Metres{bad};
    EXPECT_EQ(only(site, FaultKind::PlaceNoNumber).objects.front().name, "T-0001");
  }
}

TEST(TileFaults, aUidAtTwoPlacesNamesBoth) {
  Site site = goodFloor();
  site.tiles[7].uids[1] = site.tiles[2].uids[4];
  const Fault fault = only(site, FaultKind::UidTwice);
  EXPECT_THAT(fault.sentence.english(), HasSubstr("tag 5 of tile \"T-0003\" and as tag 2 of tile \"T-0008\""));
  EXPECT_EQ(fault.severity, Severity::Error);
  ASSERT_TRUE(fault.place);
  ASSERT_TRUE(fault.fix && mend(fault.fix->edit, site));
  EXPECT_TRUE(faultsOf(site, FaultKind::UidTwice).empty());
  site.looseTags = {{site.tiles[0].uids[0], at(1, 1)}};
  const Fault loose = only(site, FaultKind::UidTwice);
  EXPECT_THAT(loose.sentence.english(), HasSubstr("a loose tag at (1.00, 1.00) m"));
  ASSERT_TRUE(mend(loose.fix->edit, site));
  EXPECT_TRUE(site.looseTags.empty());
}

TEST(TileFaults, aUidTwiceMisleadsNobodyWhileOneTileIsNotLaid) {
  Site site = goodFloor();
  site.tiles.push_back({"spare", site.tileTypes[0].name, site.tiles[0].uids});
  const Faults faults = faultsOf(site, FaultKind::UidTwice);
  ASSERT_EQ(faults.size(), 8U);
  EXPECT_EQ(faults.front().severity, Severity::Warning);
  EXPECT_TRUE(floor::SiteMap::build(site));
}

TEST(TileFaults, tilesWithoutUids) {
  Site site = goodFloor();
  site.tiles[4].uids.clear();
  site.tiles[5].uids[0] = {};
  EXPECT_THAT(only(site, FaultKind::TileUnregistered).sentence.english(), HasSubstr("\"T-0005\""));
  EXPECT_THAT(only(site, FaultKind::TilePartlyRegistered).sentence.english(), HasSubstr("7 of its 8"));
  site.tiles[6].uids.resize(9, site.tiles[6].uids[0]);
  EXPECT_THAT(only(site, FaultKind::TooManyUids).sentence.english(), HasSubstr("9 UIDs"));
}

TEST(TileFaults, beyondAThousandOfAKindTheRestIsCounted) {
  Site site = floor::Site{};
  site.tileTypes = goodFloor().tileTypes;
  for (int i = 0; i < 1500; ++i) {
    site.tiles.push_back({"T" + std::to_string(i), site.tileTypes[0].name, {}});
    site.placements.push_back({site.tiles.back().serial, at(0.6 * i, 0), 0});
  }
  const Faults faults = faultsOf(site, FaultKind::TileUnregistered);
  ASSERT_EQ(faults.size(), 1001U);
  EXPECT_THAT(faults.back().sentence.english(), HasSubstr("one by one: 500"));
  EXPECT_NEAR(faults.back().place->high.x.value(), 900.0, 1e-6);
  const std::size_t others = 2;  // no vehicle, no running zone
  const Verdict verdict = checkSite(site);
  EXPECT_EQ(verdict.count(Severity::Warning) - others, 1500U);
  EXPECT_EQ(verdict.size() - others, 1500U);
  // A tile that gets some of its tags is a fault of another kind: the count stays.
  for (int i = 0; i < 3; ++i)
    site.tiles[static_cast<std::size_t>(i)].uids = {floor::TagUid::parse("04AABBC" + std::to_string(i)).value()};
  EXPECT_EQ(checkSite(site).size(), verdict.size());
  CheckOptions all;
  all.mostOfAKind = 1500;
  EXPECT_EQ(checkSite(site, all).faults().size(), verdict.size()) << "no sentence stands for others";
}

TEST(TileFaults, nothingAtAll) {
  EXPECT_EQ(faultsOf({}, FaultKind::NoTags).size(), 1U);
  EXPECT_EQ(faultsOf({}, FaultKind::NoVehicle).size(), 1U);
  EXPECT_EQ(faultsOf({}, FaultKind::NoRunningZone).size(), 1U);
  EXPECT_EQ(checkSite({}).count(Severity::Error), 0U);
}

TEST(Faults, eachKindHasACodeOfItsOwn) {
  std::set<std::string_view> codes;
  for (std::size_t i = 0; i < kFaultKinds; ++i) {
    const auto code = codeOf(static_cast<FaultKind>(i));
    EXPECT_FALSE(code.empty());
    EXPECT_TRUE(codes.insert(code).second) << code;
  }
}

}  // namespace
}  // namespace tessera::sitecheck
