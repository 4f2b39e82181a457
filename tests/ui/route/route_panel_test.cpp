// The panel under mouse and keys.
#include "ui/route/route_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

class PanelUnderTest : public testing::Test {
protected:
  void SetUp() override {
    QLocale::setDefault(QLocale::c());
    document.replace(tiledMap(2, 2), {});
    panel.resize(320, 640);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  template <class Widget>
  [[nodiscard]] Widget* find(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  [[nodiscard]] QListWidget& list() { return *find<QListWidget>("routeList"); }
  [[nodiscard]] QTableView& table() { return *find<QTableView>("vertexTable"); }
  void clickRow(int row) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(row)).center());
  }
  // Types into the editor that a key or double click opened in the view.
  void type(QAbstractItemView& view, const QString& text) {
    auto* line = view.viewport()->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr);
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    // The view takes the text over when the key's event is done with.
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.viewport()->findChild<QLineEdit*>() == nullptr; }));
  }
  void editCell(int row, int column, const QString& text) {
    const QPoint at = table().visualRect(table().model()->index(row, column)).center();
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, at);
    type(table(), text);
  }
  [[nodiscard]] Point vertex(std::size_t n) const { return document.map()->route("one")->vertices.at(n); }

  SiteDocument document;
  Selection selection;
  RoutePanel panel{document, selection};
};

TEST_F(PanelUnderTest, ListsTheRoutesAndChoosesByAClick) {
  EXPECT_EQ(list().count(), 2);
  clickRow(1);
  EXPECT_EQ(selection.route(), "two");
  EXPECT_EQ(table().model()->rowCount(), 2);
  selection.setRoute("one");
  EXPECT_EQ(list().currentRow(), 0);
  EXPECT_EQ(table().model()->rowCount(), 3);
}

TEST_F(PanelUnderTest, RenamesByF2AndKeepsTheChoice) {
  clickRow(0);
  QTest::keyClick(&list(), Qt::Key_F2);
  type(list(), "Main line");
  EXPECT_EQ(document.site().routes[0].name, "Main line");
  EXPECT_EQ(selection.route(), "Main line");
  document.undoStack().undo();
  EXPECT_EQ(selection.route(), "one");
}

TEST_F(PanelUnderTest, RefusesATakenNameWithASentence) {
  QSignalSpy refused{&panel, &RoutePanel::refused};
  clickRow(0);
  QTest::keyClick(&list(), Qt::Key_F2);
  type(list(), "two");
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(list().item(0)->text(), "one");
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(PanelUnderTest, DeletesByKeyAndOffersToDrawWhenNoneIsLeft) {
  clickRow(0);
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_EQ(document.site().routes.size(), 1U);
  EXPECT_EQ(selection.route(), "");
  clickRow(0);
  QTest::keyClick(&list(), Qt::Key_Delete);
  auto* draw = find<QPushButton>("drawFirstRoute");
  ASSERT_TRUE(draw->isVisible());
  QSignalSpy requested{&panel, &RoutePanel::drawRequested};
  QTest::mouseClick(draw, Qt::LeftButton);
  EXPECT_EQ(requested.count(), 1);
  document.undoStack().undo();
  EXPECT_FALSE(draw->isVisible());
}

TEST_F(PanelUnderTest, EditsAVertexByNumber) {
  clickRow(0);
  editCell(1, VertexModel::kX, "1.234");
  EXPECT_EQ(vertex(1).x, Metres{1.234});
  EXPECT_EQ(vertex(1).y, Metres{0.5});
  EXPECT_EQ(document.undoStack().count(), 1);
  editCell(1, VertexModel::kX, "1.234");
  EXPECT_EQ(document.undoStack().count(), 1);  // the same number is no step
}

TEST_F(PanelUnderTest, TakesNoNumberThatASiteCouldNotHold) {
  clickRow(0);
  editCell(1, VertexModel::kY, "abc");
  editCell(1, VertexModel::kY, "99999999");
  EXPECT_LE(abs(vertex(1).y), kFarthest);
  EXPECT_TRUE(std::isfinite(vertex(1).y.value()));
}

TEST_F(PanelUnderTest, InsertsAndDeletesRows) {
  clickRow(0);
  QSignalSpy chosen{&panel, &RoutePanel::vertexSelected};
  QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(table().model()->index(0, 0)).center());
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].value<std::optional<std::size_t>>(), 0U);
  find<QAction>("insertVertexAction")->trigger();
  ASSERT_EQ(table().model()->rowCount(), 4);
  EXPECT_NEAR(vertex(1).x.value(), 1.25, 1e-9);
  QTest::keyClick(&table(), Qt::Key_Delete);
  EXPECT_EQ(table().model()->rowCount(), 3);
  EXPECT_EQ(document.site().routes.size(), 2U);
}

