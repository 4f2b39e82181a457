// The drive-over check by mouse and keys, with a fleet of values that drives over a floor laid otherwise than the site.
#include "ui/tilecheck/tile_check_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "canvas_site.h"
#include "floor/laid_tile.h"
#include "tests/ui/connect/look.h"
#include "tests/ui/fleet/fake_fleet.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::ui {
namespace {

class DriveOver : public testing::Test {
protected:
  void SetUp() override {
    document.replace(tiledMap(4, 3), {});
    panel.resize(340, 460);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  /// Drives over each tag of these tiles as they really lie; reads come a little after the picture of their instant.
  void drive(const floor::Site& real, const std::vector<std::string>& serials) {
    const auto map = floor::SiteMap::build(real).value();
    const auto before = changes.count();
    auto snapshot = fakeSnapshot(1, time_);
    auto& vehicle = snapshot.vehicles.front();
    const auto& setup = real.vehicles.front();
    for (const floor::Tile& tile : real.tiles) {
      if (std::find(serials.begin(), serials.end(), tile.serial) == serials.end()) continue;
      for (const floor::TagUid& uid : tile.uids) {
        vehicle.pose = {*map->find(uid) - setup.readers.front(), {}};
        // Put down at each tag anew: it cannot drive so fast.
        for (const bool located : {false, true, true}) {
          vehicle.located = located;
          snapshot.time = Seconds{time_ += 0.1};
          fleet.show(snapshot);
        }
        vehicle.recentReads = {{uid, 0, snapshot.time, std::nullopt}};
        snapshot.time = Seconds{time_ += 0.1};
        fleet.show(snapshot);
      }
    }
    // All reads were taken in one go: the check that follows has them all.
    if (!watch.isRunning() || serials.empty()) return;
    EXPECT_TRUE(QTest::qWaitFor([&] { return changes.count() > before; }));
  }
  static floor::Site swapped(floor::Site site, std::size_t a, std::size_t b) {
    std::swap(site.placements[a].origin, site.placements[b].origin);
    std::swap(site.placements[a].quarterTurns, site.placements[b].quarterTurns);
    return site;
  }
  template <class T>
  T* find(const char* name) {
    return panel.findChild<T*>(QString::fromLatin1(name));
  }
  void click(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
  [[nodiscard]] QString hint() { return find<QLabel>("tileCheckHint")->text(); }

  SiteDocument document;
  FakeFleet fleet;
  TileWatch watch{document, fleet};
  QSignalSpy changes{&watch, &TileWatch::changed};
  TileCheckPanel panel{watch, fleet};

private:
  double time_ = 10.0;
};

TEST_F(DriveOver, saysWhatToDoAtEachPoint) {
  EXPECT_TRUE(hint().startsWith("Press Start, then drive a vehicle along the rows of tiles."));
  click("runTileCheck");
  EXPECT_EQ(hint(), "Connect to the vehicles: none is supervised yet.");
  fleet.show(fakeSnapshot(1));
  EXPECT_EQ(hint(), "Drive a vehicle along the rows of tiles.");
  drive(document.site(), {"T0", "T1"});
  EXPECT_EQ(hint(), "So far every tile lies where the site says. Drive on along the rows.");
  std::vector<std::string> all;
  for (const auto& tile : document.site().tiles) all.push_back(tile.serial);
  drive(document.site(), all);
  EXPECT_EQ(hint(), "Every tile lies where the site says.");
  EXPECT_EQ(find<QProgressBar>("tileCheckBar")->value(), 12);
  document.replace(floor::SiteMap::build({}).value(), {});
  EXPECT_TRUE(QTest::qWaitFor([&] { return hint().startsWith("No tiles are laid yet. Lay them with Lay tiles"); }));
  EXPECT_FALSE(find<QPushButton>("runTileCheck")->isEnabled());
}

TEST_F(DriveOver, takesNoReadsBeforeStartAndNoneWhilePaused) {
  drive(document.site(), {});
  fleet.show(fakeSnapshot(1));
  EXPECT_EQ(watch.progress().untouched(), 12);
  click("runTileCheck");
  drive(document.site(), {"T5"});
  EXPECT_EQ(watch.progress().confirmed, 1);
  click("runTileCheck");
  drive(document.site(), {"T6"});
  EXPECT_EQ(watch.progress().confirmed, 1);
  EXPECT_EQ(find<QLabel>("tileCheckCounts")->text(),
            "Confirmed: 1 of 12. Seen: 0. Lies otherwise: 0. Not yet driven over: 11.");
  click("resetTileCheck");
  EXPECT_EQ(watch.progress().confirmed, 0);
}

TEST_F(DriveOver, namesTwoThatWereSwappedAndCorrectsTheSiteInOneStep) {
  const floor::Site before = document.site();
  const floor::Site real = swapped(before, 1, 10);
  click("runTileCheck");
  drive(real, {"T1", "T10", "T4"});
  auto* list = find<QListWidget>("suspectList");
  ASSERT_EQ(list->count(), 1);
  EXPECT_EQ(list->item(0)->text(), "Tiles \"T1\" and \"T10\" lie at each other's places.");
  EXPECT_FALSE(find<QPushButton>("mendSuspect")->isEnabled());
  QSignalSpy wanted{&panel, &TileCheckPanel::placeWanted};
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  EXPECT_EQ(wanted.count(), 1);
  click("mendSuspect");
  EXPECT_EQ(document.site(), real);
  EXPECT_EQ(document.undoStack().undoText(), "Correct how T1, T10 lies");
  EXPECT_EQ(list->count(), 0);
  EXPECT_EQ(watch.progress().confirmed, 3) << "what was read says so now";
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
  EXPECT_TRUE(QTest::qWaitFor([&] { return list->count() == 1; })) << "and is named again";
}

TEST_F(DriveOver, putsInATagThatWasExchangedAndSaysWhereNothingCanBeDone) {
  const floor::Site before = document.site();
  floor::Site real = before;
  real.tiles[4].uids[3] = floor::TagUid::parse("EE010203").value();
  click("runTileCheck");
  for (int n = 0; n < 3; ++n) drive(real, {"T4", "T5"});
  auto* list = find<QListWidget>("suspectList");
  ASSERT_EQ(list->count(), 1);
  EXPECT_EQ(list->item(0)->text(),
            "Tag EE010203, which no tile has, was read 3 times where tag 4 of tile \"T4\" should be, which was never "
            "read: probably the card was exchanged.");
  QSignalSpy wanted{&panel, &TileCheckPanel::placeWanted};
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  EXPECT_EQ(wanted.count(), 1);
  click("mendSuspect");
  EXPECT_EQ(document.site(), real);
  EXPECT_EQ(document.undoStack().undoText(), "Register tag 4 of tile T4");
  EXPECT_EQ(list->count(), 0);
  document.undoStack().undo();
  EXPECT_TRUE(QTest::qWaitFor([&] { return list->count() == 1; }));
  real = before;  // and a tag where no tile is
  real.tiles.push_back({"far", real.tiles[0].type, {floor::TagUid::parse("EE010204").value()}});
  real.placements.push_back({"far", {Metres{-3.0}, Metres{-3.0}}, 0});
  click("resetTileCheck");
  for (int n = 0; n < 2; ++n) drive(real, {"far"});
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(list->item(0)->text().endsWith("but no tile has it.")) << list->item(0)->text().toStdString();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  EXPECT_FALSE(find<QPushButton>("mendSuspect")->isEnabled());
  EXPECT_TRUE(find<QPushButton>("showSuspect")->isEnabled());
}

TEST_F(DriveOver, refusesToCorrectWhatWasEditedMeanwhile) {
  const floor::Site real = swapped(document.site(), 1, 10);
  click("runTileCheck");
  drive(real, {"T1", "T10"});
  ASSERT_EQ(watch.suspects().size(), 1U);
  const auto suspect = watch.suspects().front();
  ASSERT_TRUE(document.edit("edit", [](floor::Site& site) { site.placements[1].origin.x += Metres{0.01}; }));
  const floor::Site edited = document.site();
  const auto done = watch.mend(suspect);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().sentence, "The site was edited meanwhile: nothing was changed.");
  EXPECT_EQ(document.site(), edited);
}

TEST_F(DriveOver, marksTheTilesOnTheFloorBySignAndColour) {
  FloorCanvas canvas;
  canvas.resize(600, 480);
  canvas.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  canvas.openMap(document.map());
  canvas.finishDrawing();
  const auto colour = [&](double x, double y) {
    return canvas.grab().toImage().pixelColor(canvas.view().toPixel({Metres{x}, Metres{y}}).toPoint());
  };
  const QColor untouched = colour(0.35, 0.12);
  click("runTileCheck");
  drive(swapped(document.site(), 1, 10), {"T0", "T1", "T10"});
  canvas.setTileMarks(watch.marks());
  ASSERT_EQ(canvas.tileMarks().size(), 3U);
  EXPECT_EQ(std::count_if(canvas.tileMarks().begin(), canvas.tileMarks().end(),
                          [](const TileMark& m) { return m.kind == TileMark::Kind::Suspect; }),
            2);
  const QColor confirmed = colour(0.35, 0.12);
  EXPECT_GT(confirmed.green() - confirmed.red(), untouched.green() - untouched.red()) << "T0 is green";
  EXPECT_GT(colour(0.95, 0.12).red(), colour(0.95, 0.12).green()) << "T1 is not";
  EXPECT_EQ(colour(1.55, 0.12), untouched);
  for (const bool dark : {false, true}) {
    look::setDark(dark);
    look::take(canvas, dark ? "tilemarks-dark" : "tilemarks-light");
    look::take(panel, dark ? "tilecheck-dark" : "tilecheck-light");
  }
  look::setDark(false);
}

}  // namespace
}  // namespace tessera::ui
