// Tile types: made from the usual sizes, changed by number and by click, and what that does to tiles in use.
#include "ui/lay/tile_types_dialog.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "floor/new_floor.h"
#include "floor/tile_pattern.h"
#include "floor/type_change.h"
#include "ui/lay/type_picture.h"

namespace tessera::ui {
namespace {

class TileTypes : public testing::Test {
protected:
  void open(floor::Site site) {
    document.replace(floor::SiteMap::build(std::move(site)).value(), {});
    dialog = std::make_unique<TileTypesDialog>(document);
    dialog->setQuestion([this](const QString&) {
      ++asked;
      return agrees;
    });
    dialog->QWidget::show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog.get()));
  }
  void openUsed() { open(floor::layNewFloor({"Hall", floor::usualTileTypes()[0], 3, 2, true}).value()); }
  template <class T>
  T* find(const char* name) {
    T* found = dialog->findChild<T*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void addUsual(int n) { find<QMenu>("addTypeMenu")->actions().at(n)->trigger(); }
  void clickPlace(int column, int row) {
    auto* picture = find<TypePicture>("typePicture");
    QTest::mouseClick(picture, Qt::LeftButton, {}, picture->pixelOf(column, row).toPoint());
  }
  QPushButton* ok() { return dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok); }
  QString said(const char* label) { return find<QLabel>(label)->text(); }
  [[nodiscard]] const floor::TileType& type(std::size_t n) const { return document.site().tileTypes.at(n); }

  SiteDocument document;
  std::unique_ptr<TileTypesDialog> dialog;
  int asked = 0;
  bool agrees = true;
};

TEST_F(TileTypes, AddsAUsualSizeToAnEmptySiteAsOneStep) {
  open({});
  EXPECT_TRUE(find<QLabel>("noTypes")->isVisible());
  addUsual(0);
  EXPECT_FALSE(find<QLabel>("noTypes")->isVisible());
  addUsual(6);
  QTest::mouseClick(ok(), Qt::LeftButton);
  EXPECT_FALSE(dialog->isVisible());
  ASSERT_EQ(document.site().tileTypes.size(), 2U);
  EXPECT_EQ(type(0), floor::usualTileTypes()[0]);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_TRUE(document.site().tileTypes.empty());
}

TEST_F(TileTypes, MakesAPatternOfItsOwnByClicks) {
  open({});
  addUsual(0);
  clickPlace(1, 0);
  clickPlace(0, 0);
  EXPECT_EQ(find<QComboBox>("typePattern")->currentIndex(), 2);
  auto* picture = find<TypePicture>("typePicture");
  picture->setFocus();
  QTest::keyClick(picture, Qt::Key_Up);
  QTest::keyClick(picture, Qt::Key_Space);  // column 0, row 1: no tag so far
  dialog->accept();
  EXPECT_EQ(type(0).pattern, floor::Pattern::Custom);
  EXPECT_FALSE(floor::hasTag(type(0), 0, 0));
  EXPECT_TRUE(floor::hasTag(type(0), 1, 0));
  EXPECT_TRUE(floor::hasTag(type(0), 0, 1));
  EXPECT_TRUE(floor::hasTag(type(0), 2, 0));
}

TEST_F(TileTypes, FitsThePlacesToTheSizeWhileTheyFitted) {
  open({});
  addUsual(1);
  find<QDoubleSpinBox>("typeWidth")->setValue(90.0);
  EXPECT_EQ(find<QSpinBox>("typeColumns")->value(), 6);
  find<QDoubleSpinBox>("typeMarginX")->setValue(5.0);
  find<QDoubleSpinBox>("typeWidth")->setValue(92.0);
  EXPECT_EQ(find<QSpinBox>("typeColumns")->value(), 6) << "places set by hand stay";
  EXPECT_NEAR(find<QDoubleSpinBox>("typeMarginX")->value(), 5.0, 1e-9);
  dialog->accept();
  EXPECT_NEAR(type(0).width.value(), 0.92, 1e-12);
}

