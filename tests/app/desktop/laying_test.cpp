// Laying tiles in the whole window: the panel comes with the tool, steps are the document's, Esc lays the tool down.
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/site_files.h"

namespace tessera::desktop {
namespace {

class LayingInWindow : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    ASSERT_TRUE(window->files().open(QStringLiteral(TESSERA_SITES "/paper.tessera.json")));
    QApplication::processEvents();
  }
  [[nodiscard]] std::size_t tiles() const { return window->document().site().placements.size(); }
  void drag(double x, double y, double toX, double toY) {
    auto& canvas = window->canvas();
    QTest::mousePress(&canvas, Qt::LeftButton, {}, pixelOf(x, y));
    const QPoint at = pixelOf(toX, toY);
    QMouseEvent move{QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {}};
    QApplication::sendEvent(&canvas, &move);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at);
  }
};

TEST_F(LayingInWindow, showsItsPanelWithTheToolAndNotBefore) {
  auto* dock = find<QDockWidget>("tilesDock");
  EXPECT_TRUE(dock->isHidden());
  press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(find<QAction>("layTiles")->isChecked());
  EXPECT_FALSE(find<QAction>("browse")->isChecked());
  EXPECT_TRUE(until([&] { return find("tilePanel")->isVisible(); }));
  EXPECT_FALSE(find<QLabel>("hintLabel")->text().isEmpty());
  QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  EXPECT_FALSE(find<QAction>("layTiles")->isChecked());
  EXPECT_TRUE(find<QAction>("browse")->isChecked());
}

TEST_F(LayingInWindow, laysTilesUndoesThemToNothingAndRedoesThem) {
  const floor::Site before = window->document().site();
  press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
  QApplication::processEvents();
  const double left = 1e-9 + before.placements.front().origin.x.value();
  drag(left + 0.3, -0.15, left + 1.5, -0.15);
  EXPECT_EQ(tiles(), before.placements.size() + 3);
  EXPECT_TRUE(window->isWindowModified());
  const floor::Site after = window->document().site();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), before);
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(window->document().site(), after);
}

TEST_F(LayingInWindow, makesATileTypeForAnEmptySite) {
  window->document().replace(floor::SiteMap::build({}).value(), {});
  press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
  inDialogue(QStringLiteral("tileTypesDialog"), [](QDialog& dialog) {
    dialog.findChild<QMenu*>("addTypeMenu")->actions().front()->trigger();
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  });
  ASSERT_TRUE(until([&] { return find("makeFirstType")->isVisible(); }));
  QTest::mouseClick(find("makeFirstType"), Qt::LeftButton);
  ASSERT_EQ(window->document().site().tileTypes.size(), 1U);
  EXPECT_FALSE(find("makeFirstType")->isVisible());
  drag(3.3, 3.3, 4.5, 3.3);
  EXPECT_EQ(tiles(), 3U);
}

}  // namespace
}  // namespace tessera::desktop
