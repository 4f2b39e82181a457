#include "ui/fleet/event_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QPushButton>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "ui/fleet/fake_fleet.h"

namespace tessera::ui {
namespace {

using supervisor::Event;
using supervisor::Severity;

class EventPanelTest : public testing::Test {
protected:
  EventPanelTest() {
    openFakeSite(document, 3, {});
    panel.setClock([](Seconds time) {
      return QDateTime{QDate{2026, 1, 2}, QTime{12, 0}}.addSecs(std::lround(time.value()));
    });
    panel.resize(700, 260);
    panel.show();
  }

  static Event event(double time, Severity severity, int vehicle) {
    Event e;
    e.time = Seconds{time};
    e.severity = severity;
    if (vehicle > 0) e.vehicle = VehicleId{static_cast<std::uint8_t>(vehicle)};
    return e;
  }
  void fill(int count) {
    std::vector<Event> events;
    for (int i = 0; i < count; ++i) events.push_back(event(i, Severity::Info, 1));
    link.tell(events);
  }
  [[nodiscard]] QTreeView* list() const { return panel.findChild<QTreeView*>("eventList"); }
  [[nodiscard]] int rows() const { return list()->model()->rowCount(); }
  [[nodiscard]] QString cell(int row, int column) const {
    return list()->model()->index(row, column).data().toString();
  }
  [[nodiscard]] QScrollBar* bar() const { return list()->verticalScrollBar(); }

  FakeFleet link;
  Selection selection;
  SiteDocument document;
  EventPanel panel{link, selection, document};
};

TEST_F(EventPanelTest, ListsTimeVehicleAndSentenceNewestLast) {
  link.tell({event(1, Severity::Info, 0), event(2, Severity::Error, 2)});
  ASSERT_EQ(rows(), 2);
  EXPECT_TRUE(cell(0, EventModel::When).endsWith("12:00:01"));
  EXPECT_EQ(cell(0, EventModel::Who), QString{});
  EXPECT_EQ(cell(1, EventModel::Who), "AGV 2");
  EXPECT_EQ(list()->model()->index(1, EventModel::What).data(IconRole).toString(), "error");
}

TEST_F(EventPanelTest, FiltersBySeverityVehicleAndWords) {
  panel.prepend(
      {{QDateTime::currentDateTime(), Severity::Info, VehicleId{1}, QString{"AGV 1 starts on the route north."}},
       {QDateTime::currentDateTime(), Severity::Warning, VehicleId{2}, QString{"AGV 2 lost its place."}},
       {QDateTime::currentDateTime(), Severity::Error, VehicleId{1}, QString{"A wheel is blocked."}}});
  ASSERT_EQ(rows(), 3);
  auto* severity = panel.findChild<QComboBox*>("severityFilter");
  severity->setFocus();
  QTest::keyClick(severity, Qt::Key_Down);
  EXPECT_EQ(rows(), 2);
  QTest::keyClick(severity, Qt::Key_Down);
  EXPECT_EQ(rows(), 1);
  QTest::keyClick(severity, Qt::Key_Home);
  EXPECT_EQ(rows(), 3);
  auto* vehicle = panel.findChild<QComboBox*>("vehicleFilter");
  vehicle->setCurrentIndex(vehicle->findText("AGV 2"));
  EXPECT_EQ(rows(), 1);
  vehicle->setCurrentIndex(0);
  auto* words = panel.findChild<QLineEdit*>("wordsFilter");
  words->setFocus();
  QTest::keyClicks(words, "NORTH");
  ASSERT_EQ(rows(), 1);
  EXPECT_EQ(cell(0, EventModel::What), "AGV 1 starts on the route north.");
  QTest::keyClicks(words, " pole");
  EXPECT_EQ(rows(), 0);
  auto* all = panel.findChild<QPushButton*>("showAllButton");
  ASSERT_TRUE(all->isVisible());
  QTest::mouseClick(all, Qt::LeftButton);
  EXPECT_EQ(rows(), 3);
  EXPECT_TRUE(words->text().isEmpty());
}

TEST_F(EventPanelTest, StaysAtTheEndUnlessSomebodyReadsAbove) {
  fill(100);
  EXPECT_EQ(bar()->value(), bar()->maximum());
  fill(10);
  EXPECT_EQ(bar()->value(), bar()->maximum());
  QTest::keyClick(list(), Qt::Key_Home);
  bar()->setValue(3);
  fill(10);
  EXPECT_EQ(bar()->value(), 3);
  auto* toEnd = panel.findChild<QToolButton*>("toEndButton");
  ASSERT_TRUE(toEnd->isEnabled());
  QTest::mouseClick(toEnd, Qt::LeftButton);
  EXPECT_EQ(bar()->value(), bar()->maximum());
  fill(10);
  EXPECT_EQ(bar()->value(), bar()->maximum());
}

TEST_F(EventPanelTest, HoldsNoMoreThanSomeThousands) {
  for (int i = 0; i < 14; ++i) fill(1000);
  EXPECT_LE(rows(), static_cast<int>(EventModel::kMost));
  EXPECT_GE(rows(), static_cast<int>(EventModel::kMost / 2));
  panel.prepend(std::vector<JournalLine>(EventModel::kMost));
  EXPECT_LE(rows(), static_cast<int>(EventModel::kMost));
}

TEST_F(EventPanelTest, PutsEarlierLinesBeforeAllOthersInTheirOrder) {
  link.tell({event(1, Severity::Info, 1)});
  const QDateTime early{QDate{2025, 12, 31}, QTime{8, 0}};
  panel.prepend(
      {{early, Severity::Info, {}, QString{"first"}}, {early.addSecs(1), Severity::Info, {}, QString{"second"}}});
  ASSERT_EQ(rows(), 3);
  EXPECT_EQ(cell(0, EventModel::What), "first");
  EXPECT_EQ(cell(1, EventModel::What), "second");
}

TEST_F(EventPanelTest, CopiesTheSelectedLinesOrAll) {
  const QDateTime now = QDateTime::currentDateTime();
  panel.prepend({{now, Severity::Info, VehicleId{1}, QString{"a"}}, {now, Severity::Info, VehicleId{2}, QString{"b"}}});
  QTest::mouseClick(panel.findChild<QToolButton*>("copyEventsButton"), Qt::LeftButton);
  EXPECT_EQ(QGuiApplication::clipboard()->text().count('\n'), 1);
  const QRect second = list()->visualRect(list()->model()->index(1, 0));
  QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, second.center());
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  QTest::keyClick(list(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), cell(1, EventModel::When) + "\tAGV 2\tb");
}

TEST_F(EventPanelTest, EmptiesTheViewAndSaysWhatWillComeHere) {
  fill(5);
  QTest::mouseClick(panel.findChild<QToolButton*>("clearEventsButton"), Qt::LeftButton);
  EXPECT_EQ(rows(), 0);
  EXPECT_FALSE(list()->isVisible());
  EXPECT_FALSE(panel.findChild<QToolButton*>("copyEventsButton")->isEnabled());
}

TEST_F(EventPanelTest, DoubleClickChoosesTheVehicle) {
  link.tell({event(1, Severity::Info, 3)});
  const QPoint place = list()->visualRect(list()->model()->index(0, 2)).center();
  QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, place);
  EXPECT_EQ(selection.vehicle(), VehicleId{3});
}

