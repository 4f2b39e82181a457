// Sites go in and come out bit by bit, whatever they are; and only what differs is written.
#include "store/site_store.h"

#include <bit>
#include <cmath>
#include <limits>

#include "floor/random_site.h"
#include "floor/route_legs.h"
#include "floor/site_json.h"
#include "floor/site_map.h"
#include "store/store_fixture.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

class Sites : public test::StoreTest {
protected:
  Sites() : database_{open()}, store_{*database_} {}
  floor::Site loaded(const std::string& key) {
    auto site = store_.load(key);
    if (!site || !*site) {
      ADD_FAILURE() << (site ? "nothing is kept as " + key : site.error().sentence.english());
      return {};
    }
    return **site;
  }
  qint64 rowsChanged() {
    Transaction reading{*database_, Transaction::Kind::Read};
    Statement row{reading, QStringLiteral("SELECT total_changes()")};
    row.run();
    return row.next() ? row.whole(0) : -1;
  }

  std::unique_ptr<Database> database_;
  SiteStore store_;
};

TEST_F(Sites, comeBackEqualWhateverTheyAre) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const floor::Site site = floor::randomSite(seed);
    // Under one key: each takes the place of another, of which nothing may stay.
    const auto saved = store_.save("same", site, static_cast<std::int64_t>(seed), true);
    ASSERT_TRUE(saved) << seed << ": " << saved.error().sentence;
    const floor::Site back = loaded("same");
    ASSERT_EQ(back, site) << seed;
    ASSERT_EQ(floor::writeSite(back), floor::writeSite(site)) << seed;
  }
}

TEST_F(Sites, thatTheProgramBringsComeBackToTheByte) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator{TESSERA_SITES}) {
    if (!entry.path().string().ends_with(".tessera.json")) continue;
    const std::string text = bytesOf(entry.path());
    const auto site = floor::parseSite(text, entry.path().string());
    ASSERT_TRUE(site) << site.error().sentence;
    const std::string key = keyOfFile(entry.path());
    ASSERT_TRUE(store_.save(key, *site, 1, false));
    EXPECT_EQ(floor::writeSite(loaded(key)), text) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 2);
}

TEST_F(Sites, keepEveryBitOfADouble) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<double> awkward{
      -0.0, 0.0, 0.1, 1.0 / 3.0, tiny, std::nextafter(1.0, 2.0), 1e22, -7.0, 1e300, std::numeric_limits<double>::max()};
  floor::Site site;
  site.northToY = Radians{-0.0};
  site.routes.push_back({"r", {}, Metres{-0.0}});
  for (const double x : awkward) site.routes[0].vertices.push_back({Metres{x}, Metres{-x}});
  floor::setLegSpeed(site.routes[0], 2, MetresPerSecond{1.0 / 3.0});
  site.zones.push_back({"z", floor::ZoneKind::Slow, {}, MetresPerSecond{-0.0}, Radians{3.0}});
  ASSERT_TRUE(store_.save("k", site, 1, true));
  const floor::Site back = loaded("k");
  const auto same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  };
  for (std::size_t i = 0; i < awkward.size(); ++i) {
    EXPECT_TRUE(same(back.routes[0].vertices[i].x.value(), awkward[i])) << awkward[i];
    EXPECT_TRUE(same(back.routes[0].vertices[i].y.value(), -awkward[i])) << awkward[i];
  }
  EXPECT_TRUE(same(back.northToY.value(), -0.0));
  EXPECT_TRUE(same(back.routes[0].controlSpacing.value(), -0.0));
  EXPECT_TRUE(same(back.routes[0].legSpeeds.at(2)->value(), 1.0 / 3.0));
  EXPECT_TRUE(same(back.zones[0].speed->value(), -0.0));
}

