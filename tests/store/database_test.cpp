// The file itself: made, opened again, refused, and left as it is when it is not ours to touch.
#include "store/database.h"

#include <sys/stat.h>

#include "store/migrations.h"
#include "store/site_store.h"
#include "store/store_fixture.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

using testing::Test;

class DatabaseFile : public test::StoreTest {
protected:
  static int modeOf(const std::filesystem::path& path) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0 ? static_cast<int>(info.st_mode & 0777) : -1;
  }
  static std::string askFor(Database& database, const char* sql) {
    Transaction reading{database, Transaction::Kind::Read};
    Statement row{reading, QLatin1String{sql}};
    row.run();
    return row.next() ? row.text(0) : reading.failed() ? reading.error()->sentence.english() : "nothing";
  }
  void spoil(std::initializer_list<const char*> statements) const {
    auto database = open();
    Transaction writing{*database, Transaction::Kind::Write};
    for (const char* sql : statements) writing.run(QLatin1String{sql});
    ASSERT_TRUE(writing.commit());
  }
};

TEST_F(DatabaseFile, isMadeForItsOwnerAloneWithItsFolder) {
  const auto deep = folder() / "a" / "b" / "tessera.db";
  const auto database = Database::open(deep);
  ASSERT_TRUE(database) << database.error().sentence;
  ASSERT_TRUE(SiteStore{**database}.save("k", {}, 1, false));
  EXPECT_EQ(modeOf(deep), 0600);
  EXPECT_EQ(modeOf(deep.string() + "-wal"), 0600) << "the log holds the keys as well";
  EXPECT_EQ(modeOf(deep.string() + "-shm"), 0600);
}

TEST_F(DatabaseFile, isClosedToOthersWhenACopyCameWithWideRights) {
  open().reset();
  std::filesystem::permissions(file(), std::filesystem::perms{0644});
  open().reset();
  EXPECT_EQ(modeOf(file()), 0600);
}

TEST_F(DatabaseFile, worksAsTheDecisionSays) {
  const auto database = open();
  EXPECT_EQ(askFor(*database, "PRAGMA journal_mode"), "wal");
  EXPECT_EQ(askFor(*database, "PRAGMA foreign_keys"), "1");
  const auto synchronous = [&](Transaction::Kind kind) {
    Transaction writing{*database, kind};
    Statement row{writing, QStringLiteral("PRAGMA synchronous")};
    row.run();
    return row.next() ? row.whole(0) : -1;
  };
  EXPECT_EQ(synchronous(Transaction::Kind::Write), 1) << "NORMAL";
  EXPECT_EQ(synchronous(Transaction::Kind::WriteThrough), 2) << "FULL";
  EXPECT_EQ(synchronous(Transaction::Kind::Write), 1) << "and back";
}

TEST_F(DatabaseFile, opensAgainWithItsLayoutNumberedOnce) {
  open().reset();
  const auto database = open();
  EXPECT_EQ(askFor(*database, "SELECT count(*) FROM schema_version"), std::to_string(newestVersion()));
  EXPECT_EQ(askFor(*database, "SELECT max(version) FROM schema_version"), std::to_string(newestVersion()));
}

TEST_F(DatabaseFile, isBroughtFromAnOlderLayoutToTheNewest) {
  floor::Site site;
  site.routes.push_back({"r", {{}, {Metres{1}, {}}, {Metres{2}, {}}}, Metres{0.2}});
  ASSERT_TRUE(SiteStore{*open()}.save("k", site, 1, false));
  backTo(1);
  const auto database = open();
  ASSERT_NE(database, nullptr);
  EXPECT_EQ(askFor(*database, "SELECT count(*) FROM journal"), "0");
  SiteStore store{*database};
  EXPECT_EQ(store.load("k").value(), site) << "a site of then has no leg with a speed";
  site.routes[0].legSpeeds = {MetresPerSecond{0.1}, std::nullopt};
  ASSERT_TRUE(store.save("k", site, 2, false));
  EXPECT_EQ(store.load("k").value(), site);
}

TEST_F(DatabaseFile, takesNothingOfAStepThatFailsHalfway) {
  backTo(1, "CREATE TABLE journal_by_time(x)");  // the step's second statement meets it
  const auto log = QSqlDatabase::connectionNames();
  EXPECT_NE(refusal(), "");
  EXPECT_NE(refusal(), "") << "the journal was not made by the first try";
  EXPECT_EQ(refusal().find("table journal already exists"), std::string::npos) << refusal();
  EXPECT_EQ(QSqlDatabase::connectionNames(), log) << "no connection stays behind";
}

