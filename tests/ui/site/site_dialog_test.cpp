// The properties of a site, by mouse and keys: taken over as one step, refused with a sentence, nothing lost.
#include "ui/site/site_dialog.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QTableView>
#include <QTest>

#include "floor/new_floor.h"

namespace tessera::ui {
namespace {

class SiteProperties : public testing::Test {
protected:
  void SetUp() override {
    floor::Site site = floor::layNewFloor({"Hall", floor::usualTileTypes()[0], 2, 1, true}).value();
    site.northToY = fromDegrees(-35.123);
    site.looseTags = {{floor::TagUid::parse("04A1B2C3").value(), {Metres{1.0}, Metres{2.0}}}};
    document.replace(floor::SiteMap::build(std::move(site)).value(), {});
    dialog = std::make_unique<SiteDialog>(document);
    dialog->show();
    dialog->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(dialog.get()));
  }
  template <class T>
  T* find(const char* name) {
    T* found = dialog->findChild<T*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void type(QWidget* field, const QString& text) {
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
  }
  void press(QDialogButtonBox::StandardButton which) {
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(which), Qt::LeftButton);
  }
  // Types into a cell of the table of loose tags, as after a double click.
  void typeIntoCell(int row, int column, const QString& text) {
    auto* table = find<QTableView>("looseTags");
    const auto editor = [table] {
      return table->viewport()->findChild<QWidget*>(QString{}, Qt::FindDirectChildrenOnly);
    };
    if (editor() == nullptr) {
      table->setCurrentIndex(table->model()->index(row, column));
      table->setFocus();
      QTest::keyClick(table, Qt::Key_F2);
    }
    ASSERT_NE(editor(), nullptr);
    ASSERT_EQ(table->currentIndex(), table->model()->index(row, column));
    type(editor(), text);
    QTest::keyClick(editor(), Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return editor() == nullptr; }));
  }

  SiteDocument document;
  std::unique_ptr<SiteDialog> dialog;
};

TEST_F(SiteProperties, AreTakenOverAsOneStep) {
  const floor::Site before = document.site();
  type(find<QLineEdit>("siteName"), "Hall 2");
  type(find<QDoubleSpinBox>("northToY"), "12.5");
  find<QSpinBox>("radioChannel")->setFocus();
  QTest::keyClick(find<QSpinBox>("radioChannel"), Qt::Key_Up);
  find<QComboBox>("airRate")->setFocus();
  QTest::keyClick(find<QComboBox>("airRate"), Qt::Key_Home);
  press(QDialogButtonBox::Ok);
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_EQ(document.site().name, "Hall 2");
  EXPECT_NEAR(degrees(document.site().northToY), 12.5, 1e-9);
  EXPECT_EQ(document.site().radio.channel, before.radio.channel + 1);
  EXPECT_EQ(document.site().radio.airRate, 300);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
}

TEST_F(SiteProperties, AreNoStepWhereNothingIsOtherwise) {
  press(QDialogButtonBox::Ok);
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_NEAR(degrees(document.site().northToY), -35.123, 1e-9) << "more digits than are shown";
}

TEST_F(SiteProperties, AreLeftAloneByCancelling) {
  const floor::Site before = document.site();
  type(find<QLineEdit>("siteName"), "Hall 2");
  press(QDialogButtonBox::Cancel);
  EXPECT_EQ(document.site(), before);
}

TEST_F(SiteProperties, KeepTheNameWhereNoneIsGiven) {
  type(find<QLineEdit>("siteName"), " ");
  press(QDialogButtonBox::Ok);
  EXPECT_EQ(document.site().name, "Hall");
}

TEST_F(SiteProperties, HoldTagsThatBelongToNoTile) {
  find<QTabWidget>("siteTabs")->setCurrentIndex(1);
  QTest::mouseClick(find<QPushButton>("addLooseTag"), Qt::LeftButton);
  typeIntoCell(1, LooseTagModel::Uid, "04 d1 e2 f3");
  typeIntoCell(1, LooseTagModel::X, "1.25");
  typeIntoCell(0, LooseTagModel::Y, "0.5");
  press(QDialogButtonBox::Ok);
  const std::vector<floor::LooseTag> wanted{{floor::TagUid::parse("04A1B2C3").value(), {Metres{1.0}, Metres{0.5}}},
                                            {floor::TagUid::parse("04D1E2F3").value(), {Metres{1.25}, Metres{2.0}}}};
  EXPECT_EQ(document.site().looseTags, wanted);
}

TEST_F(SiteProperties, LetATagBeTakenAway) {
  find<QTabWidget>("siteTabs")->setCurrentIndex(1);
  find<QTableView>("looseTags")->setCurrentIndex(find<QTableView>("looseTags")->model()->index(0, 0));
  QTest::mouseClick(find<QPushButton>("removeLooseTag"), Qt::LeftButton);
  EXPECT_FALSE(find<QPushButton>("removeLooseTag")->isEnabled()) << "none is left";
  press(QDialogButtonBox::Ok);
  EXPECT_TRUE(document.site().looseTags.empty());
}

TEST_F(SiteProperties, RefuseWhatIsNoUid) {
  find<QTabWidget>("siteTabs")->setCurrentIndex(1);
  typeIntoCell(0, LooseTagModel::Uid, "xyz");
  EXPECT_TRUE(find<QLabel>("looseTagRefusal")->text().contains("xyz"))
      << find<QLabel>("looseTagRefusal")->text().toStdString();
  press(QDialogButtonBox::Ok);
  EXPECT_EQ(document.site().looseTags.front().uid.text(), "04A1B2C3");
}

TEST_F(SiteProperties, StayOpenWithASentenceWhereAUidIsTakenAlready) {
  const std::string taken = document.site().tiles.front().uids.front().text();
  find<QTabWidget>("siteTabs")->setCurrentIndex(1);
  typeIntoCell(0, LooseTagModel::Uid, QString::fromStdString(taken));
  press(QDialogButtonBox::Ok);
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_TRUE(find<QLabel>("siteRefusal")->text().contains(QString::fromStdString(taken)));
  EXPECT_EQ(document.undoStack().count(), 0);
}

}  // namespace
}  // namespace tessera::ui
