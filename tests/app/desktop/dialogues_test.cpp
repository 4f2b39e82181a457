// The window's own dialogues and the button that stops all vehicles: it is pressed where it always is, through whatever
// window lies there, while a vehicle drives.
#include <QAbstractItemView>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMessageBox>
#include <QWindow>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/site_files.h"

namespace tessera::desktop {
namespace {

using supervisor::Task;

class Dialogues : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    window->move(QPoint{700, 0} - find("stopAllButton")->mapTo(window.get(), QPoint{}));  // the corner is on the screen
    ASSERT_NO_FATAL_FAILURE(startDemo());
    pressWhenOffered("runAction", Qt::Key_F5);
    ASSERT_TRUE(until([&] { return vehicle().task == Task::Running && vehicle().speed > MetresPerSecond{0.02}; }));
  }
  [[nodiscard]] bool stands() const {
    return vehicle().task == Task::Stopped && vehicle().state == wire::VehicleState::Standing;
  }
  /// As the window system does it: to the foremost window that lies there.
  void pressTheCorner() const {
    const QWidget& button = *find("stopAllButton");
    const QPoint corner = button.mapToGlobal(button.rect().center());
    QWindow* there = QGuiApplication::topLevelAt(corner);
    ASSERT_NE(there, nullptr);
    QTest::mouseClick(there, Qt::LeftButton, {}, there->mapFromGlobal(corner));
  }
  /// Presses it once the dialogue of this name is open, which stays open.
  void stopWithin(const char* name) {
    inDialogue(QString::fromLatin1(name), [this](QDialog& dialogue) {
      const auto laidOver = [&] {
        const auto* standIn = dialogue.findChild<QWidget*>("stopAllStandIn");
        return standIn != nullptr && standIn->isVisible();
      };
      EXPECT_TRUE(until(laidOver));
      ASSERT_NO_FATAL_FAILURE(pressTheCorner());
      EXPECT_TRUE(until([&] { return stands(); }));
      EXPECT_TRUE(dialogue.isVisible());
    });
  }
};

TEST_F(Dialogues, letTheButtonBePressedWhileAFileIsChosen) {
  stopWithin("QFileDialog");
  trigger("saveAs");
  EXPECT_TRUE(stands());
}

TEST_F(Dialogues, letTheButtonBePressedWhileAQuestionIsOpenAndAfterIt) {
  ASSERT_TRUE(window->document().edit("Rename", [](floor::Site& site) { site.name += " 2"; }));
  stopWithin("saveQuestion");
  EXPECT_FALSE(window->files().mayLeave());
  EXPECT_TRUE(stands());
  window->activateWindow();  // a desktop does so by itself after a dialogue
  ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  pressWhenOffered("runAction", Qt::Key_F5);
  ASSERT_TRUE(until([&] { return vehicle().task == Task::Running && vehicle().speed > MetresPerSecond{0.02}; }));
  ASSERT_NO_FATAL_FAILURE(pressTheCorner());
  EXPECT_TRUE(until([&] { return stands(); }));
}

TEST_F(Dialogues, letTheButtonBePressedBesideTheWizardOfAVehicle) {
  inDialogue("commissionWizard", [this](QDialog& wizard) {
    EXPECT_TRUE(until([&] { return wizard.findChild<QWidget*>("stopAllStandIn") != nullptr; }));
    ASSERT_NO_FATAL_FAILURE(pressTheCorner());
    EXPECT_TRUE(until([&] { return stands(); }));
  });
  trigger("commission");
  EXPECT_TRUE(stands());
}

}  // namespace
}  // namespace tessera::desktop
