// The drive-over check in the whole window: a vehicle of the simulated world drives over a floor on which two tiles lie
// at each other's places, as the site has them.
#include <QDockWidget>
#include <QListWidget>
#include <QPushButton>

#include "app/desktop/desktop_fixture.h"
#include "floor/laid_tile.h"
#include "ui/tilecheck/tile_watch.h"

namespace tessera::desktop {
namespace {

class DriveOverInWindow : public DesktopTest {};

TEST_F(DriveOverInWindow, namesTwoTilesThatLieAtEachOthersPlacesAndCorrectsTheSite) {
  openWindow(false);
  ASSERT_NO_FATAL_FAILURE(startDemo());
  const floor::Site laid = window->document().site();
  // The world goes on with the floor as it was: now the site is the one that is wrong.
  ASSERT_TRUE(window->document().edit(QStringLiteral("mistake"), [](floor::Site& site) {
    std::swap(site.placements.at(3).origin, site.placements.at(6).origin);
  }));
  const floor::Site wrong = window->document().site();
  EXPECT_TRUE(find<QDockWidget>("tileCheckDock")->isHidden());
  press(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(until([&] { return find("runTileCheck")->isVisible(); }));
  QTest::mouseClick(find("runTileCheck"), Qt::LeftButton);
  pressWhenOffered("runAction", Qt::Key_F5);
  auto* list = find<QListWidget>("suspectList");
  ASSERT_TRUE(until([&] { return list->count() == 1; })) << vehicle().waits.english() << vehicle().doing.english();
  EXPECT_EQ(list->item(0)->text(), "Tiles \"T-0004\" and \"T-0007\" lie at each other's places.");
  EXPECT_GE(window->canvas().tileMarks().size(), 2U);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  QTest::mouseClick(find("mendSuspect"), Qt::LeftButton);
  EXPECT_EQ(window->document().site(), laid);
  EXPECT_EQ(list->count(), 0);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), wrong) << "one step";
  EXPECT_TRUE(until([&] { return list->count() == 1; })) << "named again";
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(until([&] { return list->count() == 0; }));
  EXPECT_GE(window->tileWatch().progress().confirmed, 1);
  find<QDockWidget>("tileCheckDock")->close();
  EXPECT_TRUE(window->canvas().tileMarks().empty()) << "the marks go with the panel";
}

TEST_F(DriveOverInWindow, namesATurnedTileOnADriveAndTurnsItInTheSite) {
  openWindow(false);
  ASSERT_NO_FATAL_FAILURE(startDemo());
  const floor::Site laid = window->document().site();
  ASSERT_TRUE(window->document().edit(QStringLiteral("mistake"), [](floor::Site& site) {
    floor::Placement& tile = site.placements.at(3);
    const floor::TileType& type = site.tileTypes.front();
    tile = tilecheck::placedAt(tile.serial, type, floor::boxOf(tile, type).low, 2);
  }));
  ASSERT_NE(window->document().site(), laid);
  press(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(until([&] { return find("runTileCheck")->isVisible(); }));
  QTest::mouseClick(find("runTileCheck"), Qt::LeftButton);
  pressWhenOffered("runAction", Qt::Key_F5);
  auto* list = find<QListWidget>("suspectList");
  ASSERT_TRUE(until([&] { return list->count() == 1; })) << vehicle().waits.english() << vehicle().doing.english();
  EXPECT_EQ(list->item(0)->text(), "Tile \"T-0004\" lies turned by 180° against the site.");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  QTest::mouseClick(find("mendSuspect"), Qt::LeftButton);
  const floor::Placement& mended = window->document().site().placements.at(3);
  EXPECT_EQ(mended.quarterTurns, 0);
  EXPECT_LT(distance(mended.origin, laid.placements.at(3).origin), Metres{1e-6});
  EXPECT_EQ(list->count(), 0);
}

}  // namespace
}  // namespace tessera::desktop
