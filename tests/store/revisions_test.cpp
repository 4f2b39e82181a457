// Revisions come back as the files that they were, and nothing that goes wrong with one touches the others.
#include "store/revisions.h"

#include "floor/random_site.h"
#include "floor/site_json.h"
#include "store/store_fixture.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

class RevisionsOfSites : public test::StoreTest {
protected:
  RevisionsOfSites() : database_{open()} {}
  Revisions revisions(Revisions::Limits limits = {}) { return Revisions{*database_, limits}; }
  bool add(const std::string& key, const floor::Site& site, std::int64_t when = 1, Revisions::Limits limits = {}) {
    const auto added = revisions(limits).add(key, site, {when, "Ada", "Lay tiles", false});
    if (!added) ADD_FAILURE() << added.error().sentence;
    return added.value_or(false);
  }
  std::vector<Revision> list(const std::string& key = "/a") { return revisions().list(key).value(); }
  std::int64_t count(const QString& table) {
    Transaction reading{*database_, Transaction::Kind::Read};
    Statement row{reading, QStringLiteral("SELECT count(*) FROM ") + table};
    row.run();
    return row.next() ? row.whole(0) : -1;
  }
  void spoil(const QString& sql) {
    Transaction writing{*database_, Transaction::Kind::Write};
    writing.run(sql);
    ASSERT_TRUE(writing.commit());
  }
  static floor::Site named(const std::string& name, int routes = 1) {
    floor::Site site = floor::randomSite(7);
    site.name = name;
    site.routes.clear();
    for (int n = 0; n < routes; ++n)
      site.routes.push_back({"r" + std::to_string(n), {{}, {Metres{1.0}, Metres{1.0 * n}}}, Metres{0.2}});
    return site;
  }

  std::unique_ptr<Database> database_;
};

TEST_F(RevisionsOfSites, comeBackAsTheirFileWould) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    floor::Site site = floor::randomSite(seed);
    if (site.name.empty()) site.name = "named";
    const std::string key = "/" + std::to_string(seed);
    ASSERT_TRUE(add(key, site)) << seed;
    const auto back = revisions().load(list(key).at(0).id);
    ASSERT_TRUE(back) << seed << ": " << back.error().sentence;
    const auto file = floor::parseSite(floor::writeSite(site), "file");
    ASSERT_TRUE(file) << seed << ": " << file.error().sentence;
    ASSERT_EQ(*back, *file) << seed;
    ASSERT_EQ(floor::writeSite(*back), floor::writeSite(site)) << seed;
  }
}

TEST_F(RevisionsOfSites, sayWhoWhenWhatAndHowMuch) {
  add("/a", named("Hall", 1), 100);
  add("/a", named("Hall", 3), 200);
  add("/b", named("Yard"), 300);
  const auto all = list();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].note, (RevisionNote{200, "Ada", "Lay tiles", false})) << "the newest first";
  EXPECT_EQ(all[0].changed, (sitediff::Tally{.routes = 2}));
  EXPECT_EQ(all[1].changed, std::nullopt) << "there is none before the first";
  EXPECT_EQ(list("/b").size(), 1U);
  EXPECT_TRUE(list("/nobody").empty());
}

TEST_F(RevisionsOfSites, areNotMadeWhereNothingChanged) {
  EXPECT_TRUE(add("/a", named("Hall"), 1));
  EXPECT_FALSE(add("/a", named("Hall"), 2));
  EXPECT_TRUE(add("/a", named("Hall", 2), 3));
  EXPECT_TRUE(add("/a", named("Hall"), 4)) << "back to what it was is a change again";
  EXPECT_EQ(list().size(), 3U);
}

TEST_F(RevisionsOfSites, keepOnceWhatASavingLeavesAlone) {
  add("/a", named("Hall", 1));
  const auto parts = count("revision_part");
  for (int n = 2; n <= 10; ++n) add("/a", named("Hall", n));
  EXPECT_EQ(count("revision_part"), parts + 9) << "nine times the routes, never again the tiles";
  const auto all = list();
  for (int n = 1; n <= 10; ++n)
    EXPECT_EQ(revisions().load(all.at(static_cast<std::size_t>(10 - n)).id).value(), named("Hall", n));
}

TEST_F(RevisionsOfSites, growCoarserInThePastAndKeepTheFirstAndTheNewest) {
  constexpr int kAll = 40;
  const Revisions::Limits limits{.count = 8};
  for (int n = 1; n <= kAll; ++n) add("/a", named("Hall", n), 1000 * n, limits);
  add("/b", named("Yard"), 1);
  const auto all = list();
  ASSERT_EQ(all.size(), 8U);
  EXPECT_EQ(all.back().note.savedUtcMs, 1000) << "the first";
  for (std::size_t n = 0; n < 4; ++n) EXPECT_EQ(all[n].note.savedUtcMs, 1000 * (kAll - static_cast<int>(n)));
  EXPECT_EQ(revisions().load(all.back().id).value(), named("Hall", 1)) << "its parts were not taken away";
  EXPECT_EQ(list("/b").size(), 1U);
  // One part for each state of the routes, two that all share, and two of the other site.
  EXPECT_LE(count("revision_part"), 8 + 2 + 2) << "what nobody has any more is gone";
}

