// The start page by mouse and by key.
#include "ui/connect/start_page.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

namespace tessera::ui {
namespace {

QPushButton* startButton(QWidget& page, const char* name) {
  auto* found = page.findChild<QPushButton*>(QLatin1String{name});
  if (found == nullptr) throw std::runtime_error{std::string{"no button "} + name};
  return found;
}

std::vector<RecentSite> twoRecentSites() {
  const QDateTime when{QDate{2026, 3, 1}, QTime{12, 0}};
  return {{"Hall 3", "/sites/hall3.tessera.json", when, false}, {"Old hall", "/sites/old.tessera.json", when, true}};
}

class StartPageTest : public testing::Test {
protected:
  void SetUp() override {
    page.resize(800, 640);
    page.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  }
  StartPage page;
};

TEST_F(StartPageTest, EachLargeButtonAsksForWhatItSays) {
  QSignalSpy demo{&page, &StartPage::demoRequested};
  QSignalSpy fresh{&page, &StartPage::newRequested};
  QSignalSpy open{&page, &StartPage::openRequested};
  QTest::mouseClick(startButton(page, "demoButton"), Qt::LeftButton);
  QTest::mouseClick(startButton(page, "newButton"), Qt::LeftButton);
  QTest::mouseClick(startButton(page, "openButton"), Qt::LeftButton);
  EXPECT_EQ(demo.count(), 1);
  EXPECT_EQ(fresh.count(), 1);
  EXPECT_EQ(open.count(), 1);
}

TEST_F(StartPageTest, TheButtonsAreReachedByMnemonicAndTab) {
  QSignalSpy fresh{&page, &StartPage::newRequested};
  QTest::keyClick(&page, Qt::Key_N, Qt::AltModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return fresh.count() == 1; }));
  startButton(page, "demoButton")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), startButton(page, "newButton"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_EQ(fresh.count(), 2);
}

TEST_F(StartPageTest, AnEmptyListSaysWhatWillStandThere) {
  EXPECT_FALSE(page.findChild<QTreeWidget*>("recentList")->isVisible());
  EXPECT_FALSE(startButton(page, "forgetRecent")->isVisible());
}

TEST_F(StartPageTest, ARecentSiteOpensByEnterAndByDoubleClick) {
  page.setRecent(twoRecentSites());
  QSignalSpy recent{&page, &StartPage::recentRequested};
  auto* list = page.findChild<QTreeWidget*>("recentList");
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Return);
  ASSERT_EQ(recent.count(), 1);
  EXPECT_EQ(recent.at(0).at(0).toString(), "/sites/hall3.tessera.json");
  QTest::mouseClick(startButton(page, "openRecent"), Qt::LeftButton);
  EXPECT_EQ(recent.count(), 2);
}

TEST_F(StartPageTest, AMissingSiteCannotBeOpenedButForgotten) {
  page.setRecent(twoRecentSites());
  QSignalSpy recent{&page, &StartPage::recentRequested};
  QSignalSpy forgotten{&page, &StartPage::forgetRequested};
  auto* list = page.findChild<QTreeWidget*>("recentList");
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_FALSE(startButton(page, "openRecent")->isEnabled());
  EXPECT_NE(list->topLevelItem(0)->foreground(0), list->topLevelItem(1)->foreground(0));
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_EQ(recent.count(), 0);
  QTest::keyClick(list, Qt::Key_Delete);
  ASSERT_EQ(forgotten.count(), 1);
  EXPECT_EQ(forgotten.at(0).at(0).toString(), "/sites/old.tessera.json");
}

TEST_F(StartPageTest, AShorterListKeepsAChoice) {
  page.setRecent(twoRecentSites());
  page.setRecent({twoRecentSites().front()});
  EXPECT_TRUE(startButton(page, "openRecent")->isEnabled());
  page.setRecent({});
  EXPECT_FALSE(startButton(page, "openRecent")->isVisible());
}

}  // namespace
}  // namespace tessera::ui
