// Pictures of what belongs to the site: the drive-over check with its marks, tile types, an import, finding, the steps.
#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>

#include "app/desktop/pictures.h"
#include "app/tessera/exchange_files.h"
#include "app/tessera/site_files.h"
#include "ui/tilecheck/tile_watch.h"

namespace tessera::desktop {
namespace {

TEST_F(Pictures, showTheDriveOverCheckWithItsMarksWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_NO_FATAL_FAILURE(startDemo());
  // Two tiles at each other's places.
  ASSERT_TRUE(window->document().edit(QStringLiteral("mistake"), [](floor::Site& site) {
    std::swap(site.placements.at(3).origin, site.placements.at(6).origin);
  }));
  trigger("tileCheck");
  ASSERT_TRUE(until([&] { return find("runTileCheck")->isVisible(); }));
  QTest::mouseClick(find("runTileCheck"), Qt::LeftButton);
  pressWhenOffered("runAction", Qt::Key_F5);
  auto* list = find<QListWidget>("suspectList");
  ASSERT_TRUE(until([&] { return list->count() > 0 && window->tileWatch().progress().confirmed > 0; }));
  list->setCurrentRow(0);
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("tilecheck-marks"), dress);
  }
}

TEST_F(Pictures, showTileTypesAnImportAndTheFindBoxWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  const QString table = home.filePath("loose.csv");
  QFile file{table};
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("x_m,y_m,uid\n0.31,0.32,04A1B2C3D4E5F6\n1.31,0.82,04A1B2C3D4E5F7\n");
  file.close();
  for (const Dress& dress : kDresses) {
    wear(dress);
    inDialogue(QStringLiteral("tileTypesDialog"), [this, &dress](QDialog& dialog) {
      take(dialog, QStringLiteral("tile-types"), dress);
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    trigger("tileTypes");
    inDialogue(QStringLiteral("changesDialog"), [this, &dress](QDialog& dialog) {
      take(dialog, QStringLiteral("import"), dress);
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    EXPECT_FALSE(window->findChild<ExchangeFiles*>()->importFrom(table));
    trigger("find");
    auto* words = find<QLineEdit>("findText");
    ASSERT_TRUE(until([&] { return words->isVisible(); }));
    words->clear();
    QTest::keyClicks(words, "T-000");
    take(*window, QStringLiteral("find"), dress);
    QTest::keyClick(words, Qt::Key_Escape);
  }
}

TEST_F(Pictures, showChosenTilesAndTheMapsPictureWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  for (const Dress& dress : kDresses) {
    wear(dress);
    trigger("layTiles");
    window->canvas().setFocus();
    QTest::keyClick(&window->canvas(), Qt::Key_C);
    const Point corner = window->document().site().placements.front().origin;
    const QPoint from = pixelOf(corner.x.value() - 0.2, corner.y.value() - 0.2);
    const QPoint to = pixelOf(corner.x.value() + 1.0, corner.y.value() + 1.0);
    QTest::mousePress(&window->canvas(), Qt::LeftButton, {}, from);
    for (int n = 1; n <= 10; ++n) {
      const QPoint now = from + (to - from) * n / 10;
      QMouseEvent move{QEvent::MouseMove, now, window->canvas().mapToGlobal(now), Qt::NoButton, Qt::LeftButton, {}};
      QApplication::sendEvent(&window->canvas(), &move);
    }
    QTest::mouseRelease(&window->canvas(), Qt::LeftButton, {}, to);
    take(*window, QStringLiteral("chosen-tiles"), dress);
    trigger("browse");
    inDialogue(QStringLiteral("mapPictureDialog"), [this, &dress](QDialog& dialog) {
      take(dialog, QStringLiteral("map-picture"), dress);
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    trigger("mapPicture");
  }
}

TEST_F(Pictures, showTheStepsAndTheMenuOfAMarkWhole) {
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().openDemo());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  ASSERT_TRUE(window->document().edit("Move a vertex", [](floor::Site& site) {
    site.routes.back().vertices.front() = {Metres{0.1}, Metres{-0.1}};
  }));
  find<QDockWidget>("stepsDock")->show();
  find<QDockWidget>("stepsDock")->raise();
  ASSERT_TRUE(until([&] { return !window->canvas().marked().empty(); })) << "the route tool is in hand";
  for (const Dress& dress : kDresses) {
    wear(dress);
    take(*window, QStringLiteral("steps"), dress);
    const ui::FloorMark mark = window->canvas().marked().front();
    QTest::mouseClick(&window->canvas(), Qt::RightButton, {}, window->canvas().signOf(mark).toPoint());
    auto* menu = window->findChild<QMenu*>("faultMenu");
    ASSERT_NE(menu, nullptr);
    take(*menu, QStringLiteral("mark-menu"), dress);
    menu->close();
    ASSERT_TRUE(until([&] { return window->findChild<QMenu*>("faultMenu") == nullptr; }));
  }
}

}  // namespace
}  // namespace tessera::desktop
