// The button that stops all vehicles, reached by mouse while a modal dialogue is open. The mouse goes to the window
// that lies there, as the window system sends it; what Qt lets through to it is the point.
#include "ui/fleet/stop_all_reach.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>
#include <QWizard>
#include <functional>

#include "ui/fleet/fake_fleet.h"

namespace tessera::ui {
namespace {

using supervisor::StopAll;

class StopAllBesideDialogues : public testing::Test {
protected:
  StopAllBesideDialogues() {
    window.menuBar()->addMenu("Site")->addAction("Open");
    window.menuBar()->setCornerWidget(button, Qt::TopRightCorner);
    window.resize(500, 400);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
  }
  [[nodiscard]] QPoint corner() const { return button->mapToGlobal(button->rect().center()); }
  /// Presses and lets go whatever lies at the corner of the window. Gives how many orders that was.
  std::size_t pressTheCorner() {
    const std::size_t before = ordered();
    // A window manager takes a moment to put up what was shown and to take down what was closed.
    QWindow* there = nullptr;
    EXPECT_TRUE(QTest::qWaitFor([&] {
      there = QGuiApplication::topLevelAt(corner());
      const QWidget* modal = QApplication::activeModalWidget();
      const QWidget* wanted = modal == nullptr ? &window : modal->findChild<QWidget*>("stopAllStandIn");
      return wanted != nullptr && there == wanted->windowHandle();
    })) << "what lies there is "
        << (there == nullptr ? "nothing" : there->objectName().toStdString());
    if (there == nullptr) return 0;
    QTest::mouseClick(there, Qt::LeftButton, {}, there->mapFromGlobal(corner()));
    return ordered() - before;
  }
  std::size_t ordered() { return link.all<StopAll>().size(); }
  /// Whether the corner is as it should be with this dialogue in front.
  static bool standsInFor(const QWidget& dialogue) {
    const auto* standIn = dialogue.findChild<StopAllButton*>("stopAllStandIn");
    return standIn != nullptr && standIn->isVisible();
  }
  /// Runs the dialogue and does this from within its loop.
  static void within(QDialog& dialogue, const std::function<void()>& work) {
    QTimer::singleShot(0, &dialogue, [&] {
      EXPECT_TRUE(QTest::qWaitForWindowExposed(&dialogue));
      EXPECT_EQ(QApplication::activeModalWidget(), &dialogue);
      EXPECT_TRUE(QTest::qWaitFor([&] { return standsInFor(dialogue); }));
      work();
      dialogue.reject();
    });
    dialogue.exec();
  }

  FakeFleet link;
  QMainWindow window;
  StopAllButton* button = new StopAllButton{link};
  StopAllReach standIn{*button, link, nullptr};
};

TEST_F(StopAllBesideDialogues, ActsWithoutAnyDialogueAsBefore) { EXPECT_EQ(pressTheCorner(), 1U); }

TEST_F(StopAllBesideDialogues, ActsBesideADialogueWhichKeepsTheKeys) {
  QDialog dialogue{&window};
  auto* layout = new QVBoxLayout{&dialogue};
  auto* edit = new QLineEdit;
  layout->addWidget(edit);
  within(dialogue, [&] {
    EXPECT_TRUE(QTest::qWaitForWindowActive(&dialogue));
    edit->setFocus();
    QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, window.mapFromGlobal(corner()));
    EXPECT_EQ(ordered(), 0U) << "the window itself is deaf meanwhile";
    EXPECT_EQ(pressTheCorner(), 1U);
    EXPECT_EQ(pressTheCorner(), 1U);
    EXPECT_TRUE(dialogue.isVisible());
    EXPECT_TRUE(dialogue.isActiveWindow());
    EXPECT_TRUE(edit->hasFocus());
  });
  EXPECT_TRUE(QTest::qWaitFor([&] { return !standsInFor(dialogue); }));
  EXPECT_EQ(pressTheCorner(), 1U) << "the button itself, again";
}

TEST_F(StopAllBesideDialogues, ActsBesideAMessageBox) {
  QMessageBox box{QMessageBox::Warning, "Site", "It could not be saved.", QMessageBox::Ok, &window};
  within(box, [&] { EXPECT_EQ(pressTheCorner(), 1U); });
  EXPECT_EQ(pressTheCorner(), 1U);
}

TEST_F(StopAllBesideDialogues, ActsBesideAMessageBoxThatBelongsToNoWindow) {
  QMessageBox box{QMessageBox::Warning, "Site", "It could not be saved.", QMessageBox::Ok};
  within(box, [&] { EXPECT_EQ(pressTheCorner(), 1U); });
}

TEST_F(StopAllBesideDialogues, ActsBesideADialogueForFiles) {
  QFileDialog files{&window};
  files.setOption(QFileDialog::DontUseNativeDialog);
  within(files, [&] { EXPECT_EQ(pressTheCorner(), 1U); });
  EXPECT_EQ(pressTheCorner(), 1U);
}

TEST_F(StopAllBesideDialogues, ActsBesideAWizard) {
  QWizard wizard{&window};
  wizard.addPage(new QWizardPage);
  within(wizard, [&] { EXPECT_EQ(pressTheCorner(), 1U); });
}

TEST_F(StopAllBesideDialogues, ActsBesideTheDialogueOfADialogueAndTheOneBeneathAfterIt) {
  QDialog lower{&window};
  within(lower, [&] {
    QMessageBox upper{QMessageBox::Question, "Site", "Sure?", QMessageBox::Ok, &lower};
    within(upper, [&] { EXPECT_EQ(pressTheCorner(), 1U); });
    EXPECT_TRUE(QTest::qWaitFor([&] { return standsInFor(lower); }));
    EXPECT_EQ(pressTheCorner(), 1U);
  });
  EXPECT_EQ(pressTheCorner(), 1U);
}

TEST_F(StopAllBesideDialogues, ActsAtOnceWhileAListOfTheDialogueHangsOpen) {
  QDialog dialogue{&window};
  auto* combo = new QComboBox{&dialogue};
  combo->addItems({"one", "two"});
  within(dialogue, [&] {
    combo->showPopup();
    ASSERT_NE(QApplication::activePopupWidget(), nullptr);
    pressTheCorner();
    EXPECT_TRUE(QTest::qWaitFor([&] { return ordered() == 1U; })) << "the press closes the list, and counts";
  });
}

TEST_F(StopAllBesideDialogues, ActsAtOnceWhileAMenuHangsOpen) {
  QAction* site = window.menuBar()->actions().front();
  QTest::mouseClick(window.menuBar(), Qt::LeftButton, {}, window.menuBar()->actionGeometry(site).center());
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
  pressTheCorner();
  EXPECT_TRUE(QTest::qWaitFor([&] { return ordered() == 1U; }));
}

TEST_F(StopAllBesideDialogues, GoesWhereTheWindowGoesAndAwayWithIt) {
  QDialog dialogue{&window};
  within(dialogue, [&] {
    const auto* there = dialogue.findChild<StopAllButton*>("stopAllStandIn");
    window.resize(420, 300);
    window.move(window.pos() + QPoint{40, 60});
    EXPECT_TRUE(QTest::qWaitFor([&] {
      return there->geometry() == QRect{button->mapToGlobal(QPoint{}), button->size()};
    }));
    EXPECT_EQ(pressTheCorner(), 1U);
    window.hide();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !standsInFor(dialogue); }));
  });
}

}  // namespace
}  // namespace tessera::ui
