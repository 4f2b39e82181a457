#include "ui/fleet/vehicle_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "ui/fleet/fake_fleet.h"

namespace tessera::ui {
namespace {

class VehicleTableTest : public testing::Test {
protected:
  explicit VehicleTableTest(int vehicles = 3) {
    openFakeSite(document, vehicles, {"one", "two"});
    table.resize(1100, 300);
    table.show();
  }

  [[nodiscard]] QTreeView* list() const { return table.findChild<QTreeView*>("vehicleList"); }
  [[nodiscard]] QString cell(int row, int column) const {
    return list()->model()->index(row, column).data().toString();
  }
  // A picture may be held back for a tenth of a second.
  void showAndWait(const supervisor::Snapshot& snapshot, int row, int column, const QString& text) {
    link.show(snapshot);
    ASSERT_TRUE(QTest::qWaitFor([&] { return cell(row, column) == text; })) << cell(row, column).toStdString();
  }
  void click(int row, Qt::MouseButton button = Qt::LeftButton) {
    const QRect place = list()->visualRect(list()->model()->index(row, 0));
    QTest::mouseClick(list()->viewport(), button, {}, place.center());
  }

  FakeFleet link;
  Selection selection;
  SiteDocument document;
  VehicleTable table{link, selection, document};
};

using M = VehicleModel;

TEST_F(VehicleTableTest, TellsHowEachVehicleStands) {
  auto snapshot = fakeSnapshot(3);
  setRunning(snapshot.vehicles[0], "one", 1.0, 4.0);
  snapshot.vehicles[1].contact = supervisor::Contact::Silent;
  snapshot.vehicles[1].link.age = Seconds{12.0};
  snapshot.vehicles[2].state = wire::VehicleState::Faulted;
  snapshot.vehicles[2].faults = wire::kFaultBattery;
  showAndWait(snapshot, 0, M::State, "Running");
  EXPECT_EQ(cell(0, M::Name), "AGV 1");
  EXPECT_EQ(cell(0, M::Progress), "25 %");
  EXPECT_EQ(cell(0, M::RouteName), "one");
  EXPECT_EQ(cell(0, M::Speed), QLocale{}.toString(0.30, 'f', 2) + " m/s");
  EXPECT_EQ(cell(0, M::Battery), QLocale{}.toString(24.6, 'f', 1) + " V");
  EXPECT_EQ(cell(0, M::Link), "2 % lost");
  EXPECT_EQ(cell(0, M::Age), QLocale{}.toString(0.2, 'f', 1) + " s");
  EXPECT_EQ(cell(0, M::Place), "± " + QLocale{}.toString(1.2, 'f', 1) + " cm");
  EXPECT_EQ(cell(1, M::State), "Silent");
  EXPECT_EQ(cell(1, M::Age), "12 s");
  EXPECT_EQ(cell(2, M::State), "Fault");
  EXPECT_EQ(list()->model()->index(2, M::Battery).data(IconRole).toString(), "battery-low");
}

TEST_F(VehicleTableTest, SaysNothingOfVehiclesThatWereNeverHeard) {
  auto snapshot = fakeSnapshot(3);
  snapshot.vehicles[0].contact = supervisor::Contact::Calling;
  snapshot.vehicles[0].link.lastHeard.reset();
  showAndWait(snapshot, 0, M::State, "Calling");
  for (const int column : {M::Speed, M::Battery, M::Link, M::Age, M::Place}) EXPECT_EQ(cell(0, column), "–");
}

TEST_F(VehicleTableTest, ClickChoosesAndSelectionIsShown) {
  click(1);
  EXPECT_EQ(selection.vehicle(), VehicleId{2});
  selection.setVehicle(VehicleId{3});
  EXPECT_EQ(list()->currentIndex().row(), 2);
  QTest::keyClick(list(), Qt::Key_Up);
  EXPECT_EQ(selection.vehicle(), VehicleId{2});
}

TEST_F(VehicleTableTest, DoubleClickAsksToFollow) {
  QSignalSpy follow{&table, &VehicleTable::followRequested};
  const QPoint place = list()->visualRect(list()->model()->index(1, 0)).center();
  QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, place);
  ASSERT_EQ(follow.size(), 1);
  EXPECT_EQ(follow.front().front().value<VehicleId>(), VehicleId{2});
}

TEST_F(VehicleTableTest, MenuOrdersWhatMakesSense) {
  auto snapshot = fakeSnapshot(3);
  setRunning(snapshot.vehicles[1], "one", 1.0, 4.0);
  showAndWait(snapshot, 1, M::State, "Running");
  const QPoint place = list()->visualRect(list()->model()->index(1, 0)).center();
  QContextMenuEvent event{QContextMenuEvent::Mouse, place, list()->viewport()->mapToGlobal(place)};
  QApplication::sendEvent(list()->viewport(), &event);
  auto* menu = list()->findChild<QMenu*>("vehicleMenu");
  ASSERT_NE(menu, nullptr);
  EXPECT_FALSE(menu->findChild<QAction*>("menuResume")->isEnabled());
  EXPECT_FALSE(menu->findChild<QAction*>("menuClear")->isEnabled());
  auto* pause = menu->findChild<QAction*>("menuPause");
  ASSERT_TRUE(pause->isEnabled());
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(pause).center());
  EXPECT_THAT(link.all<supervisor::Pause>(), testing::ElementsAre(supervisor::Pause{VehicleId{2}}));
}