TEST_F(Sites, keepNamesWithAnyCharacterAndRefuseBytesThatAreNone) {
  floor::Site site;
  site.name = std::string{"a\0b", 3} + "\xEF\xBF\xBE 地 'x\"; DROP TABLE site; --";
  site.routes.push_back({site.name, {}, {}});
  site.routes.push_back({"\xEF\xBB\xBFwith a byte order mark", {}, {}});
  site.routes.push_back({"\xEF\xBF\xBFU+FFFF", {}, {}});
  ASSERT_TRUE(store_.save("k", site, 1, true));
  EXPECT_EQ(loaded("k"), site);
  floor::Site wrong = site;
  wrong.routes[0].name = "\xC3\x28";
  const auto saved = store_.save("k", wrong, 2, true);
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().sentence.english().find("no valid text"), std::string::npos);
  wrong = site;
  wrong.name = "\xC3\x28";
  EXPECT_FALSE(store_.save("k", wrong, 2, true));
  wrong = site;
  wrong.routes[0].vertices.push_back({Metres{std::nan("")}, Metres{0}});
  EXPECT_FALSE(store_.save("k", wrong, 2, true)) << "what is no number would come back as 0";
  EXPECT_EQ(loaded("k"), site) << "the failures changed nothing";
}

TEST_F(Sites, writeOnlyTheSectionThatDiffers) {
  floor::Site site;
  site.tileTypes.push_back({"T", Metres{1}, Metres{1}, Metres{1}, {}, 1, 1, floor::Pattern::Full, false, {}});
  for (int i = 0; i < 1000; ++i) site.tiles.push_back({"S" + std::to_string(i), "T", {floor::TagUid{}}});
  site.routes.push_back({"r", {{}, {}}, {}});
  ASSERT_TRUE(store_.save("k", site, 1, true));
  const qint64 before = rowsChanged();
  ASSERT_TRUE(store_.save("k", site, 2, true));
  const qint64 same = rowsChanged();
  EXPECT_LE(same - before, 1) << "an equal site: its head alone";
  site.routes[0].vertices.push_back({Metres{1}, Metres{1}});
  ASSERT_TRUE(store_.save("k", site, 3, true));
  EXPECT_LE(rowsChanged() - same, 10) << "a route: its vertices, not the tiles";
  EXPECT_EQ(loaded("k"), site);
}

TEST_F(Sites, writeAPictureOnceHoweverOftenItIsMoved) {
  floor::Site site;
  site.backdrop = floor::Backdrop{"hall.png", std::make_shared<const std::string>(3'000'000, '\0'), {}, {}, {}, 0.5};
  ASSERT_TRUE(store_.save("k", site, 1, true));
  const qint64 rows = rowsChanged();
  site.backdrop->origin.x = Metres{3};
  ASSERT_TRUE(store_.save("k", site, 2, true));
  EXPECT_EQ(rowsChanged() - rows, 4) << "head, place (taken away and put there), the section's fingerprint";
  EXPECT_EQ(loaded("k"), site);
  site.backdrop->picture = std::make_shared<const std::string>("\0other", 6);
  ASSERT_TRUE(store_.save("k", site, 3, true));
  EXPECT_EQ(loaded("k"), site);
  site.backdrop.reset();
  ASSERT_TRUE(store_.save("k", site, 4, true));
  EXPECT_EQ(loaded("k"), site);
}

TEST_F(Sites, ofADatabaseFromBeforePicturesAreKeptAndMayGetOne) {
  floor::Site site = floor::randomSite(7);
  site.backdrop.reset();
  ASSERT_TRUE(store_.save("k", site, 1, true));
  backTo(2);
  const auto newer = open();
  ASSERT_NE(newer, nullptr);
  EXPECT_EQ(SiteStore{*newer}.load("k").value(), site);
  site.backdrop = floor::Backdrop{"hall.png", std::make_shared<const std::string>("picture"), {}, {}, {}, 0.5};
  ASSERT_TRUE(SiteStore{*newer}.save("k", site, 2, true));
  EXPECT_EQ(SiteStore{*newer}.load("k").value(), site);
}

TEST_F(Sites, noticeWhatAnotherCopyOfTheProgramWrote) {
  const floor::Site first = floor::randomSite(1);
  const floor::Site second = floor::randomSite(2);
  ASSERT_TRUE(store_.save("k", first, 1, true));
  const auto other = open();
  ASSERT_TRUE(SiteStore{*other}.save("k", second, 2, true));
  ASSERT_TRUE(store_.save("k", first, 3, true));
  EXPECT_EQ(SiteStore{*other}.load("k").value(), first);
}

