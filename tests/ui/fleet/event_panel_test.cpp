#include "ui/fleet/event_panel.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>

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

}  // namespace
}  // namespace tessera::ui