TEST_F(PanelUnderTest, GoesStraightOnBehindTheLastVertex) {
  clickRow(0);
  panel.setVertex(2);
  find<QAction>("insertVertexAction")->trigger();
  EXPECT_NEAR(vertex(3).x.value(), 2.0, 1e-9);
  EXPECT_NEAR(vertex(3).y.value(), 2.5, 1e-9);
}

TEST_F(PanelUnderTest, SetsTheSpacingInOneStepHoweverOftenItIsTurned) {
  clickRow(0);
  auto* spacing = find<QDoubleSpinBox>("controlSpacing");
  EXPECT_DOUBLE_EQ(spacing->value(), 0.2);
  for (int n = 0; n < 4; ++n) QTest::keyClick(spacing, Qt::Key_Up);
  EXPECT_NEAR(document.map()->route("one")->controlSpacing.value(), 0.4, 1e-9);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_DOUBLE_EQ(spacing->value(), 0.2);
}

TEST_F(PanelUnderTest, TellsLengthAndTimeAtASpeed) {
  clickRow(0);
  auto* text = find<QLabel>("routeLength");
  find<QDoubleSpinBox>("estimateSpeed")->setValue(0.5);
  EXPECT_EQ(text->text(), "3.00 m, about 6 s");
  find<QDoubleSpinBox>("estimateSpeed")->setValue(0.02);
  EXPECT_EQ(text->text(), "3.00 m, about 2 min 30 s");
}

TEST_F(PanelUnderTest, SetsTheSpeedOfALegAndTakesItAwayAgain) {
  clickRow(0);
  find<QDoubleSpinBox>("estimateSpeed")->setValue(0.5);
  auto* text = find<QLabel>("routeLength");
  const auto cell = [&](int row) { return table().model()->index(row, VertexModel::kSpeed).data().toString(); };
  EXPECT_EQ(table().model()->headerData(VertexModel::kSpeed, Qt::Horizontal).toString(), "Max m/s");
  editCell(2, VertexModel::kSpeed, "0.1");
  EXPECT_EQ(document.map()->route("one")->legSpeeds,
            (std::vector<std::optional<MetresPerSecond>>{std::nullopt, MetresPerSecond{0.1}}));
  EXPECT_EQ(cell(2), "0.100");
  EXPECT_EQ(cell(1), "");
  EXPECT_EQ(text->text(), "3.00 m, about 18 s") << "1.5 m at 0.5 m/s and 1.5 m at 0.1 m/s";
  EXPECT_EQ(document.undoStack().undoText(), "Set speed of leg 2 of one");
  editCell(2, VertexModel::kSpeed, "0.1");
  EXPECT_EQ(document.undoStack().count(), 1) << "the same number is no step";
  editCell(2, VertexModel::kSpeed, "");
  EXPECT_TRUE(document.map()->route("one")->legSpeeds.empty());
  EXPECT_EQ(text->text(), "3.00 m, about 6 s");
  document.undoStack().undo();
  EXPECT_EQ(cell(2), "0.100");
  EXPECT_FALSE(table().model()->flags(table().model()->index(0, VertexModel::kSpeed)) & Qt::ItemIsEditable)
      << "no leg leads to the first vertex";
}

TEST_F(PanelUnderTest, SetsTheSpeedOfALegByKeys) {
  clickRow(0);
  table().setFocus();
  table().setCurrentIndex(table().model()->index(1, VertexModel::kX));
  for (int n = 0; n < 3; ++n) QTest::keyClick(&table(), Qt::Key_Right);
  ASSERT_EQ(table().currentIndex().column(), VertexModel::kSpeed);
  QTest::keyClick(&table(), Qt::Key_F2);
  type(table(), "99");
  EXPECT_LE(document.map()->route("one")->legSpeeds.at(0).value_or(MetresPerSecond{}), RouteEdits::kMostSpeed);
  QTest::keyClick(&table(), Qt::Key_F2);
  type(table(), "0.25");
  EXPECT_EQ(document.map()->route("one")->legSpeeds.at(0), MetresPerSecond{0.25});
}

TEST_F(PanelUnderTest, DuplicatesAndReverses) {
  clickRow(0);
  find<QAction>("reverseRouteAction")->trigger();
  EXPECT_EQ(vertex(0).y, Metres{2.0});
  find<QAction>("duplicateRouteAction")->trigger();
  EXPECT_EQ(document.site().routes.size(), 3U);
  EXPECT_EQ(selection.route().toStdString(), document.site().routes[1].name);
}

TEST_F(PanelUnderTest, KeepsRowsAndChoiceWhenAVertexIsMovedElsewhere) {
  clickRow(0);
  panel.setVertex(1);
  ASSERT_TRUE(RouteEdits{document}.moveVertex("one", 1, {Metres{9}, Metres{9}}));
  EXPECT_EQ(table().currentIndex().row(), 1);
  EXPECT_EQ(table().model()->index(1, 0).data().toString(), "9.000");
}

}  // namespace
}  // namespace tessera::ui
