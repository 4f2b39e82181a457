// Yesterday's events, read from the journal's database while the window goes on.
#include "store/journal.h"

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QTreeView>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/keeper.h"
#include "app/tessera/site_files.h"

namespace tessera::desktop {
namespace {

class YesterdaysJournal : public DesktopTest {};

TEST_F(YesterdaysJournal, isReadPageByPageAndSaidInAnyLanguage) {
  constexpr int kNotes = 1300;
  {
    ASSERT_TRUE(QDir{}.mkpath(QFileInfo{Keeper::databasePath()}.path()));
    auto database = store::Database::open(Keeper::databasePath().toStdString());
    ASSERT_TRUE(database);
    const qint64 noon = QDateTime{QDate::currentDate().addDays(-1), QTime{12, 0}}.toMSecsSinceEpoch();
    std::vector<store::Note> notes;
    for (int i = 0; i < kNotes; ++i) {
      supervisor::Event event;
      event.vehicle = VehicleId{1};
      event.severity = i == 7 ? supervisor::Severity::Error : supervisor::Severity::Info;
      event.sentence = phrase("Core", "%1 answers again.").with("AGV " + std::to_string(i));
      notes.push_back({noon + i, "hall", event});
    }
    ASSERT_TRUE(store::Journal{**database}.append(notes));
  }
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_TRUE(window->files().openDemo());
  find<QDockWidget>("eventsDock")->raise();
  QTest::mouseClick(find("byDayButton"), Qt::LeftButton);
  const auto* list = find<QTreeView>("eventList")->model();
  ASSERT_TRUE(until([&] { return list->rowCount() == kNotes; })) << list->rowCount();
  EXPECT_EQ(list->index(0, 2).data().toString(), "AGV 0 answers again.");
  EXPECT_EQ(list->index(kNotes - 1, 2).data().toString(), "AGV 1299 answers again.");
  trigger("language_zh_CN");
  EXPECT_FALSE(list->index(0, 2).data().toString().contains("answers"));
  auto* severity = find<QComboBox>("severityFilter");
  severity->setFocus();
  QTest::keyClick(severity, Qt::Key_End);
  EXPECT_TRUE(until([&] { return list->rowCount() == 1; }));
  trigger("language_en");
}

}  // namespace
}  // namespace tessera::desktop