class JournalDays : public EventPanelTest {
protected:
  JournalDays() {
    connection =
        QObject::connect(&panel, &EventPanel::dayWanted, [this](const JournalDay& day) { asked.push_back(day); });
    fill(3);
    QTest::mouseClick(button("byDayButton"), Qt::LeftButton);
  }
  ~JournalDays() override { QObject::disconnect(connection); }
  [[nodiscard]] QToolButton* button(const char* name) const {
    return panel.findChild<QToolButton*>(QLatin1String{name});
  }
  [[nodiscard]] QDateEdit* field() const { return panel.findChild<QDateEdit*>("dayField"); }
  [[nodiscard]] QPushButton* hint() const { return panel.findChild<QPushButton*>("showAllButton"); }
  /// So many lines, the last one written at this second of the day.
  static std::vector<JournalLine> page(int count, int last) {
    std::vector<JournalLine> lines;
    const QDateTime midnight = QDate::currentDate().addDays(-1).startOfDay();
    for (int i = last - count + 1; i <= last; ++i)
      lines.push_back({midnight.addSecs(i), Severity::Info, VehicleId{1}, QStringLiteral("line %1").arg(i)});
    return lines;
  }

  std::vector<JournalDay> asked;
  QMetaObject::Connection connection;
};

TEST_F(JournalDays, BeginWithYesterdayAndGoFromDayToDay) {
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked.back().day, QDate::currentDate().addDays(-1));
  EXPECT_EQ(rows(), 0);
  QTest::mouseClick(button("dayBefore"), Qt::LeftButton);
  EXPECT_EQ(asked.back().day, QDate::currentDate().addDays(-2));
  QTest::keyClick(field(), Qt::Key_Up);
  EXPECT_NE(asked.back().day, QDate::currentDate().addDays(-2)) << "by key as well";
  for (int i = 0; i < 400 && button("dayAfter")->isEnabled(); ++i)
    QTest::mouseClick(button("dayAfter"), Qt::LeftButton);
  EXPECT_EQ(asked.back().day, QDate::currentDate()) << "and not into the future";
}

