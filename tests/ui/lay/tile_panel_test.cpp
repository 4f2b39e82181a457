// The panel beside the floor: what is laid next, and the chosen tile by number.
#include "ui/lay/tile_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "laying_board.h"

namespace tessera::ui {
namespace {

class TilesByNumber : public LayingBoard {
protected:
  void SetUp() override {
    LayingBoard::SetUp();
    panel.resize(320, 600);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  template <class T>
  T* find(const char* name) {
    T* found = panel.findChild<T*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void choose(const char* serial) {
    tool.setMode(LayTool::Mode::Choose);
    tool.choose({serial});
  }
  static void type(QWidget* field, const QString& text) {
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }

  TilePanel panel{document, tool};
};

TEST_F(TilesByNumber, SaysWhatToDoWhileThereIsNoType) {
  open({});
  QSignalSpy asked{&panel, &TilePanel::typesRequested};
  auto* button = find<QPushButton>("makeFirstType");
  ASSERT_TRUE(button->isVisible());
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(asked.count(), 1);
  open(floor::layNewFloor({"Hall", floor::usualTileTypes()[0], 2, 2, false}).value());
  EXPECT_FALSE(button->isVisible());
}

TEST_F(TilesByNumber, ShowsTheNextSerialAndTakesAnotherRule) {
  EXPECT_EQ(find<QLabel>("nextSerial")->text(), "T-0001");
  fill(2, 1);
  EXPECT_EQ(find<QLabel>("nextSerial")->text(), "T-0003");
  type(find<QLineEdit>("serialPrefix"), "Hall/");
  find<QSpinBox>("serialDigits")->setValue(2);
  find<QSpinBox>("serialNumber")->setValue(40);
  EXPECT_EQ(find<QLabel>("nextSerial")->text(), "Hall/40");
  click(1.5, 0.3);
  EXPECT_EQ(site().tiles.back().serial, "Hall/40");
  EXPECT_EQ(find<QLabel>("nextSerial")->text(), "Hall/41");
}

TEST_F(TilesByNumber, ShowsTheChosenTileAndHowManyOfItsTagsAreRegistered) {
  fill(2, 2);
  ASSERT_TRUE(document.edit("register", [](floor::Site& s) {
    s.tiles[3].uids = {floor::TagUid::parse("04AABBCC").value(), {}, floor::TagUid::parse("04AABBCD").value()};
  }));
  choose("T-0004");
  EXPECT_TRUE(find<QWidget>("tileDetails")->isVisible());
  EXPECT_EQ(find<QLineEdit>("tileSerial")->text(), "T-0004");
  EXPECT_NEAR(find<QDoubleSpinBox>("tileX")->value(), 60.0, 1e-9);
  EXPECT_NEAR(find<QDoubleSpinBox>("tileY")->value(), 60.0, 1e-9);
  EXPECT_EQ(find<QLabel>("tileTags")->text(), "2 of 8 registered");
  tool.chooseAll();
  EXPECT_FALSE(find<QWidget>("tileDetails")->isVisible());
  EXPECT_TRUE(find<QLabel>("chosenTiles")->text().startsWith("4 tile"))
      << find<QLabel>("chosenTiles")->text().toStdString();
}

TEST_F(TilesByNumber, RenamesTheChosenTileAndRefusesATakenNumber) {
  fill(2, 1);
  choose("T-0001");
  type(find<QLineEdit>("tileSerial"), "door");
  EXPECT_EQ(site().tiles[0].serial, "door");
  EXPECT_EQ(site().placements[0].serial, "door");
  EXPECT_EQ(tool.chosen(), TileSet{"door"});
  QSignalSpy refused{&tool, &LayTool::refused};
  type(find<QLineEdit>("tileSerial"), "T-0002");
  EXPECT_GE(refused.count(), 1);
  EXPECT_EQ(find<QLineEdit>("tileSerial")->text(), "door");
  document.undoStack().undo();
  EXPECT_EQ(site().tiles[0].serial, "T-0001");
}

TEST_F(TilesByNumber, PlacesTheChosenTileByNumberAsOneStep) {
  fill(2, 1);
  choose("T-0002");
  const int before = steps();
  find<QDoubleSpinBox>("tileX")->setValue(130.5);
  find<QDoubleSpinBox>("tileY")->setValue(12.25);
  expectAt("T-0002", 1.305, 0.1225);
  find<QComboBox>("tileTurns")->setCurrentIndex(3);
  expectAt("T-0002", 1.305, 0.1225);
  EXPECT_EQ(turnsOf("T-0002"), 3);
  EXPECT_EQ(steps(), before + 1);
}

TEST_F(TilesByNumber, PutsTheOldPlaceBackWhereATileLiesAlready) {
  fill(2, 1);
  choose("T-0002");
  find<QDoubleSpinBox>("tileX")->setValue(10.0);
  EXPECT_NEAR(find<QDoubleSpinBox>("tileX")->value(), 60.0, 1e-9);
  expectAt("T-0002", 0.6, 0.0);
}

TEST_F(TilesByNumber, ChangesBetweenLayingAndChoosing) {
  QSignalSpy wanted{&panel, &TilePanel::toolRequested};
  find<QAction>("chooseTilesMode")->trigger();
  EXPECT_EQ(tool.mode(), LayTool::Mode::Choose);
  EXPECT_EQ(wanted.count(), 1);
  key(Qt::Key_L);
  EXPECT_TRUE(find<QAction>("layTilesMode")->isChecked());
}

TEST_F(TilesByNumber, LaysTheTypeThatIsChosenInTheList) {
  ASSERT_TRUE(document.edit("add", [](floor::Site& s) { s.tileTypes.push_back(floor::usualTileTypes()[6]); }));
  find<QComboBox>("layType")->setCurrentIndex(1);
  EXPECT_EQ(tool.brush(), floor::usualTileTypes()[6].name);
}

}  // namespace
}  // namespace tessera::ui
