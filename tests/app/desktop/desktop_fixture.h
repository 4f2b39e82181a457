// The whole window over a real simulated world, with settings and data of its own: what an operator's day is tried
// with.
#pragma once

#include <gtest/gtest.h>

#include <QDeadlineTimer>
#include <QDialog>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <memory>

#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {

class DesktopTest : public ::testing::Test {
protected:
  DesktopTest();
  ~DesktopTest() override;

  /// A new window with what the last one left behind. Shown and ready for clicks.
  void openWindow(bool reopen = true);
  /// As a person closes it. False: it stayed.
  bool closeWindow();
  /// As if the power went: nothing is saved, nobody is asked.
  void killWindow();

  /// Events are handled meanwhile. False: patience ran out.
  static bool until(const std::function<bool()>& condition);
  /// Presses a button of the question with this object name as soon as it is there; call before what asks.
  static void answerQuestion(const QString& name, const QString& buttonText);

  /// Does this with the next dialogue of this name, from within its own loop; call before what opens it. What is left
  /// open of it is closed afterwards.
  void inDialogue(const QString& name, const std::function<void(QDialog&)>& work);
  /// Answers the next dialogue for a file with this path; call before what opens it.
  void nameTheFile(const QString& path);
  /// Opens the demo floor from the start page and waits until its vehicle has answered and knows where it is.
  void startDemo();
  [[nodiscard]] supervisor::VehicleView vehicle() const;
  /// Clicks the floor here; the last click of a route is a double one.
  void clickFloor(double x, double y, bool twice = false);
  [[nodiscard]] QPoint pixelOf(double x, double y) const;
  /// Draws a route with the mouse. Ends with the route tool still chosen.
  void drawRoute(const std::vector<std::pair<double, double>>& vertices);
  template <class T = QWidget>
  T* find(const char* name) const {
    T* found = window->findChild<T*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void trigger(const char* action) const { find<QAction>(action)->trigger(); }
  /// Presses the key of an action once that is enabled: panels follow the vehicles a moment later.
  void pressWhenOffered(const char* action, Qt::Key key);
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const { QTest::keyClick(window.get(), key, modifiers); }

  QTemporaryDir home;
  std::unique_ptr<MainWindow> window;
};

}  // namespace tessera::desktop
