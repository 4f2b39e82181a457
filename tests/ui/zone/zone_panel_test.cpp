// The panel under mouse and keys.
#include "ui/zone/zone_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QTableView>

#include "zone_board.h"

namespace tessera::ui {
namespace {

class ZonePanelUnderTest : public testing::Test {
protected:
  void SetUp() override {
    QLocale::setDefault(QLocale::c());
    document.replace(floor::SiteMap::build(zonedSite()).value(), {});
    panel.resize(320, 640);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  template <class Widget>
  [[nodiscard]] Widget* find(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  [[nodiscard]] QListWidget& list() { return *find<QListWidget>("zoneList"); }
  [[nodiscard]] QTableView& table() { return *find<QTableView>("cornerTable"); }
  void clickRow(int row) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(row)).center());
  }
  void type(QAbstractItemView& view, const QString& text) {
    auto* line = view.viewport()->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr);
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    // The view takes the text over when the key's event is done with.
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.viewport()->findChild<QLineEdit*>() == nullptr; }));
  }
  void typeNumber(const char* box, const QString& number) {
    auto* spin = find<QDoubleSpinBox>(box);
    ASSERT_TRUE(spin->isVisible()) << box;
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, number);
    QTest::keyClick(spin, Qt::Key_Return);
  }
  [[nodiscard]] const floor::Zone& zone(std::size_t n) const { return document.site().zones.at(n); }

  SiteDocument document;
  Selection selection;
  ZonePanel panel{document, selection};
};

TEST_F(ZonePanelUnderTest, ListsTheZonesAndChoosesByAClick) {
  QSignalSpy activated{&panel, &ZonePanel::zoneActivated};
  EXPECT_EQ(list().count(), 2);
  clickRow(1);
  EXPECT_EQ(selection.zone(), "keep off");
  EXPECT_GE(activated.count(), 1);
  EXPECT_EQ(find<QLabel>("zoneArea")->text(), "0.36 m²");
  EXPECT_EQ(table().model()->rowCount(), 4);
  selection.setZone("drive");
  EXPECT_EQ(list().currentRow(), 0);
  EXPECT_EQ(find<QLabel>("zoneArea")->text(), "4.32 m²");
}

TEST_F(ZonePanelUnderTest, RenamesByF2AndKeepsTheChoice) {
  clickRow(0);
  QTest::keyClick(&list(), Qt::Key_F2);
  type(list(), "Hall");
  EXPECT_EQ(zone(0).name, "Hall");
  EXPECT_EQ(selection.zone(), "Hall");
  document.undoStack().undo();
  EXPECT_EQ(selection.zone(), "drive");
}

TEST_F(ZonePanelUnderTest, RefusesATakenNameWithASentence) {
  QSignalSpy refused{&panel, &ZonePanel::refused};
  clickRow(0);
  QTest::keyClick(&list(), Qt::Key_F2);
  type(list(), "keep off");
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(list().item(0)->text(), "drive");
}

TEST_F(ZonePanelUnderTest, ShowsTheNumberThatTheKindNeeds) {
  clickRow(1);
  auto* kind = find<QComboBox>("zoneKind");
  EXPECT_EQ(kind->currentIndex(), static_cast<int>(floor::ZoneKind::NoGo));
  EXPECT_FALSE(find<QDoubleSpinBox>("zoneSpeed")->isVisible());
  kind->setFocus();
  QTest::keyClick(kind, Qt::Key_Down);
  EXPECT_EQ(zone(1).kind, floor::ZoneKind::Slow);
  typeNumber("zoneSpeed", "0.07");
  EXPECT_EQ(zone(1).speed, MetresPerSecond{0.07});
  QTest::keyClick(kind, Qt::Key_Down);
  EXPECT_EQ(zone(1).kind, floor::ZoneKind::OneWay);
  typeNumber("zoneDirection", "90");
  EXPECT_NEAR(degrees(zone(1).direction.value()), 90.0, 1e-9);
  while (document.undoStack().canUndo()) document.undoStack().undo();
  EXPECT_EQ(document.site(), zonedSite());
}

TEST_F(ZonePanelUnderTest, EditsACornerInCentimetres) {
  clickRow(1);
  const QModelIndex cell = table().model()->index(2, CornerModel::kX);
  EXPECT_EQ(cell.data().toString(), "150.0");
  table().setCurrentIndex(cell);
  table().edit(cell);
  type(table(), "162.5");
  EXPECT_EQ(zone(1).outline[2], placeAt(1.625, 1.5));
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(ZonePanelUnderTest, InsertsAndDeletesCornersByKey) {
  clickRow(1);
  table().setCurrentIndex(table().model()->index(3, 0));
  table().setFocus();
  QTest::keyClick(&table(), Qt::Key_Insert);
  ASSERT_EQ(zone(1).outline.size(), 5U);
  EXPECT_EQ(zone(1).outline[4], placeAt(0.9, 1.2)) << "into the edge that closes the outline";
  QTest::keyClick(&table(), Qt::Key_Delete);
  EXPECT_EQ(zone(1).outline.size(), 4U);
}

TEST_F(ZonePanelUnderTest, DeletesByKeyAndOffersToDrawWhenNoneIsLeft) {
  for (int n = 0; n < 2; ++n) {
    clickRow(0);
    QTest::keyClick(&list(), Qt::Key_Delete);
  }
  auto* draw = find<QPushButton>("drawFirstZone");
  ASSERT_TRUE(draw->isVisible());
  QSignalSpy requested{&panel, &ZonePanel::drawRequested};
  QTest::mouseClick(draw, Qt::LeftButton);
  ASSERT_EQ(requested.count(), 1);
  EXPECT_EQ(requested[0][0].value<floor::ZoneKind>(), floor::ZoneKind::Running);
  document.undoStack().undo();
  EXPECT_FALSE(draw->isVisible());
}

TEST_F(ZonePanelUnderTest, DrawsAnotherOfTheChosenKindOrTheOneAskedFor) {
  clickRow(1);
  QSignalSpy requested{&panel, &ZonePanel::drawRequested};
  find<QAction>("drawZoneAction")->trigger();
  find<QAction>("drawZoneKind3")->trigger();
  ASSERT_EQ(requested.count(), 2);
  EXPECT_EQ(requested[0][0].value<floor::ZoneKind>(), floor::ZoneKind::NoGo);
  EXPECT_EQ(requested[1][0].value<floor::ZoneKind>(), floor::ZoneKind::Charging);
}

TEST_F(ZonePanelUnderTest, BearsAZoneThatIsGone) {
  clickRow(1);
  document.replace(tiledMap(1, 1), {});
  EXPECT_EQ(selection.zone(), "");
  EXPECT_EQ(table().model()->rowCount(), 0);
}

}  // namespace
}  // namespace tessera::ui
