// Another site's file added to the open one: what is new comes, what is there stays, and nothing is left half done.
#include "exchange/site_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "floor/random_site.h"
#include "floor/site_json.h"
#include "floor/site_map.h"
#include "sitecheck/sites.h"

namespace tessera::exchange {
namespace {

using floor::Site;
using sitecheck::at;
using sitecheck::goodFloor;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Result<Preview> add(const Site& onto, const Site& from) { return importSite(onto, writeSite(from), "f.tessera.json"); }

std::string errorOf(const Site& onto, const Site& from) {
  const auto preview = add(onto, from);
  return preview ? std::string{} : preview.error().sentence.english();
}

std::vector<std::string> notesOf(const Preview& preview) {
  std::vector<std::string> all;
  for (const Sentence& note : preview.notes) all.push_back(note.english());
  return all;
}

/// A hall of its own beside goodFloor(), with the same tile type.
Site annex() {
  Site site = goodFloor();
  site.name = "Annex";
  for (auto& tile : site.tiles) {
    tile.serial = "X" + tile.serial;
    tile.uids.clear();
  }
  for (auto& placement : site.placements) {
    placement.serial = "X" + placement.serial;
    placement.origin = placement.origin + Offset{Metres{50}, Metres{0}};
  }
  site.tiles[0].uids = {floor::TagUid::parse("04AABBCC").value()};
  site.looseTags = {{floor::TagUid::parse("04AABBCD").value(), at(70, 0)}};
  site.zones = {sitecheck::zone("annex", floor::ZoneKind::Running, sitecheck::rectangle(50, 0, 53, 2.4))};
  site.routes = {{"annex", {at(50.4, 0.4), at(52.6, 0.4)}, Metres{0.2}}};
  site.vehicles = {goodFloor().vehicles.front()};
  site.vehicles[0].id = VehicleId{9};
  return site;
}

TEST(SiteImport, addsAllThatIsNew) {
  const Site onto = goodFloor();
  const Site from = annex();
  const auto preview = add(onto, from);
  ASSERT_TRUE(preview) << preview.error().sentence;
  const Site& both = preview->site;
  EXPECT_EQ(both.name, onto.name);
  EXPECT_EQ(both.tileTypes, onto.tileTypes) << "the same type comes once";
  EXPECT_EQ(both.tiles.size(), onto.tiles.size() + from.tiles.size());
  EXPECT_EQ(both.placements.size(), onto.placements.size() + from.placements.size());
  EXPECT_EQ(both.looseTags, from.looseTags);
  EXPECT_EQ(both.zones.size(), onto.zones.size() + 1);
  EXPECT_EQ(both.routes.size(), onto.routes.size() + 1);
  EXPECT_EQ(both.vehicles.back().id, VehicleId{9});
  EXPECT_EQ((*floor::SiteMap::build(both))->find(floor::TagUid::parse("04AABBCC").value()),
            (*floor::SiteMap::build(from))->find(floor::TagUid::parse("04AABBCC").value()));
  EXPECT_THAT(preview->notes, IsEmpty());
  for (const auto& change : preview->changes) EXPECT_EQ(change.kind, sitediff::ChangeKind::Added) << change.sentence;
}

TEST(SiteImport, onceMoreChangesNothing) {
  const Site both = add(goodFloor(), annex())->site;
  for (const Site& again : {annex(), goodFloor(), both}) {
    const auto preview = add(both, again);
    ASSERT_TRUE(preview) << preview.error().sentence;
    EXPECT_EQ(preview->site, both);
    EXPECT_TRUE(preview->changes.empty());
    EXPECT_THAT(preview->notes, IsEmpty());
  }
}

TEST(SiteImport, ofAnythingOntoAnEmptySiteIsThatSite) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Site from = floor::randomSite(seed);
    const auto map = floor::SiteMap::build(from);
    const auto preview = add({}, from);
    ASSERT_EQ(preview.has_value(), map.has_value()) << seed;
    if (!preview) continue;
    from.name.clear();
    from.northToY = {};
    from.radio = {};
    from.backdrop.reset();
    if (!(preview->site == from)) {
      // Zones may share a name, which then is taken.
      EXPECT_LT(preview->site.zones.size(), from.zones.size()) << seed;
    }
  }
}

