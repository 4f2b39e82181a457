// The list of faults under mouse and keys, over a real check on its own thread.
#include "ui/check/fault_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

using sitecheck::FaultKind;
using sitecheck::Severity;

Point placeAt(double x, double y) { return {Metres{x}, Metres{y}}; }

/// Tiles with a running zone over them and nothing wrong that an edit here would touch.
floor::Site soundSite() {
  floor::Site site = tiledSite(5, 4);
  site.routes.clear();
  site.zones.push_back(
      {"hall", floor::ZoneKind::Running, {placeAt(0, 0), placeAt(3, 0), placeAt(3, 2.4), placeAt(0, 2.4)}, {}, {}});
  for (floor::VehicleSetup& vehicle : site.vehicles) {
    vehicle.key.fill(static_cast<std::uint8_t>(vehicle.id.value + 1));
    vehicle.readerRadius = Metres{0.12};
  }
  return site;
}

class FaultsUnderTest : public testing::Test {
protected:
  void SetUp() override {
    open(soundSite());
    panel.resize(700, 260);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    ASSERT_TRUE(settled());
  }
  void open(const floor::Site& site) { document.replace(floor::SiteMap::build(site).value(), {}); }
  bool settled() {
    return QTest::qWaitFor([this] { return !watch.isChecking(); }, 60'000);
  }
  void addRoute(std::vector<Point> vertices) {
    ASSERT_TRUE(document.edit("Draw", [&](floor::Site& site) {
      site.routes.push_back({"out", std::move(vertices), Metres{0.2}});
    }));
    ASSERT_TRUE(settled());
  }
  [[nodiscard]] QListView& list() { return *panel.findChild<QListView*>("faultList"); }
  [[nodiscard]] QString row(int n) { return list().model()->index(n, 0).data().toString(); }
  [[nodiscard]] int rows() { return list().model()->rowCount(); }
  [[nodiscard]] int rowWith(const QString& word) {
    for (int n = 0; n < rows(); ++n)
      if (row(n).contains(word)) return n;
    return -1;
  }
  [[nodiscard]] QAction& action(const char* name) { return *panel.findChild<QAction*>(name); }
  [[nodiscard]] QString all() {
    QStringList lines;
    for (int n = 0; n < rows(); ++n) lines << row(n);
    return lines.join('\n');
  }

  SiteDocument document;
  FaultWatch watch{document};
  FaultPanel panel{document, watch};
};

TEST_F(FaultsUnderTest, SaysThatThereAreNone) {
  EXPECT_EQ(watch.verdict().size(), 0U) << all().toStdString();
  EXPECT_TRUE(panel.findChild<QLabel*>("noFaults")->isVisible());
  EXPECT_EQ(panel.findChild<QLabel*>("noFaults")->text(), "No faults found.");
  EXPECT_EQ(panel.summary(), "No faults");
}

TEST_F(FaultsUnderTest, SaysThatItIsCheckingUntilTheVerdictIsThere) {
  ASSERT_TRUE(document.edit("Draw", [](floor::Site& site) {
    site.routes.push_back({"out", {placeAt(0.5, 0.5), placeAt(9, 0.5)}, Metres{0.2}});
  }));
  EXPECT_TRUE(watch.isChecking()) << "no event has been handled since: the window does not wait";
  EXPECT_EQ(panel.findChild<QLabel*>("checkState")->text(), "Checking…");
  ASSERT_TRUE(settled());
  EXPECT_EQ(panel.findChild<QLabel*>("checkState")->text(), "");
}

TEST_F(FaultsUnderTest, ListsErrorsFirstAndGoesToTheirPlaces) {
  QSignalSpy wanted{&panel, &FaultPanel::placeWanted};
  addRoute({placeAt(0.5, 0.5), placeAt(0.5, 0.5), placeAt(9, 0.5)});
  ASSERT_GE(rows(), 2) << all().toStdString();
  EXPECT_GE(rowWith("same point twice"), 1);
  ASSERT_EQ(rowWith("outside the zones"), 0) << all().toStdString();
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(list().model()->index(0, 0)).center());
  ASSERT_EQ(wanted.count(), 1);
  const auto box = wanted[0][0].value<SiteBox>();
  EXPECT_NEAR(box.low.x.value(), 3.0, 0.02);
  EXPECT_NEAR(box.high.x.value(), 9.0, 0.02);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Down);
  QTest::keyClick(&list(), Qt::Key_Return);
  EXPECT_EQ(wanted.count(), 2);
  std::optional<std::size_t> chosen;
  EXPECT_EQ(static_cast<int>(panel.marks(chosen).size()), rows());
  EXPECT_EQ(chosen, 1U);
}

