// The locating view in the whole window, over the simulated world that tells the truth to it alone.
#include <QDockWidget>
#include <QLabel>

#include "app/desktop/desktop_fixture.h"
#include "supervisor/locating_view.h"
#include "ui/connect/look.h"
#include "ui/locating/locating_panel.h"

namespace tessera::desktop {
namespace {

class LocatingInWindow : public DesktopTest {};

TEST_F(LocatingInWindow, showsHowADrivingVehicleIsLocatedAndHowWrongThatIs) {
  openWindow(false);
  ASSERT_NO_FATAL_FAILURE(startDemo());
  EXPECT_TRUE(find<QDockWidget>("locatingDock")->isHidden());
  EXPECT_EQ(window->session().latest()->watched, nullptr) << "nobody looks";
  press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
  auto* panel = find<ui::LocatingPanel>("locatingPanel");
  ASSERT_TRUE(until([&] { return panel->isVisible(); }));
  ASSERT_TRUE(until([&] { return window->session().latest()->watched != nullptr; }));
  pressWhenOffered("runAction", Qt::Key_F5);
  const auto watched = [&] { return window->session().latest()->watched; };
  ASSERT_TRUE(until([&] { return watched() && watched()->aim && panel->record().reads().size() >= 5; }))
      << vehicle().waits.english();
  EXPECT_EQ(watched()->guesses.size(), supervisor::LocatingView::kGuesses);
  EXPECT_FALSE(panel->overlay().empty());
  ASSERT_TRUE(until([&] { return panel->record().errors().count >= 20; })) << "the world tells where it truly is";
  const auto errors = panel->record().errors();
  EXPECT_GT(errors.mean, Metres{0.0005});
  EXPECT_LT(errors.mean, Metres{0.05});
  EXPECT_GE(errors.p95, errors.mean);
  EXPECT_TRUE(until([&] { return find<QLabel>("locatingError")->text().contains("NEES"); }));
  for (const char* language : {"en", "zh_CN"}) {
    window->setLanguage(QString::fromLatin1(language));
    for (const char* row : {"locatingFit", "locatingError", "locatingContradicted"})
      EXPECT_TRUE(until([&] {
        const auto* label = find<QLabel>(row);
        return label->visibleRegion().boundingRect() == label->rect();
      })) << row
          << " is to be seen without scrolling, in " << language;
    window->canvas().centreOn(vehicle().pose.position);
    for (int i = 0; i < 4; ++i) window->canvas().zoomIn();
    window->canvas().finishDrawing();
    ui::look::take(*window, QStringLiteral("locating-window-") + QString::fromLatin1(language));
    window->canvas().fit();
  }
  find<QDockWidget>("locatingDock")->close();
  EXPECT_TRUE(until([&] { return watched() == nullptr; })) << "what nobody looks at is not told";
  EXPECT_TRUE(panel->overlay().empty());
}

}  // namespace
}  // namespace tessera::desktop
