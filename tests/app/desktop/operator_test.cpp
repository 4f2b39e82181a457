// An operator's work in the whole window: real mouse and keys, a real simulated world behind a pty.
#include <gmock/gmock.h>

#include <QDialog>
#include <QLabel>
#include <QMessageBox>
#include <algorithm>

#include "app/desktop/desktop_fixture.h"
#include "app/experiment/summary.h"
#include "app/process/world_process.h"
#include "app/tessera/site_files.h"
#include "app/world/world_options.h"
#include "base/polyline.h"
#include "floor/site_json.h"
#include "host/supervisor_thread.h"

namespace tessera::desktop {
namespace {

using supervisor::PortState;
using supervisor::Task;

class Operator : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    ASSERT_NO_FATAL_FAILURE(startDemo());
  }
  [[nodiscard]] std::size_t routes() { return window->document().site().routes.size(); }
  [[nodiscard]] bool stands() const {
    return vehicle().state == wire::VehicleState::Standing && vehicle().speed == MetresPerSecond{};
  }
  void runAndMove() {
    pressWhenOffered("runAction", Qt::Key_F5);
    ASSERT_TRUE(until([&] { return vehicle().task == Task::Running && vehicle().speed > MetresPerSecond{0.02}; }))
        << vehicle().waits.english() << vehicle().doing.english();
  }
  /// The vehicle's battery is pulled; the last that is heard of it is that it drove.
  void dieOnTheWay() {
    window->session().tellWorld("kill 1");
    ASSERT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Silent; }));
  }
};

TEST_F(Operator, drawsARouteUndoesItToNothingAndRedoesIt) {
  const auto before = window->document().site();
  drawRoute({{0.3, 0.3}, {0.3, 1.5}, {1.5, 1.5}});
  ASSERT_EQ(routes(), before.routes.size() + 1);
  const auto drawn = window->document().site();
  ASSERT_EQ(drawn.routes.back().vertices.size(), 3U);
  EXPECT_NEAR(drawn.routes.back().vertices.back().x.value(), 1.5, 0.03);
  EXPECT_TRUE(window->isWindowModified());
  while (window->document().undoStack().canUndo()) press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), before);
  EXPECT_FALSE(window->isWindowModified());
  while (window->document().undoStack().canRedo()) press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(window->document().site(), drawn);
}

TEST_F(Operator, leavesAnUnfinishedRouteByEscape) {
  const auto before = window->document().site();
  trigger("drawRoute");
  clickFloor(0.3, 0.3);
  clickFloor(0.9, 0.9);
  QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  EXPECT_EQ(window->document().site(), before);
  EXPECT_TRUE(find<QAction>("drawRoute")->isChecked()) << "the first Escape drops the route, not the tool";
  QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  EXPECT_TRUE(find<QAction>("browse")->isChecked());
}

TEST_F(Operator, drivesARouteDrawnAMomentAgoPausesAndStopsIt) {
  drawRoute({{0.3, 0.3}, {0.3, 1.5}, {1.5, 1.5}});
  const std::string name = window->document().site().routes.back().name;
  ASSERT_EQ(window->selection().route().toStdString(), name);
  ASSERT_NO_FATAL_FAILURE(runAndMove());
  EXPECT_EQ(vehicle().route, name);
  pressWhenOffered("pauseAction", Qt::Key_F6);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Paused && stands(); }));
  pressWhenOffered("pauseAction", Qt::Key_F6);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Running; }));
  pressWhenOffered("stopAction", Qt::Key_F7);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Stopped && stands(); }));
}

TEST_F(Operator, stopsAllByOneKeyFromWithinADialogue) {
  ASSERT_NO_FATAL_FAILURE(runAndMove());
  QDialog dialog{window.get()};
  dialog.setModal(true);
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  QTest::keyClick(&dialog, Qt::Key_F12);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Stopped && stands(); }));
}

TEST_F(Operator, stopsAllByTheRedButton) {
  ASSERT_NO_FATAL_FAILURE(runAndMove());
  ASSERT_TRUE(find("stopAllButton")->isVisible());
  QTest::mousePress(find("stopAllButton"), Qt::LeftButton);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Stopped && stands(); })) << "when pressed, not when let go";
  QTest::mouseRelease(find("stopAllButton"), Qt::LeftButton);
}

