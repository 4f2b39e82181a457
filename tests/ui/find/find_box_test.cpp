// The line to type into, by keyboard.
#include "ui/find/find_box.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QTest>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

class Finding : public testing::Test {
protected:
  void SetUp() override {
    document.replace(tiledMap(5, 4), {});
    over.resize(700, 500);
    over.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&over));
    box.open();
    ASSERT_TRUE(QTest::qWaitFor([&] { return text().hasFocus(); }));
  }
  QLineEdit& text() { return *box.findChild<QLineEdit*>("findText"); }
  QListWidget& list() { return *box.findChild<QListWidget*>("findList"); }

  SiteDocument document;
  QWidget over;
  FindBox box{document, &over};
};

TEST_F(Finding, goesToWhatIsChosenByEnter) {
  QSignalSpy chosen{&box, &FindBox::chosen};
  QTest::keyClicks(&text(), "T1");
  ASSERT_GT(list().count(), 1);
  QTest::keyClick(&text(), Qt::Key_Down);
  EXPECT_EQ(list().currentRow(), 1);
  QTest::keyClick(&text(), Qt::Key_Up);
  QTest::keyClick(&text(), Qt::Key_Return);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_TRUE(chosen[0][0].value<SiteBox>().contains({Metres{0.9}, Metres{0.3}}));
  EXPECT_FALSE(box.isVisible());
}

TEST_F(Finding, goesToWhatIsClicked) {
  QSignalSpy chosen{&box, &FindBox::chosen};
  QTest::keyClicks(&text(), "T1");
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(1)).center());
  EXPECT_EQ(chosen.count(), 1);
}

TEST_F(Finding, saysWhenNothingIsCalledSoAndIsLeftByEscape) {
  QSignalSpy left{&box, &FindBox::left};
  QTest::keyClicks(&text(), "nowhere");
  EXPECT_TRUE(box.findChild<QWidget*>("findNone")->isVisible());
  EXPECT_FALSE(list().isVisible());
  QTest::keyClick(&text(), Qt::Key_Return);
  EXPECT_TRUE(box.isVisible());
  QTest::keyClick(&text(), Qt::Key_Escape);
  EXPECT_FALSE(box.isVisible());
  EXPECT_EQ(left.count(), 1);
}

TEST_F(Finding, staysWithinASmallWindow) {
  over.resize(260, 200);
  QTest::keyClicks(&text(), "T");
  EXPECT_TRUE(QTest::qWaitFor([&] { return over.rect().contains(box.geometry()); }))
      << box.geometry().width() << " " << box.geometry().height();
}

}  // namespace
}  // namespace tessera::ui
