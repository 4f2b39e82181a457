// A site that is kept again and again: what has changed since is written, and what is read is the whole site all the
// same.
#include <random>

#include "floor/new_floor.h"
#include "floor/random_site.h"
#include "store/site_store.h"
#include "store/store_fixture.h"

namespace tessera::store {
namespace {

class ChangedRows : public test::StoreTest {
protected:
  ChangedRows() : database_{open()}, store_{*database_} {}
  void SetUp() override {
    site = floor::layNewFloor({"f", floor::usualTileTypes().front(), 40, 25, false}).value();
    for (std::size_t i = 0; i < site.tiles.size(); ++i)
      for (std::size_t n = 0; n < 8; ++n) site.tiles[i].uids.push_back(uid(8 * i + n));
    keep();
  }
  static floor::TagUid uid(std::size_t n) {
    const std::array<std::uint8_t, 4> bytes{0x04, static_cast<std::uint8_t>(n >> 16U),
                                            static_cast<std::uint8_t>(n >> 8U), static_cast<std::uint8_t>(n)};
    return floor::TagUid::fromBytes(bytes).value();
  }
  void keep() {
    const auto map = floor::SiteMap::build(site, floor::Ambiguity::Carried);
    ASSERT_TRUE(map) << map.error().sentence;
    const auto saved = store_.save("k", *map, ++time_, true, last);
    ASSERT_TRUE(saved) << saved.error().sentence;
    ASSERT_EQ(store_.load("k").value(), site);
  }
  qint64 rows() {
    Transaction reading{*database_, Transaction::Kind::Read};
    Statement row{reading, QStringLiteral("SELECT total_changes()")};
    row.run();
    return row.next() ? row.whole(0) : -1;
  }
  qint64 rowsToKeep() {
    const qint64 before = rows();
    keep();
    return rows() - before;
  }

  std::unique_ptr<Database> database_;
  SiteStore store_;
  floor::Site site;
  LastWritten last;
  std::int64_t time_ = 0;
};

TEST_F(ChangedRows, areWrittenAndNoneElse) {
  EXPECT_LE(rowsToKeep(), 1) << "nothing has changed";
  site.tiles[500].uids[3] = uid(99'999);
  EXPECT_LE(rowsToKeep(), 20) << "one tile of a thousand, with its eight tags";
  site.placements[7].origin.x += Metres{0.01};
  EXPECT_LE(rowsToKeep(), 4);
  site.tiles[999].uids.clear();
  EXPECT_LE(rowsToKeep(), 12);
  site.tiles.pop_back();
  site.placements.pop_back();
  EXPECT_LE(rowsToKeep(), 6);
  site.routes.push_back({"r", {{}, {Metres{1}, Metres{1}}}, Metres{0.2}});
  EXPECT_LE(rowsToKeep(), 6);
  for (auto& tile : site.tiles) tile.uids.clear();
  EXPECT_GT(rowsToKeep(), 900) << "a whole floor";
}

TEST_F(ChangedRows, areNotTrustedWhereAnotherCopyOfTheProgramHasWritten) {
  site.tiles[1].uids[0] = uid(50'000);
  keep();
  const floor::Site other = floor::randomSite(2);
  const auto second = open();
  ASSERT_TRUE(SiteStore{*second}.save("k", other, 2, true));
  site.tiles[2].uids[0] = uid(50'001);
  keep();
  ASSERT_TRUE(SiteStore{*second}.save("k", site, 3, true)) << "who finds the mark of a part writes the whole";
  EXPECT_EQ(SiteStore{*second}.load("k").value(), site);
  site.tiles[3].uids[0] = uid(50'002);
  keep();
  ASSERT_TRUE(store_.remove("k"));
  keep();
}

TEST_F(ChangedRows, areForgottenWhereWritingFailed) {
  const floor::Site before = site;
  site.tiles[1].uids[0] = uid(50'000);
  site.name = "\xC3\x28";  // no text
  EXPECT_FALSE(store_.save("k", floor::SiteMap::build(site).value(), 9, true, last));
  EXPECT_EQ(store_.load("k").value(), before);
  site.name = "f";
  keep();
}

TEST_F(ChangedRows, giveTheSiteBackAfterAnyEdits) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random{seed};
    const auto any = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    for (std::size_t n = any(4); n > 0; --n) {
      switch (any(6)) {
        case 0:
          site.tiles[any(site.tiles.size())].uids.resize(any(9));
          break;
        case 1:
          site.placements[any(site.placements.size())].quarterTurns = static_cast<int>(any(4));
          break;
        case 2: {
          const std::string serial = "N-" + std::to_string(seed) + "-" + std::to_string(n);
          site.tiles.push_back({serial, site.tileTypes.front().name, {uid(60'000 + 10 * seed + n)}});
          site.placements.push_back(
              {serial, {Metres{100.0 + static_cast<double>(seed)}, Metres{static_cast<double>(n)}}, 0});
          break;
        }
        case 3:
          site.tiles.pop_back();
          site.placements.pop_back();
          break;
        case 4:
          site.tiles.erase(site.tiles.begin() + 3);
          site.placements.erase(site.placements.begin() + 3);
          break;
        default:
          site.zones.push_back({"z" + std::to_string(seed) + std::to_string(n), floor::ZoneKind::Running, {}, {}, {}});
      }
    }
    ASSERT_NO_FATAL_FAILURE(keep()) << seed;
  }
}

}  // namespace
}  // namespace tessera::store
