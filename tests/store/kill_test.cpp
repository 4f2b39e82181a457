// A program killed in the middle of its writing leaves whole sites and whole batches of notes behind, and all that it
// said was written.
#include <QElapsedTimer>
#include <QProcess>
#include <QThread>
#include <random>

#include "store/journal.h"
#include "store/site_store.h"
#include "store/store_fixture.h"

namespace tessera::store {
namespace {

class Killed : public test::StoreTest {
protected:
  /// Lets the writer write `rounds` rounds and a little more, kills it and gives the last round that it told of.
  int writeAndKill(int rounds, unsigned long moreMs) {
    QProcess writer;
    writer.start(QStringLiteral(STORE_WRITER), {QString::fromStdString(file().string())});
    QByteArray told;
    QElapsedTimer patience;
    patience.start();
    while (told.count('\n') < rounds && patience.elapsed() < 60'000 && writer.state() != QProcess::NotRunning)
      if (writer.waitForReadyRead(1000)) told += writer.readAllStandardOutput();
    QThread::msleep(moreMs);
    writer.kill();
    EXPECT_TRUE(writer.waitForFinished());
    EXPECT_EQ(writer.exitStatus(), QProcess::CrashExit) << writer.readAllStandardError().constData();
    told += writer.readAllStandardOutput();
    const QList<QByteArray> lines = told.left(told.lastIndexOf('\n')).split('\n');
    return lines.isEmpty() ? 0 : lines.last().toInt();
  }
};

TEST_F(Killed, leavesWholeSitesAndWholeBatchesAndAllThatWasTold) {
  std::mt19937 random{1};
  for (int turn = 0; turn < 6; ++turn) {
    std::error_code error;
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file().string() + end, error);
    const int told = writeAndKill(3, random() % 30);
    ASSERT_GE(told, 3);
    const auto database = open();
    ASSERT_NE(database, nullptr);
    const auto site = SiteStore{*database}.load("site");
    ASSERT_TRUE(site) << site.error().sentence;
    ASSERT_TRUE(*site);
    const int kept = std::stoi((*site)->name);
    EXPECT_GE(kept, told);
    ASSERT_EQ((*site)->routes.size(), 2000U);
    for (const floor::Route& route : (*site)->routes) {
      ASSERT_EQ(route.name, (*site)->name);
      ASSERT_EQ(route.vertices.at(0).x, Metres{1.0 * kept});
    }
    const auto page = Journal{*database}.query({.limit = 100'000});
    ASSERT_TRUE(page);
    EXPECT_EQ(page->entries.size() % 10, 0U) << "a batch is whole or not there";
    EXPECT_GE(page->entries.size(), static_cast<std::size_t>(10 * told));
    for (std::size_t i = 0; i < page->entries.size(); ++i)
      ASSERT_EQ(page->entries[page->entries.size() - 1 - i].utcMs, static_cast<std::int64_t>(i / 10 + 1));
  }
}

}  // namespace
}  // namespace tessera::store