TEST_F(JournalDays, ComePageByPageAndStayInOrder) {
  panel.showDay(page(3, 8), JournalPart::Page);
  EXPECT_EQ(rows(), 3);
  panel.showDay(page(5, 5), JournalPart::Last);
  ASSERT_EQ(rows(), 8);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(cell(i, EventModel::What), QStringLiteral("line %1").arg(i + 1));
  fill(2);
  EXPECT_EQ(rows(), 8) << "what happens meanwhile is of another day";
  QTest::mouseClick(panel.findChild<QPushButton*>("backToNow"), Qt::LeftButton);
  EXPECT_EQ(rows(), 5);
  panel.showDay(page(3, 8), JournalPart::Last);
  EXPECT_EQ(rows(), 5) << "an answer that comes too late";
}

TEST_F(JournalDays, AreSearchedAndAskForWhatIsChosen) {
  panel.showDay(page(20, 20), JournalPart::Last);
  auto* words = panel.findChild<QLineEdit*>("wordsFilter");
  words->setFocus();
  QTest::keyClicks(words, "line 7");
  EXPECT_EQ(rows(), 1);
  const std::size_t before = asked.size();
  auto* severity = panel.findChild<QComboBox*>("severityFilter");
  severity->setFocus();
  QTest::keyClick(severity, Qt::Key_End);
  ASSERT_EQ(asked.size(), before + 1);
  EXPECT_EQ(asked.back().least, Severity::Error);
}

TEST_F(JournalDays, SayWhenNothingIsThereWhyAndWhatToDo) {
  auto* sentence = panel.findChild<FleetHint*>();
  const QString reading = sentence->sentence();
  EXPECT_FALSE(reading.isEmpty());
  panel.showDay({}, JournalPart::Last);
  EXPECT_NE(sentence->sentence(), reading);
  ASSERT_TRUE(hint()->isVisible());
  QTest::mouseClick(hint(), Qt::LeftButton);
  EXPECT_EQ(rows(), 3) << "back to now";
  QTest::mouseClick(button("byDayButton"), Qt::LeftButton);
  panel.showDayFailure("The disk is gone.");
  EXPECT_EQ(sentence->sentence(), "The disk is gone.");
}

TEST_F(JournalDays, SayWhenThereIsMoreThanIsListed) {
  for (int i = 10; i > 0; --i) panel.showDay(page(500, i * 500), i == 1 ? JournalPart::TooMany : JournalPart::Page);
  EXPECT_EQ(rows(), static_cast<int>(EventModel::kMost));
  EXPECT_FALSE(panel.findChild<Notice*>()->text().isEmpty());
  QTest::mouseClick(button("dayBefore"), Qt::LeftButton);
  EXPECT_TRUE(panel.findChild<Notice*>()->text().isEmpty());
}

TEST_F(JournalDays, AreSavedAsATableOfWhatIsListed) {
  const QDateTime when{QDate{2026, 1, 2}, QTime{3, 4, 5, 60}};
  panel.showDay({{when, Severity::Error, VehicleId{2}, QStringLiteral("A wheel, the “left” one, \"sticks\": 轮子")},
                 {when, Severity::Info, {}, QStringLiteral("other")}},
                JournalPart::Last);
  auto* words = panel.findChild<QLineEdit*>("wordsFilter");
  words->setFocus();
  QTest::keyClicks(words, "wheel");
  const QTemporaryDir folder;
  const QString file = folder.filePath("events.csv");
  QTimer::singleShot(0, &panel, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    dialog->setDirectory(folder.path());
    name->setText("events");
    QTest::keyClick(name, Qt::Key_Return);
  });
  QTest::mouseClick(button("saveEventsButton"), Qt::LeftButton);
  QFile saved{file};
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = saved.readAll().split('\n');
  ASSERT_EQ(lines.size(), 3) << "the head, one line, nothing behind the last end of line";
  EXPECT_EQ(lines[0], "\xEF\xBB\xBFtime,vehicle,severity,what\r");
  EXPECT_TRUE(lines[1].startsWith("2026-01-02T03:04:05.060"));
  EXPECT_TRUE(lines[1].endsWith(",AGV 2,error,\"A wheel, the “left” one, \"\"sticks\"\": 轮子\"\r"))
      << lines[1].toStdString();
}

}  // namespace
}  // namespace tessera::ui