TEST_F(FaultsUnderTest, MendsAFaultInOneStepThatCanBeUndone) {
  addRoute({placeAt(0.5, 0.5), placeAt(0.5, 0.5), placeAt(2.0, 0.5)});
  const int row = rowWith("same point twice");
  ASSERT_GE(row, 0) << all().toStdString();
  const int steps = document.undoStack().count();
  list().setCurrentIndex(list().model()->index(row, 0));
  list().setFocus();
  ASSERT_TRUE(action("mendFault").isEnabled());
  QTest::keyClick(&list(), Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(document.undoStack().count(), steps + 1);
  EXPECT_EQ(document.site().routes[0].vertices.size(), 2U);
  ASSERT_TRUE(settled());
  EXPECT_EQ(rowWith("same point twice"), -1);
  document.undoStack().undo();
  ASSERT_TRUE(settled());
  EXPECT_GE(rowWith("same point twice"), 0);
}

TEST_F(FaultsUnderTest, MovesARouteToWhereItsVehiclesHaveRoom) {
  addRoute({placeAt(0.5, 0.03), placeAt(2.0, 0.03)});
  const int row = rowWith("sticks out");
  ASSERT_GE(row, 0) << all().toStdString();
  list().setCurrentIndex(list().model()->index(row, 0));
  EXPECT_TRUE(action("mendFault").toolTip().startsWith("Move 2 vertices of route"))
      << action("mendFault").toolTip().toStdString();
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Return, Qt::ControlModifier);
  EXPECT_GT(document.site().routes[0].vertices[0].y, Metres{0.05});
  ASSERT_TRUE(settled());
  EXPECT_EQ(rowWith("sticks out"), -1) << all().toStdString();
}

TEST_F(FaultsUnderTest, OffersTheFixInTheMenuOfItsRowByKeyToo) {
  addRoute({placeAt(0.5, 0.03), placeAt(2.0, 0.03)});
  const int row = rowWith("sticks out");
  ASSERT_GE(row, 0) << all().toStdString();
  list().setCurrentIndex(list().model()->index(row, 0));
  const QPoint middle = list().visualRect(list().currentIndex()).center();
  QContextMenuEvent key{QContextMenuEvent::Keyboard, middle, list().viewport()->mapToGlobal(middle)};
  QApplication::sendEvent(list().viewport(), &key);
  auto* menu = panel.findChild<QMenu*>("faultMenu");
  ASSERT_NE(menu, nullptr);
  ASSERT_EQ(menu->actions().size(), 2);
  EXPECT_TRUE(menu->actions()[0]->text().startsWith("Move 2 vertices of route"));
  QTest::keyClick(menu, Qt::Key_Down);
  QTest::keyClick(menu, Qt::Key_Return);
  EXPECT_GT(document.site().routes[0].vertices[0].y, Metres{0.05});
}

TEST_F(FaultsUnderTest, GivesTheMarksOfOneRouteAndTheirMenu) {
  addRoute({placeAt(0.5, 0.03), placeAt(2.0, 0.03)});
  ASSERT_TRUE(document.edit("Forget", [](floor::Site& site) { site.tiles[0].uids.clear(); }));
  ASSERT_TRUE(settled());
  std::optional<std::size_t> chosen;
  ASSERT_EQ(panel.marks(chosen).size(), 2U) << all().toStdString();
  EXPECT_TRUE(panel.marks(chosen, "other").empty());
  const auto marks = panel.marks(chosen, "out");
  ASSERT_EQ(marks.size(), 1U);
  QSignalSpy wanted{&panel, &FaultPanel::placeWanted};
  QSignalSpy listed{&panel, &FaultPanel::listWanted};
  QMenu* menu = panel.menuOf(marks[0].row);
  ASSERT_EQ(menu->actions().size(), 3);
  menu->actions()[1]->trigger();
  EXPECT_EQ(wanted.count(), 1);
  menu->actions()[2]->trigger();
  EXPECT_EQ(listed.count(), 1);
  EXPECT_EQ(list().currentIndex().row(), marks[0].row);
  delete menu;
  menu = panel.menuOf(rowWith("No tag of tile"));
  EXPECT_EQ(menu->actions()[0]->text(), "No single edit mends this fault");
  EXPECT_FALSE(menu->actions()[0]->isEnabled());
  delete menu;
  EXPECT_EQ(panel.menuOf(99), nullptr);
}

TEST_F(FaultsUnderTest, ChecksWithAsMuchRoomAroundVehiclesAsIsTyped) {
  addRoute({placeAt(0.6, 0.6), placeAt(2.0, 0.6)});
  ASSERT_EQ(rows(), 0) << all().toStdString();
  QSignalSpy chosen{&panel, &FaultPanel::clearanceChosen};
  auto* room = panel.findChild<QDoubleSpinBox*>("clearance");
  EXPECT_EQ(room->value(), 0.0);
  room->setFocus();
  room->selectAll();
  QTest::keyClicks(room, "0.6");
  EXPECT_EQ(watch.clearance(), Metres{0.0}) << "not for each digit";
  QTest::keyClick(room, Qt::Key_Return);
  EXPECT_EQ(watch.clearance(), Metres{0.6});
  EXPECT_TRUE(watch.isChecking());
  ASSERT_TRUE(settled());
  EXPECT_EQ(rowWith("0.60 m of room around it"), 0) << all().toStdString();
  panel.setClearance(Metres{0.0});
  ASSERT_TRUE(settled());
  EXPECT_EQ(rows(), 0) << all().toStdString();
  EXPECT_EQ(chosen.count(), 2);
}