TEST_F(VehicleTableTest, SaysWhenThereIsNoConnection) {
  auto* connectButton = table.findChild<QPushButton*>("connectButton");
  EXPECT_TRUE(connectButton->isVisible());
  QSignalSpy asked{&table, &VehicleTable::connectRequested};
  QTest::mouseClick(connectButton, Qt::LeftButton);
  EXPECT_EQ(asked.size(), 1);
  link.show(fakeSnapshot(3));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !connectButton->isVisible(); }));
  EXPECT_EQ(cell(0, M::State), "Ready");
  link.showNothing();
  EXPECT_TRUE(QTest::qWaitFor([&] { return connectButton->isVisible(); }));
  EXPECT_EQ(cell(0, M::State), "Not connected");
}

TEST_F(VehicleTableTest, OffersToSetUpAVehicleWhereThereIsNone) {
  openFakeSite(document, 0, {});
  auto* button = table.findChild<QPushButton*>("commissionButton");
  ASSERT_TRUE(button->isVisible());
  EXPECT_FALSE(list()->isVisible());
  QSignalSpy asked{&table, &VehicleTable::commissionRequested};
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(asked.size(), 1);
}

TEST_F(VehicleTableTest, ForgetsAChosenVehicleThatIsGoneAndTakesTheOnlyOne) {
  selection.setVehicle(VehicleId{3});
  openFakeSite(document, 2, {});
  EXPECT_EQ(selection.vehicle(), std::nullopt);
  openFakeSite(document, 1, {});
  EXPECT_EQ(selection.vehicle(), VehicleId{1});
}

class LongVehicleTableTest : public VehicleTableTest {
protected:
  LongVehicleTableTest() : VehicleTableTest{100} {}
};

TEST_F(LongVehicleTableTest, KeepsSelectionSortingAndScrollWhilePicturesCome) {
  auto snapshot = fakeSnapshot(100);
  for (int i = 0; i < 100; ++i) snapshot.vehicles[static_cast<std::size_t>(i)].batteryVolts = 20.0 + 0.1 * (i % 50);
  showAndWait(snapshot, 0, M::Battery, QLocale{}.toString(20.0, 'f', 1) + " V");
  list()->sortByColumn(M::Battery, Qt::DescendingOrder);
  EXPECT_EQ(cell(0, M::Battery), QLocale{}.toString(24.9, 'f', 1) + " V");
  selection.setVehicle(VehicleId{60});
  list()->verticalScrollBar()->setValue(7);
  const QString below = cell(7, M::Name);
  for (auto& v : snapshot.vehicles) v.link.age += Seconds{1.0};
  showAndWait(snapshot, 0, M::Age, QLocale{}.toString(1.2, 'f', 1) + " s");
  EXPECT_EQ(selection.vehicle(), VehicleId{60});
  EXPECT_EQ(list()->currentIndex().data().toString(), "AGV 60");
  EXPECT_TRUE(list()->selectionModel()->isRowSelected(list()->currentIndex().row(), {}));
  EXPECT_EQ(list()->verticalScrollBar()->value(), 7);
  EXPECT_EQ(cell(7, M::Name), below);
  EXPECT_EQ(list()->header()->sortIndicatorSection(), M::Battery);
}

TEST_F(LongVehicleTableTest, SortsAgainWhenTheOrderChanged) {
  auto snapshot = fakeSnapshot(100);
  showAndWait(snapshot, 0, M::State, "Ready");
  list()->sortByColumn(M::Battery, Qt::AscendingOrder);
  snapshot.vehicles[99].batteryVolts = 18.0;
  link.show(snapshot);
  EXPECT_TRUE(QTest::qWaitFor([&] { return cell(0, M::Name) == "AGV 100"; }));
}

TEST(VehicleModel, TellsOnlyWhatAReaderWouldSee) {
  SiteDocument document;
  openFakeSite(document, 100, {});
  VehicleModel model{document};
  auto snapshot = fakeSnapshot(100);
  model.setSnapshot(std::make_shared<supervisor::Snapshot>(snapshot));
  QSignalSpy changes{&model, &QAbstractItemModel::dataChanged};
  snapshot.time += Seconds{0.02};
  for (auto& v : snapshot.vehicles) v.pose.position.x += Metres{0.01};
  model.setSnapshot(std::make_shared<supervisor::Snapshot>(snapshot));
  EXPECT_EQ(changes.size(), 0);
  snapshot.vehicles[41].speed = MetresPerSecond{0.2};
  model.setSnapshot(std::make_shared<supervisor::Snapshot>(snapshot));
  ASSERT_EQ(changes.size(), 1);
  EXPECT_EQ(changes[0][0].toModelIndex(), model.index(41, VehicleModel::Speed));
}

}  // namespace
}  // namespace tessera::ui
