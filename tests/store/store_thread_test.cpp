// The storage thread: posts are written, answers come as signals, trouble is told once and nothing is lost meanwhile.
#include "store/store_thread.h"

#include <sys/resource.h>

#include <QSignalSpy>
#include <QTest>
#include <csignal>

#include "floor/random_site.h"
#include "store/journal.h"
#include "store/store_fixture.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

using namespace std::chrono_literals;
using supervisor::Severity;
using test::note;

class Storage : public test::StoreTest {
protected:
  Storage() { options_.file = file(); }
  static std::shared_ptr<const floor::SiteMap> mapOf(const std::string& name, int routes = 1) {
    floor::Site site;
    site.name = name;
    for (int i = 0; i < routes; ++i)
      site.routes.push_back({std::to_string(i), {{}, {Metres{1.0}, Metres{1.0 * i}}}, Metres{0.2}});
    return *floor::SiteMap::build(std::move(site));
  }
  std::vector<std::string> written() const {
    const auto database = open();
    std::vector<std::string> all;
    const auto page = Journal{*database}.query({.limit = 100'000});
    for (auto entry = page->entries.rbegin(); entry != page->entries.rend(); ++entry) all.push_back(entry->sentence);
    return all;
  }
  static std::vector<Note> notes(int first, int count, Severity severity = Severity::Info) {
    std::vector<Note> all;
    for (int i = first; i < first + count; ++i) all.push_back(note(i, std::to_string(i), severity));
    return all;
  }

  StoreThread::Options options_;
};

TEST_F(Storage, keepsSitesAndAnswersWithThem) {
  StoreThread storage{options_};
  QSignalSpy loaded{&storage, &StoreThread::siteLoaded};
  QSignalSpy listed{&storage, &StoreThread::sitesListed};
  storage.start();
  const auto map = mapOf("Hall");
  EXPECT_TRUE(storage.keepSite("k", map, 5, true));
  const std::uint64_t request = storage.loadSite("k");
  const std::uint64_t nothing = storage.loadSite("nobody");
  const std::uint64_t list = storage.listSites();
  ASSERT_TRUE(QTest::qWaitFor([&] { return loaded.count() == 2 && listed.count() == 1; }));
  EXPECT_EQ(loaded[0][0].value<quint64>(), request);
  EXPECT_EQ(loaded[0][1].value<std::shared_ptr<const floor::SiteMap>>()->site(), map->site());
  EXPECT_EQ(loaded[1][0].value<quint64>(), nothing);
  EXPECT_EQ(loaded[1][1].value<std::shared_ptr<const floor::SiteMap>>(), nullptr);
  EXPECT_EQ(listed[0][0].value<quint64>(), list);
  EXPECT_EQ(listed[0][1].value<std::vector<KeptSite>>(), (std::vector<KeptSite>{{"k", "Hall", 5, true}}));
}

TEST_F(Storage, keepsASiteThatContradictsItselfAndItsRevisions) {
  floor::Site site = mapOf("Hall")->site();
  site.tiles = {{"A", "unknown", {}}, {"A", "unknown", {}}};
  site.placements = {{"A", {}, 0}, {"B", {}, 0}};
  site.routes.push_back(site.routes[0]);
  const auto map = *floor::SiteMap::build(site, floor::Ambiguity::Carried);
  ASSERT_FALSE(map->contradictions().empty());
  StoreThread storage{options_};
  QSignalSpy sites{&storage, &StoreThread::siteLoaded};
  QSignalSpy revisions{&storage, &StoreThread::revisionLoaded};
  QSignalSpy listed{&storage, &StoreThread::revisionsListed};
  storage.start();
  EXPECT_TRUE(storage.keepSite("k", map, 5, true));
  EXPECT_TRUE(storage.addRevision("k", map, {5, "Ada", "Found", true}));
  storage.loadSite("k");
  storage.listRevisions("k");
  ASSERT_TRUE(QTest::qWaitFor([&] { return sites.count() == 1 && listed.count() == 1; }));
  storage.loadRevision(listed[0][1].value<std::vector<Revision>>().at(0).id);
  ASSERT_TRUE(QTest::qWaitFor([&] { return revisions.count() == 1; }));
  for (const auto& answer : {sites[0], revisions[0]}) {
    const auto loaded = answer[1].value<std::shared_ptr<const floor::SiteMap>>();
    EXPECT_EQ(loaded->site(), site);
    EXPECT_EQ(loaded->contradictions().size(), map->contradictions().size());
  }
}

TEST_F(Storage, keepsRevisionsAndAnswersWithThem) {
  StoreThread storage{options_};
  QSignalSpy listed{&storage, &StoreThread::revisionsListed};
  QSignalSpy loaded{&storage, &StoreThread::revisionLoaded};
  QSignalSpy refused{&storage, &StoreThread::requestFailed};
  storage.start();
  EXPECT_TRUE(storage.addRevision("k", mapOf("Hall"), {5, "Ada", "New site", false}));
  EXPECT_TRUE(storage.addRevision("k", mapOf("Hall", 2), {6, "Ada", "Draw a route", false}));
  const std::uint64_t list = storage.listRevisions("k");
  ASSERT_TRUE(QTest::qWaitFor([&] { return listed.count() == 1; }));
  EXPECT_EQ(listed[0][0].value<quint64>(), list);
  const auto all = listed[0][1].value<std::vector<Revision>>();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].note, (RevisionNote{6, "Ada", "Draw a route", false}));
  const std::uint64_t request = storage.loadRevision(all[1].id);
  const std::uint64_t nothing = storage.loadRevision(4711);
  ASSERT_TRUE(QTest::qWaitFor([&] { return loaded.count() == 1 && refused.count() == 1; }));
  EXPECT_EQ(loaded[0][0].value<quint64>(), request);
  EXPECT_EQ(loaded[0][1].value<std::shared_ptr<const floor::SiteMap>>()->site(), mapOf("Hall")->site());
  EXPECT_EQ(refused[0][0].value<quint64>(), nothing);
}