TEST_F(RevisionsOfSites, keepWithinTheirBytes) {
  const Revisions::Limits limits{.bytes = 1};
  for (int n = 1; n <= 5; ++n) add("/a", named("Hall", n), n, limits);
  EXPECT_EQ(list().size(), 2U) << "the first and the newest stay whatever they weigh";
}

TEST_F(RevisionsOfSites, tellADamagedOneAndReadTheOthers) {
  add("/a", named("Hall", 1));
  add("/a", named("Hall", 2));
  for (const char* damage :
       {"UPDATE revision_part SET text=x'FFFFFFFF00' WHERE id=(SELECT rest FROM revision ORDER BY id LIMIT 1)",
        "UPDATE revision_part SET text=x'' WHERE id=(SELECT rest FROM revision ORDER BY id LIMIT 1)",
        "UPDATE revision_part SET text=(SELECT text FROM revision_part LIMIT 1)"
        " WHERE id=(SELECT rest FROM revision ORDER BY id LIMIT 1)"}) {
    spoil(QLatin1String{damage});
    const auto all = list();
    ASSERT_EQ(all.size(), 2U);
    const auto bad = revisions().load(all[1].id);
    ASSERT_FALSE(bad) << damage;
    EXPECT_EQ(
        bad.error().sentence,
        file().string() + ": this revision is damaged and cannot be read. The others and the site are as they were.");
    EXPECT_EQ(revisions().load(all[0].id).value(), named("Hall", 2));
  }
  EXPECT_EQ(revisions().load(4711).error().sentence, "This revision is no longer kept: newer ones took its place.");
}

TEST_F(RevisionsOfSites, goOnAfterADamagedOneWithoutItsNumbers) {
  add("/a", named("Hall", 1));
  spoil("UPDATE revision_part SET text=x'00'");
  EXPECT_TRUE(add("/a", named("Hall", 2)));
  EXPECT_EQ(list()[0].changed, std::nullopt);
}

TEST_F(RevisionsOfSites, areWholeOrNotAtAllOnAFullDisk) {
  add("/a", named("Hall", 1));
  const auto parts = count("revision_part");
  database_.reset();
  database_ = open({.maxPages = 60});
  floor::Site large = named("Hall");
  for (int n = 0; n < 60'000; ++n)
    large.routes.push_back(
        {std::to_string(n * 7919 % 60'013), {{}, {Metres{0.001 * (n * 7907 % 99'991)}, Metres{}}}, {}});
  const auto added = revisions().add("/a", large, {2, "", "", false});
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().sentence, file().string() + ": the disk is full. Make room on it.");
  EXPECT_EQ(list().size(), 1U);
  EXPECT_EQ(count("revision_part"), parts);
  EXPECT_TRUE(add("/a", named("Hall", 2))) << "and a smaller one still goes";
}

TEST_F(RevisionsOfSites, areKnownToADatabaseThatAnOlderProgramMade) {
  spoil("INSERT INTO journal VALUES(1, 1, '', NULL, 0, 'k', 0, 's', NULL, NULL)");
  database_.reset();
  ASSERT_NO_FATAL_FAILURE(backTo(3));
  database_ = open();
  ASSERT_NE(database_, nullptr);
  EXPECT_EQ(count("journal"), 1) << "what it held is there still";
  EXPECT_TRUE(add("/a", named("Hall")));
}

TEST_F(RevisionsOfSites, goOnUnderAnotherName) {
  ASSERT_TRUE(add("/a", named("a"), 1));
  ASSERT_TRUE(add("/a", named("a", 2), 2));
  const auto parts = count("revision_part");
  ASSERT_TRUE(revisions().copy("/a", "/b"));
  ASSERT_TRUE(add("/b", named("a", 3), 3));
  EXPECT_EQ(list("/a").size(), 2U) << "the old file keeps its own";
  const auto both = list("/b");
  ASSERT_EQ(both.size(), 3U);
  EXPECT_EQ(both[1].note, list("/a")[0].note);
  EXPECT_EQ(both[0].changed->routes, 1) << "counted against the one before it";
  EXPECT_EQ(revisions().load(both[2].id).value().routes.size(), 1U);
  EXPECT_EQ(count("revision_part"), parts + 1) << "what is the same is kept once";
  ASSERT_TRUE(add("/c", named("c"), 4));
  ASSERT_TRUE(revisions().copy("/a", "/c"));
  EXPECT_EQ(list("/c").size(), 1U) << "a file that is written over keeps its own past";
  ASSERT_TRUE(revisions().copy("/nothing", "/d"));
  EXPECT_TRUE(list("/d").empty());
}

TEST_F(RevisionsOfSites, areTakenAlongByAFileThatWasMoved) {
  ASSERT_TRUE(add("/a", named("a"), 1));
  ASSERT_TRUE(add("/a", named("a", 2), 2));
  ASSERT_TRUE(revisions().adopt("/moved", named("a", 2)));
  EXPECT_EQ(list("/moved").size(), 2U);
  const auto added = revisions().add("/moved", named("a", 2), {3, "", "", true});
  ASSERT_TRUE(added);
  EXPECT_FALSE(*added) << "it is what the newest is";
  ASSERT_TRUE(revisions().adopt("/other", named("a")));
  EXPECT_TRUE(list("/other").empty()) << "an older state may be anybody's";
  ASSERT_TRUE(revisions().adopt("/moved", named("a", 2)));
  EXPECT_EQ(list("/moved").size(), 2U) << "once";
}

}  // namespace
}  // namespace tessera::store