TEST_F(TileTypes, NamesThePitchOverTheSeams) {
  open({});
  addUsual(1);
  EXPECT_TRUE(said("seamSentence").contains("evenly")) << said("seamSentence").toStdString();
  find<QDoubleSpinBox>("typeMarginX")->setValue(5.0);
  find<QDoubleSpinBox>("typeWidth")->setValue(55.0);
  EXPECT_TRUE(said("seamSentence").contains("10 cm over the seam instead of 15 cm"))
      << said("seamSentence").toStdString();
  EXPECT_TRUE(said("seamSentence").contains("tags meet")) << said("seamSentence").toStdString();
  find<QDoubleSpinBox>("typeWidth")->setValue(70.0);
  EXPECT_TRUE(said("seamSentence").contains("wider")) << said("seamSentence").toStdString();
}

TEST_F(TileTypes, StartsWithTagOrGap) {
  open({});
  addUsual(0);
  find<QCheckBox>("typeGap")->click();
  dialog->accept();
  EXPECT_TRUE(type(0).startsWithGap);
  EXPECT_FALSE(floor::hasTag(type(0), 0, 0));
}

TEST_F(TileTypes, RefusesWhatNoSiteFileHolds) {
  open({});
  addUsual(0);
  find<QSpinBox>("typeColumns")->setValue(9);
  EXPECT_FALSE(ok()->isEnabled());
  EXPECT_FALSE(said("typeFault").isEmpty());
  find<QPushButton>("typeFit")->click();
  EXPECT_TRUE(ok()->isEnabled());
  addUsual(0);
  auto* name = find<QLineEdit>("typeName");
  name->selectAll();
  QTest::keyClicks(name, QString::fromStdString(floor::usualTileTypes()[0].name));
  EXPECT_FALSE(ok()->isEnabled()) << "two types of one name";
}

TEST_F(TileTypes, RefusesToDeleteATypeInUse) {
  openUsed();
  find<QAction>("deleteType")->trigger();
  EXPECT_EQ(find<QListWidget>("typeList")->count(), 1);
  EXPECT_TRUE(said("typeFault").contains("6 tile")) << said("typeFault").toStdString();
  addUsual(6);
  find<QAction>("deleteType")->trigger();
  EXPECT_EQ(find<QListWidget>("typeList")->count(), 1);
}

TEST_F(TileTypes, SaysWhatBecomesOfUidsAndAsksBeforeItDropsAny) {
  openUsed();
  const floor::Site before = document.site();
  find<QComboBox>("typePattern")->setCurrentIndex(0);
  EXPECT_TRUE(said("useSentence").contains("All their numbers stay")) << said("useSentence").toStdString();
  find<QComboBox>("typePattern")->setCurrentIndex(1);
  clickPlace(0, 0);
  EXPECT_TRUE(said("useSentence").contains("6 of their numbers would be dropped")) << said("useSentence").toStdString();
  agrees = false;
  dialog->accept();
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_EQ(document.site(), before);
  agrees = true;
  dialog->accept();
  EXPECT_EQ(floor::useOf(document.site(), before.tileTypes[0].name).registered, 42U);
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
}

TEST_F(TileTypes, ExchangesTheNamesOfTwoTypesInUse) {
  floor::Site site = floor::layNewFloor({"Hall", floor::usualTileTypes()[0], 2, 1, false}).value();
  site.tileTypes.push_back(floor::usualTileTypes()[1]);
  site.tiles[1].type = site.tileTypes[1].name;
  open(site);
  auto* name = find<QLineEdit>("typeName");
  const auto rename = [&](int row, const std::string& to) {
    find<QListWidget>("typeList")->setCurrentRow(row);
    name->selectAll();
    QTest::keyClicks(name, QString::fromStdString(to));
  };
  rename(0, "x");
  rename(1, site.tileTypes[0].name);
  rename(0, site.tileTypes[1].name);
  dialog->accept();
  EXPECT_EQ(document.site().tiles[0].type, site.tileTypes[1].name);
  EXPECT_EQ(document.site().tiles[1].type, site.tileTypes[0].name);
  EXPECT_EQ(type(0).pattern, floor::Pattern::OneInTwo);
  EXPECT_EQ(type(0).name, site.tileTypes[1].name);
}

TEST_F(TileTypes, ChangesNothingWhenNothingWasChangedOrItIsLeft) {
  openUsed();
  dialog->accept();
  EXPECT_EQ(document.undoStack().count(), 0);
  openUsed();
  addUsual(3);
  dialog->reject();
  EXPECT_EQ(document.site().tileTypes.size(), 1U);
}

}  // namespace
}  // namespace tessera::ui
