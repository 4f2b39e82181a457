// A table of tags mended after an edit is the one that would be made anew.
#include "floor/tag_change.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "floor/new_floor.h"
#include "floor/site_map.h"

namespace tessera::floor {
namespace {

using Tags = std::set<std::tuple<TagUid, double, double>>;

Tags asSet(const std::vector<PlacedTag>& tags) {
  Tags set;
  for (const PlacedTag& tag : tags) set.emplace(tag.uid, tag.place.x.value(), tag.place.y.value());
  return set;
}

std::shared_ptr<const TagTable> tableOf(const Site& site) {
  return TagTable::build(SiteMap::build(site).value()->tags()).value();
}

std::shared_ptr<const TagTable> mended(const TagTable& table, const Site& before, const Site& after) {
  const auto change = tagChange(before, after, SitePatch{before, after});
  return change ? table.changed(change->removed, change->added) : nullptr;
}

class TagChanges : public testing::Test {
protected:
  Point anywhere() {
    return {Metres{0.01 * static_cast<double>(random() % 600)}, Metres{0.01 * static_cast<double>(random() % 500)}};
  }
  TagUid fresh() {
    const std::uint32_t n = ++made;
    const std::array<std::uint8_t, 7> uid{
        0x0A, static_cast<std::uint8_t>(n >> 16), static_cast<std::uint8_t>(n >> 8), static_cast<std::uint8_t>(n), 1, 2,
        3};
    return TagUid::fromBytes(uid).value();
  }
  // One edit as the window makes them.
  void edit(Site& site) {
    const auto any = [this](auto& list) { return list.begin() + static_cast<std::ptrdiff_t>(random() % list.size()); };
    switch (random() % 8) {
      case 0:
        any(site.placements)->quarterTurns = static_cast<int>(random() % 4);
        break;
      case 1:
        any(site.placements)->origin = anywhere();
        break;
      case 2:
        any(any(site.tiles)->uids)[0] = fresh();
        break;
      case 3:
        any(any(site.tiles)->uids)[0] = {};
        break;
      case 4:
        site.looseTags.push_back({fresh(), anywhere()});
        break;
      case 5:
        if (!site.looseTags.empty()) site.looseTags.erase(any(site.looseTags));
        break;
      case 6:
        site.placements.erase(any(site.placements));
        break;
      default: {
        Tile tile{"N" + std::to_string(made), site.tileTypes[0].name, {fresh(), fresh(), {}, fresh()}};
        site.placements.push_back({tile.serial, anywhere(), static_cast<int>(random() % 4)});
        site.tiles.push_back(std::move(tile));
      }
    }
  }
  std::mt19937 random{5};
  std::uint32_t made = 0;
};

TEST_F(TagChanges, leadToTheTableThatWouldBeBuilt) {
  int ways = 0;
  for (int round = 0; round < 20; ++round) {
    Site site = layNewFloor({"Hall", usualTileTypes()[0], 10, 8, true}).value();
    auto table = tableOf(site);
    for (int step = 0; step < 40; ++step) {
      Site after = site;
      for (auto n = 1 + random() % 3; n-- > 0;) edit(after);
      auto built = tableOf(after);
      if (auto quick = mended(*table, site, after)) {
        ++ways;
        ASSERT_EQ(asSet(quick->tags()), asSet(built->tags())) << round << "." << step;
        for (const PlacedTag& tag : built->tags()) ASSERT_TRUE(quick->find(tag.uid)) << tag.uid.text();
        for (const PlacedTag& tag : table->tags()) ASSERT_EQ(quick->find(tag.uid), built->find(tag.uid));
        const Point centre = anywhere();
        const auto near = [centre](const TagTable& of) {
          std::vector<PlacedTag> found;
          of.forEachNear(centre, Metres{0.7}, [&found](const PlacedTag& tag) { found.push_back(tag); });
          return asSet(found);
        };
        ASSERT_EQ(near(*quick), near(*built)) << round << "." << step;
        built = quick;  // a long chain of mended ones
      }
      table = built;
      site = std::move(after);
    }
  }
  EXPECT_GT(ways, 400) << "most edits go the quick way";
}

TEST_F(TagChanges, areLeftToTheBuilderWhereSomethingIsAmbiguous) {
  const Site site = layNewFloor({"Hall", usualTileTypes()[0], 4, 4, true}).value();
  const auto table = tableOf(site);
  Site uidTwice = site;
  uidTwice.looseTags.push_back({site.tiles[0].uids[0], {}});
  EXPECT_EQ(mended(*table, site, uidTwice), nullptr);
  Site laidTwice = site;
  laidTwice.placements.push_back(site.placements[3]);
  EXPECT_EQ(mended(*table, site, laidTwice), nullptr);
  Site serialTwice = site;
  serialTwice.tiles[2].serial = site.tiles[1].serial;
  EXPECT_EQ(mended(*table, site, serialTwice), nullptr);
  Site unknown = site;
  unknown.placements.push_back({"nobody", {}, 0});
  EXPECT_EQ(mended(*table, site, unknown), nullptr);
  Site otherType = site;
  otherType.tileTypes[0].pitch = Metres{0.1};
  EXPECT_EQ(mended(*table, site, otherType), nullptr);
  Site farOff = site;
  farOff.placements[0].origin = {Metres{500.0}, {}};
  EXPECT_EQ(mended(*table, site, farOff), nullptr) << "another grid is needed";
}

TEST_F(TagChanges, areNoneWhereTilesAreKnownButNotLaid) {
  const Site site = layNewFloor({"Hall", usualTileTypes()[0], 4, 4, true}).value();
  Site after = site;
  after.tiles.push_back({"spare", site.tileTypes[0].name, {fresh()}});
  const auto change = tagChange(site, after, SitePatch{site, after});
  ASSERT_TRUE(change);
  EXPECT_TRUE(change->removed.empty());
  EXPECT_TRUE(change->added.empty());
}

}  // namespace
}  // namespace tessera::floor