TEST_F(Storage, finishesWhatWaitsBeforeItCloses) {
  StoreThread storage{options_};
  storage.start();
  for (int i = 0; i < 200; ++i) storage.appendEvents(notes(i * 10, 10));
  storage.keepSite("unsaved:1", mapOf("last"), 1, true);
  storage.renameSite("unsaved:1", "/a");
  storage.setDiffers("/a", false);
  EXPECT_TRUE(storage.close());
  EXPECT_FALSE(storage.appendEvents(notes(0, 1)));
  EXPECT_EQ(storage.listSites(), 0U);
  const auto all = written();
  ASSERT_EQ(all.size(), 2000U);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(all[static_cast<std::size_t>(i)], std::to_string(i));
  const auto database = open();
  EXPECT_EQ(SiteStore{*database}.list().value(), (std::vector<KeptSite>{{"/a", "last", 1, false}}));
}

TEST_F(Storage, answersAQueryWithWhatWasPostedBefore) {
  StoreThread storage{options_};
  QSignalSpy found{&storage, &StoreThread::journalFound};
  storage.start();
  for (int i = 0; i < 20; ++i) {
    storage.appendEvents(notes(i, 1));
    const std::uint64_t request = storage.queryJournal({.limit = 1});
    ASSERT_TRUE(QTest::qWaitFor([&] { return found.count() == 1; }));
    EXPECT_EQ(found[0][0].value<quint64>(), request);
    EXPECT_EQ(found[0][1].value<JournalPage>().entries.at(0).sentence, std::to_string(i));
    found.clear();
  }
}

TEST_F(Storage, waitsForAnotherCopyThatWritesAndTellsOnce) {
  options_.database.busyTimeout = 20ms;
  options_.retry = 10ms;
  const auto other = open();
  StoreThread storage{options_};
  QSignalSpy failed{&storage, &StoreThread::failed};
  QSignalSpy recovered{&storage, &StoreThread::recovered};
  QSignalSpy found{&storage, &StoreThread::journalFound};
  storage.start();
  {
    const Transaction writing{*other, Transaction::Kind::Write};
    storage.keepSite("k", mapOf("mine"), 1, true);
    storage.appendEvents(notes(0, 10));
    ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }));
    storage.appendEvents(notes(10, 10));
    // Several more attempts go by; reading works meanwhile.
    storage.queryJournal({});
    ASSERT_TRUE(QTest::qWaitFor([&] { return found.count() == 1; }));
    QTest::qWait(150);
    EXPECT_EQ(failed.count(), 1) << "one episode, one sentence";
    EXPECT_EQ(recovered.count(), 0);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return recovered.count() == 1; }));
  EXPECT_EQ(failed[0][0].value<Sentence>().english(),
            file().string() + ": another program is writing to this file. Close the other copy of Tessera.");
  EXPECT_EQ(recovered[0][0].toULongLong(), 0U);
  EXPECT_TRUE(storage.close());
  EXPECT_EQ(written().size(), 20U);
  EXPECT_EQ(SiteStore{*other}.load("k").value()->name, "mine");
}