TEST_F(Sites, areListedLatestFirstWithWhetherTheirFileLacksEdits) {
  const std::string fresh = freshKey();
  floor::Site site;
  site.name = "Old";
  ASSERT_TRUE(store_.save("/a/old.tessera.json", site, 10, false));
  site.name = "New";
  ASSERT_TRUE(store_.save(fresh, site, 20, true));
  const auto list = store_.list().value();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0], (KeptSite{fresh, "New", 20, true}));
  EXPECT_TRUE(list[0].file().empty());
  EXPECT_EQ(list[1], (KeptSite{"/a/old.tessera.json", "Old", 10, false}));
  EXPECT_EQ(list[1].file(), "/a/old.tessera.json");
  ASSERT_TRUE(store_.setDiffers("/a/old.tessera.json", true));
  EXPECT_TRUE(store_.find("/a/old.tessera.json").value()->differsFromFile);
  EXPECT_EQ(store_.find("nobody").value(), std::nullopt);
  EXPECT_EQ(store_.load("nobody").value(), std::nullopt);
  EXPECT_NE(freshKey(), fresh);
}

TEST_F(Sites, goOnUnderAnotherKeyAndLeaveNothingBehind) {
  const floor::Site mine = floor::randomSite(3);
  ASSERT_TRUE(store_.save("unsaved:1", mine, 1, true));
  ASSERT_TRUE(store_.save("/a", floor::randomSite(4), 1, false));
  ASSERT_TRUE(store_.rename("unsaved:1", "/a"));
  EXPECT_EQ(loaded("/a"), mine);
  EXPECT_EQ(store_.list().value().size(), 1U);
  ASSERT_TRUE(store_.rename("nobody", "/a"));
  EXPECT_EQ(loaded("/a"), mine) << "nobody took its place";
  ASSERT_TRUE(store_.rename("/a", "/a"));
  ASSERT_TRUE(store_.remove("/a"));
  EXPECT_TRUE(store_.list().value().empty());
  Transaction reading{*database_, Transaction::Kind::Read};
  for (const char* table : {"tile", "tag", "placement", "loose_tag", "route_vertex", "vehicle_reader", "section"}) {
    Statement row{reading, QStringLiteral("SELECT count(*) FROM ") + QLatin1String{table}};
    row.run();
    ASSERT_TRUE(row.next());
    EXPECT_EQ(row.whole(0), 0) << table;
  }
}

TEST_F(Sites, haveOneKeyForOneFileHoweverItIsNamed) {
  write(folder() / "site.tessera.json", "{}");
  std::filesystem::create_symlink("site.tessera.json", folder() / "link.tessera.json");
  const std::string key = keyOfFile(folder() / "site.tessera.json");
  EXPECT_EQ(keyOfFile(folder() / "." / ".." / folder().filename() / "site.tessera.json"), key);
  EXPECT_EQ(keyOfFile(folder() / "link.tessera.json"), key);
  EXPECT_TRUE(std::filesystem::path{keyOfFile("some.tessera.json")}.is_absolute());
}

TEST_F(Sites, withRowsThatNobodyWroteGiveASentence) {
  ASSERT_TRUE(store_.save("k", floor::randomSite(5), 1, true));
  for (const char* sql :
       {"INSERT INTO tag VALUES(1, 12345, 0, x'00112233')", "INSERT INTO loose_tag VALUES(1, 99, x'00', 0, 0)",
        "INSERT INTO zone VALUES(1, 99, 'z', 'disco', NULL, NULL)"}) {
    const auto database = open();
    {
      Transaction writing{*database, Transaction::Kind::Write};
      writing.run(QLatin1String{sql});
      ASSERT_TRUE(writing.commit()) << sql;
    }
    const auto site = store_.load("k");
    ASSERT_FALSE(site) << sql;
    EXPECT_NE(site.error().sentence.english().find("damaged"), std::string::npos);
    // The next saving of that section mends it only if it differs; so start anew.
    ASSERT_TRUE(store_.remove("k"));
    ASSERT_TRUE(store_.save("k", floor::randomSite(5), 1, true));
  }
}

}  // namespace
}  // namespace tessera::store