TEST_F(Operator, seesAPulledPortAndGoesOnWhenItIsPluggedInAgain) {
  ASSERT_NO_FATAL_FAILURE(runAndMove());
  window->session().tellWorld("pull");
  ASSERT_TRUE(until([&] { return window->session().latest()->port.state == PortState::Lost; }));
  EXPECT_TRUE(until([&] {
    return find<QLabel>("portLabel")->text().toStdString() == window->session().latest()->port.sentence.english();
  }));
  window->session().tellWorld("plug");
  ASSERT_TRUE(until([&] { return window->session().latest()->port.state == PortState::Open; }));
  const Metres from = vehicle().progress;
  EXPECT_TRUE(until([&] { return vehicle().progress > from + Metres{0.1}; })) << vehicle().waits.english();
}

TEST_F(Operator, isAskedBeforeChangesAreLostAndMayStay) {
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  answerQuestion("saveQuestion", "Cancel");
  EXPECT_FALSE(closeWindow());
  EXPECT_TRUE(window->isVisible());
  const QString path = window->document().path();
  const auto drawn = window->document().site();
  answerQuestion("saveQuestion", "Save");
  EXPECT_TRUE(closeWindow());
  EXPECT_EQ(floor::loadSite(path.toStdString()).value(), drawn);
}

TEST_F(Operator, readsEverythingInChineseWhileTheVehicleDrives) {
  ASSERT_NO_FATAL_FAILURE(runAndMove());
  trigger("language_zh_CN");
  EXPECT_TRUE(until([&] { return find<QAction>("drawRoute")->text().contains(QStringLiteral("路径")); }));
  EXPECT_EQ(vehicle().task, Task::Running);
  trigger("language_en");
  EXPECT_TRUE(until([&] { return find<QAction>("drawRoute")->text() == QStringLiteral("&Draw a route"); }));
}

TEST_F(Operator, isToldOfAVehicleThatDidNotConfirmThatItStands) {
  ASSERT_NO_FATAL_FAILURE(runAndMove());
  ASSERT_NO_FATAL_FAILURE(dieOnTheWay());
  QString told;
  inDialogue(QStringLiteral("unconfirmedNotice"),
             [&](QDialog& dialog) { told = dynamic_cast<QMessageBox&>(dialog).text(); });
  EXPECT_TRUE(closeWindow());
  EXPECT_TRUE(told.contains(QStringLiteral("AGV 1"))) << told.toStdString();
}

TEST_F(Operator, whoDoesNotAskIsNotKeptByAVehicleThatDoesNotConfirm) {
  ASSERT_NO_FATAL_FAILURE(runAndMove());
  ASSERT_NO_FATAL_FAILURE(dieOnTheWay());
  testing::internal::CaptureStderr();
  window->endUnasked();
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("AGV 1"));
  EXPECT_FALSE(window->isVisible());
}

// The world is one that the window knows nothing of, so that its record tells what the vehicle did after the window
// had gone.
TEST(ClosingTheWindow, stopsTheVehicleFirst) {
  class Alone : public DesktopTest {
  public:
    void TestBody() override {
      ASSERT_NO_FATAL_FAILURE(openWindow(false));
      const auto demo = SiteFiles::demoPath();
      ASSERT_TRUE(demo);
      world::WorldOptions options;
      options.site = demo->toStdString();
      options.truth = home.filePath("truth.csv").toStdString();
      process::WorldProcess world;
      ASSERT_TRUE(world.start(world::worldArguments(options)));
      ASSERT_TRUE(window->files().open(*demo));
      ui::ConnectionChoice choice;
      choice.kind = ui::ConnectionChoice::Kind::Serial;
      choice.port = QString::fromStdString(world.port());
      window->session().connectTo(choice, window->document().map());
      ASSERT_TRUE(until([&] { return vehicle().located; }));
      pressWhenOffered("runAction", Qt::Key_F5);
      ASSERT_TRUE(until([&] { return vehicle().speed > MetresPerSecond{0.05}; }));
      EXPECT_EQ(vehicle().command->mode, wire::CommandMode::Drive);
      ASSERT_TRUE(closeWindow());
      const Seconds closed = host::steadyNow();
      std::vector<MetresPerSecond> speeds;  // from then on, for half a second
      ASSERT_TRUE(until([&] {
        const auto track = experiment::readTruth(options.truth, 1);
        speeds.clear();
        for (const auto& truth : track->poses())
          if (truth.at > closed) speeds.push_back(truth.speed);
        return !track->poses().empty() && track->poses().back().at > closed + Seconds{0.5};
      }));
      EXPECT_LT(*std::max_element(speeds.begin(), speeds.end()), MetresPerSecond{0.005}) << "it stands when we go";
    }
  };
  Alone{}.TestBody();
}

}  // namespace
}  // namespace tessera::desktop