TEST(SiteImport, leavesWhatIsThereAsItIsAndSaysSo) {
  const Site onto = goodFloor();
  Site from = annex();
  from.tiles.push_back(onto.tiles[3]);
  from.tiles.back().uids = {};
  from.placements.push_back({onto.tiles[3].serial, at(90, 0), 0});
  from.placements.push_back({onto.tiles[4].serial, at(95, 0), 0});
  from.tiles.push_back(onto.tiles[4]);
  from.routes.push_back(onto.routes[0]);
  from.routes.back().vertices.back().x = Metres{2};
  from.vehicles.push_back(onto.vehicles[0]);
  from.vehicles.back().name = "other";
  from.northToY = Radians{1.0};
  const auto preview = add(onto, from);
  ASSERT_TRUE(preview) << preview.error().sentence;
  const Site& both = preview->site;
  EXPECT_TRUE(std::equal(onto.tiles.begin(), onto.tiles.end(), both.tiles.begin()));
  EXPECT_TRUE(std::equal(onto.placements.begin(), onto.placements.end(), both.placements.begin()));
  EXPECT_EQ(both.routes[0], onto.routes[0]);
  EXPECT_EQ(both.vehicles[0], onto.vehicles[0]);
  const std::string serial = onto.tiles[3].serial;
  const auto notes = notesOf(*preview);
  EXPECT_THAT(notes, Contains(HasSubstr("Tile \"" + serial + "\" is here already")));
  EXPECT_THAT(notes, Contains(HasSubstr("Tile \"" + onto.tiles[4].serial + "\" is laid here already")));
  EXPECT_THAT(notes, Contains(HasSubstr("Route \"round\" is here already")));
  EXPECT_THAT(notes, Contains(HasSubstr("Address 1 is a vehicle's here already")));
  EXPECT_THAT(notes, Contains(HasSubstr("north")));
  EXPECT_EQ(notes.size(), 5U);
}

TEST(SiteImport, countsWhatIsTooMuchToReadOneByOne) {
  Site from = goodFloor();
  for (auto& tile : from.tiles) tile.uids.clear();
  const auto preview = add(goodFloor(), from);
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->site, goodFloor());
  EXPECT_EQ(preview->notes.size(), 6U);
  EXPECT_THAT(preview->notes.back().english(), HasSubstr("15"));
}

TEST(SiteImport, saysThatTilesComeToLieUponOthers) {
  Site from = annex();
  for (auto& placement : from.placements) placement.origin = placement.origin - Offset{Metres{50.3}, Metres{0}};
  const auto preview = add(goodFloor(), from);
  ASSERT_TRUE(preview);
  EXPECT_THAT(notesOf(*preview), ElementsAre(HasSubstr("lie upon tiles that are here already: 20")));
  for (auto& placement : from.placements) placement.origin = placement.origin + Offset{Metres{3.3}, Metres{0}};
  EXPECT_THAT(notesOf(*add(goodFloor(), from)), IsEmpty()) << "beside them";
}

TEST(SiteImport, refusesTheWholeFileWhereItWouldContradictTheSite) {
  const Site onto = goodFloor();
  Site from = annex();
  from.tiles[7].uids = {onto.tiles[2].uids[1]};
  EXPECT_THAT(errorOf(onto, from),
              HasSubstr("f.tessera.json: tag " + onto.tiles[2].uids[1].text() +
                        " would be registered twice: as tag 2 of tile \"T-0003\" and as tag 1 of"));
  from = annex();
  from.looseTags[0].uid = onto.tiles[2].uids[1];
  EXPECT_THAT(errorOf(onto, from), HasSubstr("and as a loose tag"));
  from = annex();
  from.tileTypes[0].pitch = Metres{0.1};
  EXPECT_THAT(errorOf(onto, from), HasSubstr("which is another one in the open site"));
  from = annex();
  from.tiles.push_back(from.tiles[0]);
  EXPECT_THAT(errorOf(onto, from), HasSubstr("f.tessera.json: Two tiles have the serial number"));
  EXPECT_THAT(importSite(onto, "{}", "f.tessera.json").error().sentence.english(), HasSubstr("f.tessera.json"));
}

TEST(SiteImport, goesOntoASiteThatIsBeingMended) {
  Site onto = goodFloor();
  onto.routes.push_back(onto.routes[0]);
  const auto preview = add(onto, annex());
  ASSERT_TRUE(preview) << preview.error().sentence;
  EXPECT_EQ(preview->site.routes.size(), 3U);
}

}  // namespace
}  // namespace tessera::exchange
