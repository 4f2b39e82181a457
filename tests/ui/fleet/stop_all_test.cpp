#include "ui/fleet/stop_all.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/fleet/fake_fleet.h"

namespace tessera::ui {
namespace {

using supervisor::StopAll;

struct StopAllWindow {
  StopAllWindow() {
    window.setCentralWidget(button);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
  }
  FakeFleet link;
  QMainWindow window;
  StopAllButton* button = new StopAllButton{link};
  StopAllKey key{link};
};

TEST(StopAll, ButtonActsWhenPressedNotWhenLetGo) {
  StopAllWindow w;
  QTest::mousePress(w.button, Qt::LeftButton);
  EXPECT_EQ(w.link.all<StopAll>().size(), 1U);
  QTest::mouseRelease(w.button, Qt::LeftButton, {}, QPoint{-50, -50});
  EXPECT_EQ(w.link.all<StopAll>().size(), 1U);
}

TEST(StopAll, KeyActsOnceAndNotAgainWhileHeld) {
  StopAllWindow w;
  QTest::keyPress(w.window.windowHandle(), Qt::Key_F12);
  EXPECT_EQ(w.link.all<StopAll>().size(), 1U);
  QKeyEvent held{QEvent::KeyPress, Qt::Key_F12, Qt::NoModifier, {}, true};
  QApplication::sendEvent(w.window.windowHandle(), &held);
  EXPECT_EQ(w.link.all<StopAll>().size(), 1U);
  QTest::keyRelease(w.window.windowHandle(), Qt::Key_F12);
  QTest::keyClick(w.window.windowHandle(), Qt::Key_F12, Qt::ShiftModifier);
  EXPECT_EQ(w.link.all<StopAll>().size(), 2U);
}

TEST(StopAll, KeyWorksInAModalDialogueWhileOneTypes) {
  StopAllWindow w;
  QDialog dialog{&w.window};
  auto* layout = new QVBoxLayout{&dialog};
  auto* edit = new QLineEdit{&dialog};
  layout->addWidget(edit);
  std::size_t inDialog = 0;
  QTimer::singleShot(0, &dialog, [&] {
    EXPECT_TRUE(QTest::qWaitForWindowActive(&dialog));
    edit->setFocus();
    EXPECT_EQ(QApplication::activeModalWidget(), &dialog);
    QTest::keyClick(dialog.windowHandle(), Qt::Key_F12);
    inDialog = w.link.all<StopAll>().size();
    dialog.reject();
  });
  dialog.exec();
  EXPECT_EQ(inDialog, 1U);
}

TEST(StopAll, KeyWorksWhileAMenuIsOpen) {
  StopAllWindow w;
  QMenu menu{&w.window};
  menu.addAction("Something");
  menu.popup(w.window.mapToGlobal(QPoint{5, 5}));
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&menu));
  QTest::keyClick(&menu, Qt::Key_F12);
  EXPECT_EQ(w.link.all<StopAll>().size(), 1U);
}

TEST(StopAll, NoShortcutTakesItsKeyAway) {
  StopAllWindow w;
  QAction thief{&w.window};
  thief.setShortcut(Qt::Key_F12);
  w.window.addAction(&thief);
  QSignalSpy stolen{&thief, &QAction::triggered};
  QTest::keyClick(w.window.windowHandle(), Qt::Key_F12);
  EXPECT_EQ(w.link.all<StopAll>().size(), 1U);
  EXPECT_EQ(stolen.size(), 0);
}

TEST(StopAll, TellsWhenNobodyTookIt) {
  StopAllWindow w;
  w.link.takesOrders = false;
  QSignalSpy ordered{w.button, &StopAllButton::ordered};
  QTest::mousePress(w.button, Qt::LeftButton);
  ASSERT_EQ(ordered.size(), 1);
  EXPECT_FALSE(ordered.front().front().toBool());
}

TEST(StopAll, ButtonIsRedWithWhiteLettersInLightAndDark) {
  StopAllWindow w;
  for (const QColor& window : {QColor{Qt::white}, QColor{30, 30, 30}}) {
    w.button->setPalette(QPalette{window});
    const QImage picture = w.button->grab().toImage();
    const QColor face = picture.pixelColor(picture.width() / 2, 6);
    EXPECT_GT(face.red(), 180);
    EXPECT_LT(face.green(), 80);
    EXPECT_LT(face.blue(), 80);
  }
}

}  // namespace
}  // namespace tessera::ui