TEST_F(DatabaseFile, ofANewerProgramIsRefusedUntouched) {
  spoil({"INSERT INTO schema_version VALUES(99)"});
  const std::string before = bytesOf(file());
  EXPECT_EQ(refusal(),
            file().string() + ": was made by a newer version of Tessera (layout 99, this program knows up to " +
                std::to_string(newestVersion()) + "). It was left as it is: please install the newer version.");
  EXPECT_EQ(bytesOf(file()), before);
}

TEST_F(DatabaseFile, ofAnotherProgramIsRefusedUntouched) {
  spoil({"PRAGMA application_id=7"});
  const std::string before = bytesOf(file());
  EXPECT_NE(refusal().find("is a database of another program"), std::string::npos) << refusal();
  EXPECT_EQ(bytesOf(file()), before);
}

TEST_F(DatabaseFile, thatIsNoDatabaseIsRefusedUntouched) {
  const std::string letter = "Dear Sir, this is a letter and no database at all. " + std::string(5000, 'x');
  write(file(), letter);
  EXPECT_NE(refusal().find("is no file of Tessera's"), std::string::npos) << refusal();
  EXPECT_EQ(bytesOf(file()), letter);
}

TEST_F(DatabaseFile, damagedAnywhereIsRefusedUntouchedOrStillReadsRightly) {
  floor::Site site;
  site.name = "Hall";
  for (int i = 0; i < 3000; ++i)
    site.routes.push_back({"route " + std::to_string(i), {{Metres{i * 1.0}, Metres{0}}, {Metres{0}, Metres{1}}}, {}});
  {
    const auto database = open();
    ASSERT_TRUE(SiteStore{*database}.save("k", site, 1, false));
  }
  const std::string good = bytesOf(file());
  int refused = 0;
  for (std::size_t page = 1; page * 4096 < good.size(); page += 7) {
    std::string bad = good;
    bad.replace(page * 4096, 4096, std::string(4096, '\x5A'));
    write(file(), bad);
    const std::string sentence = refusal();
    if (sentence.empty()) continue;
    ++refused;
    EXPECT_NE(sentence.find("the file is damaged"), std::string::npos) << sentence;
    EXPECT_EQ(bytesOf(file()), bad);
  }
  EXPECT_GT(refused, 5);
  write(file(), good.substr(0, good.size() / 2));
  EXPECT_NE(refusal().find("the file is damaged"), std::string::npos) << refusal();
}

TEST_F(DatabaseFile, inAFolderThatCannotBeUsedGivesASentence) {
  write(folder() / "plain", "a file, not a folder");
  const auto database = Database::open(folder() / "plain" / "tessera.db");
  ASSERT_FALSE(database);
  EXPECT_NE(database.error().sentence.english().find("the folder cannot be made"), std::string::npos)
      << database.error().sentence;
  const auto folderItself = Database::open(folder());
  ASSERT_FALSE(folderItself);
  EXPECT_NE(folderItself.error().sentence.english().find("cannot be opened"), std::string::npos);
}

TEST_F(DatabaseFile, heldByAnotherWriterGivesASentenceAfterTheTimeToWait) {
  const auto first = open();
  const auto second = open({.busyTimeout = std::chrono::milliseconds{30}});
  const Transaction writing{*first, Transaction::Kind::Write};
  const auto saved = SiteStore{*second}.save("k", {}, 1, false);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().sentence,
            file().string() + ": another program is writing to this file. Close the other copy of Tessera.");
}

TEST_F(DatabaseFile, thatMayGrowNoFurtherKeepsWhatItHas) {
  floor::Site small;
  small.name = "small";
  floor::Site large;
  large.name = "large";
  for (int i = 0; i < 20000; ++i) large.looseTags.push_back({{}, {Metres{i * 1.0}, Metres{0}}});
  const auto database = open({.maxPages = 60});
  SiteStore store{*database};
  ASSERT_TRUE(store.save("k", small, 1, false));
  const auto saved = store.save("k", large, 2, false);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().sentence, file().string() + ": the disk is full. Make room on it.");
  EXPECT_EQ(store.load("k").value(), small);
  EXPECT_TRUE(store.save("k", small, 3, false)) << "it goes on after the failure";
}

}  // namespace
}  // namespace tessera::store