TEST_F(FaultsUnderTest, OffersNoMendingWhereThereIsNone) {
  addRoute({placeAt(0.5, 0.5), placeAt(9, 0.5)});
  list().setCurrentIndex(list().model()->index(rowWith("outside the zones"), 0));
  EXPECT_FALSE(action("mendFault").isEnabled());
  EXPECT_EQ(action("mendFault").toolTip(), "No single edit mends this fault.");
  EXPECT_TRUE(action("showFault").isEnabled());
}

TEST_F(FaultsUnderTest, FiltersBySeverityAndCounts) {
  addRoute({placeAt(0.5, 0.5), placeAt(0.5, 0.5), placeAt(9, 0.5)});
  const auto errors = watch.verdict().count(Severity::Error);
  const auto warnings = watch.verdict().count(Severity::Warning);
  ASSERT_GT(errors, 0U);
  ASSERT_GT(warnings, 0U);
  EXPECT_EQ(panel.title(), QString("Faults (%1)").arg(errors + warnings));
  action("showWarnings").trigger();
  EXPECT_EQ(rows(), static_cast<int>(errors));
  action("showErrors").trigger();
  EXPECT_EQ(rows(), 0);
  EXPECT_TRUE(panel.findChild<QLabel*>("noFaults")->text().contains("hidden"));
  action("showWarnings").trigger();
  EXPECT_EQ(rows(), static_cast<int>(warnings));
}

TEST_F(FaultsUnderTest, CountsWhatOneSentenceTellsOfAndListsWhatIsRareFirst) {
  addRoute({placeAt(0.5, 0.5), placeAt(0.5, 0.5), placeAt(2.0, 0.5)});
  ASSERT_TRUE(document.edit("Lay", [](floor::Site& site) {
    for (int i = 0; i < 1500; ++i) {
      site.tiles.push_back({"far " + std::to_string(i), site.tileTypes[0].name, {}});
      site.placements.push_back({site.tiles.back().serial, placeAt(0.6 * i, 100), 0});
    }
  }));
  ASSERT_TRUE(settled());
  const int warnings = 1500 + rowWith("No tag of tile");
  EXPECT_GE(rowWith("No tag of tile"), 1) << all().left(2000).toStdString();
  EXPECT_LT(rowWith("same point twice"), rowWith("No tag of tile"));
  EXPECT_EQ(panel.summary(), QString("%1 warning(s)").arg(warnings));
  EXPECT_EQ(panel.title(), QString("Faults (%1)").arg(warnings));
  EXPECT_EQ(action("showWarnings").text(), QString("Warnings (%1)").arg(warnings));
  EXPECT_TRUE(row(rows() - 1).contains("one by one: 500")) << row(rows() - 1).toStdString();
}

TEST_F(FaultsUnderTest, KeepsTheChosenFaultWhileOthersComeAndGo) {
  addRoute({placeAt(0.5, 0.5), placeAt(9, 0.5)});
  list().setCurrentIndex(list().model()->index(rowWith("outside the zones"), 0));
  ASSERT_TRUE(document.edit("Take up", [](floor::Site& site) { site.vehicles[0].readers.clear(); }));
  ASSERT_TRUE(settled());
  EXPECT_TRUE(list().currentIndex().data().toString().contains("outside the zones"));
  QEvent language{QEvent::LanguageChange};
  QApplication::sendEvent(&panel, &language);
  EXPECT_TRUE(list().currentIndex().data().toString().contains("outside the zones"));
  EXPECT_TRUE(action("showFault").isEnabled());
}

TEST_F(FaultsUnderTest, ForgetsWhatWasWrongWithTheSiteBefore) {
  addRoute({placeAt(0.5, 0.5), placeAt(9, 0.5)});
  ASSERT_GT(rows(), 0);
  open(soundSite());
  EXPECT_EQ(rows(), 0) << "before the new one is checked";
  EXPECT_TRUE(watch.isChecking());
  ASSERT_TRUE(settled());
  EXPECT_EQ(rows(), 0) << all().toStdString();
}

TEST_F(FaultsUnderTest, TriesARouteWhileItIsDrawn) {
  QSignalSpy tried{&watch, &FaultWatch::routeTried};
  const auto outcome = [&] {
    return tried.isEmpty() ? -1 : static_cast<int>(tried.last()[0].value<sitecheck::Faults>().size());
  };
  watch.tryRoute(floor::Route{"", {placeAt(0.5, 0.5), placeAt(9, 0.5)}, Metres{0.2}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !tried.isEmpty(); }, 60'000));
  EXPECT_GT(outcome(), 0);
  EXPECT_EQ(rows(), 0) << "it is not in the site";
  watch.tryRoute(floor::Route{"", {placeAt(0.5, 0.5), placeAt(2, 0.5)}, Metres{0.2}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return tried.count() == 2; }, 60'000));
  EXPECT_EQ(outcome(), 0);
  watch.tryRoute(std::nullopt);
  EXPECT_EQ(tried.count(), 3) << "nothing to wait for";
}

}  // namespace
}  // namespace tessera::ui
