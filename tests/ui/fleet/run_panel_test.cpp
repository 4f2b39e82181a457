#include "ui/fleet/run_panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "ui/fleet/fake_fleet.h"

namespace tessera::ui {
namespace {

using testing::ElementsAre;

class RunPanelTest : public testing::Test {
protected:
  RunPanelTest() {
    openFakeSite(document, 2, {"one", "two"});
    panel.resize(320, 480);
    panel.show();
    panel.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&panel));
  }

  template <class Widget>
  [[nodiscard]] Widget* find(const char* name) const {
    auto* found = panel.findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void press(const char* button) { QTest::mouseClick(find<QToolButton>(button), Qt::LeftButton); }
  [[nodiscard]] bool can(const char* button) const { return find<QToolButton>(button)->isEnabled(); }
  [[nodiscard]] QString tip(const char* button) const { return find<QToolButton>(button)->toolTip(); }
  [[nodiscard]] QString label(const char* name) const { return find<QLabel>(name)->text(); }
  void showState(const supervisor::Snapshot& snapshot, const QString& state) {
    link.show(snapshot);
    ASSERT_TRUE(QTest::qWaitFor([&] { return label("vehicleState") == state; })) << label("vehicleState").toStdString();
  }
  // Number 1 is chosen and ready for route "one".
  void beReady() {
    selection.setVehicle(VehicleId{1});
    selection.setRoute("one");
    showState(fakeSnapshot(2), "Ready");
  }

  FakeFleet link;
  Selection selection;
  SiteDocument document;
  RunPanel panel{link, selection, document};
};

TEST_F(RunPanelTest, SaysWhatIsMissingForADrive) {
  EXPECT_THAT(tip("runButton").toStdString(), testing::HasSubstr("Choose a vehicle"));
  selection.setVehicle(VehicleId{1});
  EXPECT_FALSE(can("runButton"));
  EXPECT_THAT(tip("runButton").toStdString(), testing::HasSubstr("Connect first"));
  showState(fakeSnapshot(2), "Ready");
  EXPECT_FALSE(can("runButton"));
  EXPECT_THAT(tip("runButton").toStdString(), testing::HasSubstr("Choose a route"));
  selection.setRoute("two");
  EXPECT_TRUE(can("runButton"));
  EXPECT_THAT(tip("runButton").toStdString(), testing::HasSubstr("(F5)"));
  EXPECT_FALSE(can("pauseButton"));
  EXPECT_FALSE(can("clearButton"));
  EXPECT_TRUE(can("stopButton"));
}

TEST_F(RunPanelTest, RunsByMouseWithRouteAndSpeedChosenInThePanel) {
  selection.setVehicle(VehicleId{2});
  showState(fakeSnapshot(2), "Ready");
  auto* routes = find<QComboBox>("routeBox");
  routes->setFocus();
  QTest::keyClick(routes, Qt::Key_Down);
  QTest::keyClick(routes, Qt::Key_Down);
  EXPECT_EQ(selection.route(), "two");
  auto* speed = find<QDoubleSpinBox>("speedBox");
  EXPECT_DOUBLE_EQ(speed->maximum(), 0.5);
  speed->setFocus();
  speed->selectAll();
  QTest::keyClicks(speed, QLocale{}.toString(0.45, 'f', 2));
  press("runButton");
  EXPECT_THAT(link.all<supervisor::RunRoute>(),
              ElementsAre(supervisor::RunRoute{VehicleId{2}, "two", MetresPerSecond{0.45}}));
}

TEST_F(RunPanelTest, KeysRunPauseResumeAndStop) {
  beReady();
  QTest::keyClick(panel.windowHandle(), Qt::Key_F5);
  ASSERT_EQ(link.all<supervisor::RunRoute>().size(), 1U);
  auto snapshot = fakeSnapshot(2);
  setRunning(snapshot.vehicles[0], "one", 1.0, 4.0);
  showState(snapshot, "Running");
  QTest::keyClick(panel.windowHandle(), Qt::Key_F6);
  EXPECT_THAT(link.all<supervisor::Pause>(), ElementsAre(supervisor::Pause{VehicleId{1}}));
  snapshot.vehicles[0].task = supervisor::Task::Paused;
  showState(snapshot, "Paused");
  EXPECT_EQ(find<QToolButton>("pauseButton")->text(), "Resume");
  QTest::keyClick(panel.windowHandle(), Qt::Key_F6);
  EXPECT_THAT(link.all<supervisor::Resume>(), ElementsAre(supervisor::Resume{VehicleId{1}}));
  QTest::keyClick(panel.windowHandle(), Qt::Key_F7);
  EXPECT_THAT(link.all<supervisor::Stop>(), ElementsAre(supervisor::Stop{VehicleId{1}}));
}

TEST_F(RunPanelTest, DoesNotRunTwiceWhatRunsAlready) {
  beReady();
  press("runButton");
  auto snapshot = fakeSnapshot(2);
  setRunning(snapshot.vehicles[0], "one", 1.0, 4.0);
  showState(snapshot, "Running");
  EXPECT_FALSE(can("runButton"));
  QTest::keyClick(panel.windowHandle(), Qt::Key_F5);
  EXPECT_EQ(link.all<supervisor::RunRoute>().size(), 1U);
  selection.setRoute("two");
  EXPECT_TRUE(can("runButton"));
}

TEST_F(RunPanelTest, JudgesAnOrderByTheNewestPicture) {
  beReady();
  auto snapshot = fakeSnapshot(2);
  snapshot.vehicles[0].contact = supervisor::Contact::Silent;
  link.show(snapshot);  // not drawn yet
  QTest::keyClick(panel.windowHandle(), Qt::Key_F5);
  EXPECT_TRUE(link.all<supervisor::RunRoute>().empty());
  EXPECT_EQ(label("vehicleState"), "Silent");
}

TEST_F(RunPanelTest, TellsProgressAndWhatIsLeft) {
  beReady();
  auto snapshot = fakeSnapshot(2);
  setRunning(snapshot.vehicles[0], "one", 1.0, 4.0);
  showState(snapshot, "Running");
  EXPECT_EQ(find<QProgressBar>("progress")->value(), 250);
  const QLocale locale;
  EXPECT_THAT(label("remaining").toStdString(),
              testing::StartsWith(QString{"%1 of %2 m on the route one, about"}
                                      .arg(locale.toString(1.0, 'f', 1), locale.toString(4.0, 'f', 1))
                                      .toStdString()));
}

TEST_F(RunPanelTest, KeepsItsButtonsInPlaceWhenPauseBecomesResume) {
  beReady();
  auto snapshot = fakeSnapshot(2);
  setRunning(snapshot.vehicles[0], "one", 1.0, 4.0);
  showState(snapshot, "Running");
  const QRect before = find<QToolButton>("stopButton")->geometry();
  snapshot.vehicles[0].task = supervisor::Task::Paused;
  showState(snapshot, "Paused");
  panel.layout()->activate();
  QTest::qWait(50);
  EXPECT_EQ(find<QToolButton>("stopButton")->geometry(), before);
}

TEST(TimeLeft, fallsInStepsAndRisesOnlyByMuch) {
  TimeLeft left;
  EXPECT_EQ(left.shown(61.0), 60);
  EXPECT_EQ(left.shown(59.0), 60);
  EXPECT_EQ(left.shown(64.0), 60) << "a bend";
  EXPECT_EQ(left.shown(54.0), 55);
  EXPECT_EQ(left.shown(58.0), 55);
  EXPECT_EQ(left.shown(80.0), 80) << "it is slow indeed";
  EXPECT_EQ(left.shown(0.3), 5);
  left.reset();
  EXPECT_EQ(left.shown(12.0), 10);
}

TEST_F(RunPanelTest, HoldsTheTimeLeftWhileASpeedWavers) {
  beReady();
  auto snapshot = fakeSnapshot(2);
  setRunning(snapshot.vehicles[0], "one", 1.0, 31.0);
  showState(snapshot, "Running");
  const auto said = [&] { return label("remaining").section("about", 1); };
  for (int n = 0; n < 3; ++n) {
    link.show(snapshot);
    QTest::qWait(120);
  }
  QStringList all{said()};
  for (const double speed : {0.28, 0.31, 0.27, 0.30, 0.28}) {
    snapshot.vehicles[0].speed = MetresPerSecond{speed};
    link.show(snapshot);
    QTest::qWait(120);
    if (said() != all.back()) all << said();
  }
  EXPECT_LE(all.size(), 2) << all.join(" | ").toStdString();
}

TEST_F(RunPanelTest, SaysWhyItWaits) {
  beReady();
  auto snapshot = fakeSnapshot(2);
  setRunning(snapshot.vehicles[0], "one", 1.0, 4.0);
  snapshot.vehicles[0].waits = "AGV 1 waits: an obstacle stands before it.";
  showState(snapshot, "Waiting");
  EXPECT_EQ(label("situation"), "AGV 1 waits: an obstacle stands before it.");
}

TEST_F(RunPanelTest, NamesFaultsAndClearsThem) {
  beReady();
  auto snapshot = fakeSnapshot(2);
  snapshot.vehicles[0].state = wire::VehicleState::Faulted;
  snapshot.vehicles[0].faults = wire::kFaultMotorStall;
  showState(snapshot, "Fault");
  EXPECT_THAT(label("situation").toStdString(), testing::HasSubstr("Motor stalled"));
  EXPECT_FALSE(can("runButton"));
  press("clearButton");
  EXPECT_THAT(link.all<supervisor::Clear>(), ElementsAre(supervisor::Clear{VehicleId{1}}));
}

TEST_F(RunPanelTest, TellsThatAnOrderWasNotTakenOrRefused) {
  beReady();
  link.takesOrders = false;
  press("stopButton");
  EXPECT_TRUE(find<QLabel>("runNotice")->isVisible());
  EXPECT_THAT(label("runNotice").toStdString(), testing::HasSubstr("no connection"));
  link.takesOrders = true;
  press("stopButton");
  EXPECT_FALSE(find<QLabel>("runNotice")->isVisible());
  supervisor::Event refused;
  refused.kind = supervisor::EventKind::OrderRefused;
  refused.vehicle = VehicleId{2};
  link.tell({refused});
  EXPECT_FALSE(find<QLabel>("runNotice")->isVisible()) << "another vehicle's";
  refused.vehicle = VehicleId{1};
  refused.sentence = "AGV 1 cannot go on.";
  link.tell({refused});
  EXPECT_TRUE(find<QLabel>("runNotice")->isVisible());
  EXPECT_EQ(label("runNotice"), "AGV 1 cannot go on.");
}

TEST_F(RunPanelTest, KeepsTheSpeedOfEachVehicle) {
  beReady();
  auto* speed = find<QDoubleSpinBox>("speedBox");
  speed->setFocus();
  QTest::keyClick(speed, Qt::Key_Up);
  EXPECT_DOUBLE_EQ(speed->value(), 0.35);
  selection.setVehicle(VehicleId{2});
  EXPECT_DOUBLE_EQ(speed->value(), 0.30);
  selection.setVehicle(VehicleId{1});
  EXPECT_DOUBLE_EQ(speed->value(), 0.35);
}

TEST_F(RunPanelTest, ListsTheSitesRoutesAndOffersToDrawOne) {
  beReady();
  EXPECT_EQ(find<QComboBox>("routeBox")->currentText(), "one");
  EXPECT_FALSE(find<QToolButton>("drawRouteButton")->isVisible());
  ASSERT_TRUE(document.edit("Delete", [](floor::Site& site) { site.routes.clear(); }).has_value());
  EXPECT_EQ(selection.route(), QString{});
  EXPECT_FALSE(can("runButton"));
  QSignalSpy asked{&panel, &RunPanel::drawRouteRequested};
  press("drawRouteButton");
  EXPECT_EQ(asked.size(), 1);
  document.undoStack().undo();
  EXPECT_EQ(find<QComboBox>("routeBox")->count(), 2);
}

TEST_F(RunPanelTest, TakesTheOnlyRouteThereIs) {
  openFakeSite(document, 1, {"alone"});
  EXPECT_EQ(selection.route(), "alone");
}

}  // namespace
}  // namespace tessera::ui