TEST_F(Storage, dropsTheOldestInfosWhenFarTooManyWaitAndWritesDownHowMany) {
  options_.database.busyTimeout = 10ms;
  options_.retry = 10ms;
  options_.limits.notes = 100;
  const auto other = open();
  StoreThread storage{options_};
  QSignalSpy failed{&storage, &StoreThread::failed};
  QSignalSpy recovered{&storage, &StoreThread::recovered};
  storage.start();
  {
    const Transaction writing{*other, Transaction::Kind::Write};
    storage.appendEvents(notes(0, 50, Severity::Error));
    ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }));
    storage.appendEvents(notes(100, 250));
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return recovered.count() == 1; }));
  EXPECT_TRUE(storage.close());
  // How many go depends on whether the errors wait in the queue or are just being tried again: 150 or 200.
  int lost = 0;
  int errors = 0;
  int infos = 0;
  for (const std::string& sentence : written()) {
    if (const auto colon = sentence.find(": "); colon != std::string::npos)
      lost += std::stoi(sentence.substr(colon + 2));
    else
      ++(std::stoi(sentence) < 100 ? errors : infos);
  }
  EXPECT_EQ(errors, 50) << "no error was dropped";
  EXPECT_GE(lost, 150);
  EXPECT_EQ(infos + lost, 250) << "each that was lost was told";
  EXPECT_EQ(written().back(), "349") << "the oldest went";
}

// A disk that truly refuses bytes: the kernel's limit on the size of files of this process.
TEST_F(Storage, goesOnByItselfWhenAFullDiskHasRoomAgain) {
  options_.retry = 10ms;
  options_.database.busyTimeout = 50ms;
  std::signal(SIGXFSZ, SIG_IGN);
  StoreThread storage{options_};
  QSignalSpy failed{&storage, &StoreThread::failed};
  QSignalSpy recovered{&storage, &StoreThread::recovered};
  QSignalSpy idle{&storage, &StoreThread::idle};
  storage.start();
  storage.keepSite("k", mapOf("small"), 1, false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return idle.count() >= 1; }));
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  rlimit tight = old;
  tight.rlim_cur = 400'000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  storage.keepSite("k", mapOf("large", 20'000), 2, true);
  storage.appendEvents(notes(0, 10));
  const bool told = QTest::qWaitFor([&] { return failed.count() == 1; });
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
  ASSERT_TRUE(told);
  EXPECT_NE(failed[0][0].value<Sentence>().english().find("disk"), std::string::npos)
      << failed[0][0].value<Sentence>().english();
  ASSERT_TRUE(QTest::qWaitFor([&] { return recovered.count() == 1; }, 20'000));
  EXPECT_TRUE(storage.close());
  EXPECT_EQ(written().size(), 10U);
  const auto database = open();
  EXPECT_EQ(SiteStore{*database}.load("k").value()->routes.size(), 20'000U);
}

TEST_F(Storage, closesInTimeWhenTheDiskGoesOnFailingAndSaysSo) {
  options_.database.busyTimeout = 20ms;
  options_.retry = 10ms;
  const auto other = open();
  StoreThread storage{options_};
  storage.start();
  const Transaction writing{*other, Transaction::Kind::Write};
  storage.appendEvents(notes(0, 10));
  QElapsedTimer time;
  time.start();
  EXPECT_FALSE(storage.close(200ms));
  EXPECT_GE(time.elapsed(), 150);
  EXPECT_LT(time.elapsed(), 2000);
}

TEST_F(Storage, tellsOfADamagedFileAtTheStartAndRefusesRequests) {
  write(file(), std::string(10'000, 'x'));
  StoreThread storage{options_};
  QSignalSpy failed{&storage, &StoreThread::failed};
  QSignalSpy refused{&storage, &StoreThread::requestFailed};
  storage.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }));
  const std::uint64_t request = storage.listSites();
  ASSERT_TRUE(QTest::qWaitFor([&] { return refused.count() == 1; }));
  EXPECT_EQ(refused[0][0].value<quint64>(), request);
  EXPECT_EQ(refused[0][1].value<Sentence>(), failed[0][0].value<Sentence>());
  EXPECT_TRUE(storage.close()) << "nothing was left to write";
}

TEST_F(Storage, removesWhatIsTooMuchForTheJournal) {
  options_.keepEntries = 30;
  StoreThread storage{options_};
  storage.start();
  storage.appendEvents(notes(0, 50));
  QSignalSpy idle{&storage, &StoreThread::idle};
  ASSERT_TRUE(QTest::qWaitFor([&] { return idle.count() >= 1; }));
  EXPECT_TRUE(storage.close());
  EXPECT_EQ(written().size(), 30U);
}

}  // namespace
}  // namespace tessera::store
