// The panel of revisions under mouse and keys.
#include "ui/history/revision_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

using floor::Site;
using floor::SiteMap;

class RevisionsUnderTest : public testing::Test {
protected:
  void SetUp() override {
    document.replace(tiledMap(6, 5), "/sites/hall.tessera.json");
    panel.resize(1100, 300);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  static RevisionLine line(qint64 id, const QString& what, std::optional<sitediff::Tally> changed = {}) {
    return {id, QDateTime{QDate{2026, 11, 20}, QTime{8, 0, static_cast<int>(id)}}, "Ada", what, false, changed};
  }
  static std::shared_ptr<const SiteMap> older() {
    Site site = tiledSite(6, 5);
    site.placements.pop_back();
    site.routes[0].name = "old";
    return SiteMap::build(site).value();
  }
  void list() { panel.setRevisions({line(2, "Draw a route", sitediff::Tally{.routes = 1}), line(1, "New site")}); }
  // As a person does; the answer comes as from the storage.
  void choose(int row, std::shared_ptr<const SiteMap> map) {
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(table().model()->index(row, 0)).center());
    ASSERT_EQ(wanted.count(), 1);
    const qint64 id = wanted.takeFirst()[0].toLongLong();
    panel.setRevision(id, std::move(map));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !head().startsWith("Comparing"); }, 60'000));
  }
  QTreeView& table() { return *panel.findChild<QTreeView*>("revisionTable"); }
  QListWidget& differences() { return *panel.findChild<QListWidget*>("revisionDifferences"); }
  QString head() { return panel.findChild<QLabel*>("revisionHead")->text(); }
  QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
  QAction& action(const char* name) { return *panel.findChild<QAction*>(QString::fromLatin1(name)); }
  void press(const char* name) {
    for (auto* button : panel.findChildren<QToolButton*>())
      if (button->defaultAction() == &action(name)) return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << name;
  }

  SiteDocument document;
  RevisionPanel panel{document};
  QSignalSpy wanted{&panel, &RevisionPanel::revisionWanted};
  QSignalSpy told{&panel, &RevisionPanel::told};
};

TEST_F(RevisionsUnderTest, saysWhatToDoWhileThereAreNone) {
  auto& empty = *panel.findChild<QLabel*>("noRevisions");
  EXPECT_TRUE(empty.isVisible());
  EXPECT_TRUE(empty.text().contains("Ctrl+S")) << empty.text().toStdString();
  document.replace(tiledMap(2, 2), {});
  EXPECT_TRUE(empty.text().contains("in no file yet")) << empty.text().toStdString();
  EXPECT_FALSE(action("goBackToRevision").isEnabled());
}

TEST_F(RevisionsUnderTest, listsWhenWhoWhatAndHowMuch) {
  list();
  EXPECT_TRUE(table().isVisible());
  EXPECT_TRUE(cell(0, 0).endsWith("08:00:02")) << cell(0, 0).toStdString();
  EXPECT_EQ(cell(0, 1), "Ada");
  EXPECT_EQ(cell(0, 2), "Draw a route");
  EXPECT_EQ(cell(0, 3), tallyText({.routes = 1}));
  EXPECT_EQ(cell(1, 3), "the first that is kept");
  RevisionLine found = line(3, {});
  found.found = true;
  found.who.clear();
  panel.setRevisions({found, line(1, "New site")});
  EXPECT_EQ(cell(0, 1), "unknown");
  EXPECT_EQ(cell(0, 2), "the file as it was opened");
  EXPECT_EQ(cell(0, 3), "not known");
}

TEST_F(RevisionsUnderTest, showsWhatHasChangedSinceTheChosenOne) {
  list();
  QSignalSpy places{&panel, &RevisionPanel::placeWanted};
  EXPECT_TRUE(panel.marks().empty());
  choose(1, older());
  // A tile came, one route went and one came.
  ASSERT_EQ(differences().count(), 3) << head().toStdString();
  EXPECT_TRUE(head().contains("3")) << head().toStdString();
  const ChangeMarks marks = panel.marks();
  EXPECT_TRUE(marks.title.contains("08:00:01")) << marks.title.toStdString();
  EXPECT_EQ(marks.signs.size(), 3U);
  EXPECT_EQ(marks.chosen, std::nullopt);
  QTest::mouseClick(differences().viewport(), Qt::LeftButton, {},
                    differences().visualItemRect(differences().item(0)).center());
  ASSERT_EQ(places.count(), 1);
  const auto place = places[0][0].value<SiteBox>();
  EXPECT_NEAR(place.centre().x.value(), 5.5 * 0.6, 1e-9);
  EXPECT_NEAR(place.centre().y.value(), 4.5 * 0.6, 1e-9);
  EXPECT_EQ(panel.marks().chosen, 0U);
  EXPECT_EQ(panel.marks().signs[0].sentence, differences().item(0)->text());
}

TEST_F(RevisionsUnderTest, isWalkedByKeysAndLeftByEscape) {
  list();
  table().setFocus();
  QTest::keyClick(&table(), Qt::Key_Home);
  QTest::keyClick(&table(), Qt::Key_Down);
  EXPECT_EQ(wanted.last()[0].toLongLong(), 1);
  panel.setRevision(2, tiledMap(1, 1));  // an answer that was overtaken
  panel.setRevision(1, older());
  ASSERT_TRUE(QTest::qWaitFor([&] { return differences().count() == 3; }, 60'000)) << head().toStdString();
  QTest::keyClick(&table(), Qt::Key_Escape);
  EXPECT_TRUE(panel.marks().empty());
  EXPECT_EQ(differences().count(), 0);
  EXPECT_FALSE(action("goBackToRevision").isEnabled());
}

TEST_F(RevisionsUnderTest, followsTheSiteWhileItIsEdited) {
  list();
  choose(1, older());
  ASSERT_TRUE(document.edit("Take up", [](Site& s) { s.placements.pop_back(); }));
  EXPECT_TRUE(QTest::qWaitFor([&] { return differences().count() == 2; }, 60'000)) << head().toStdString();
  document.undoStack().undo();
  EXPECT_TRUE(QTest::qWaitFor([&] { return differences().count() == 3; }, 60'000));
}

TEST_F(RevisionsUnderTest, goesBackInOneStepThatUndoTakesBack) {
  list();
  const Site before = document.site();
  choose(1, older());
  press("goBackToRevision");
  EXPECT_EQ(document.site(), older()->site());
  ASSERT_EQ(document.undoStack().count(), 1);
  EXPECT_TRUE(document.undoStack().undoText().startsWith("Go back to "));
  ASSERT_EQ(told.count(), 1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return head().startsWith("The site is the same"); }, 60'000))
      << head().toStdString();
  press("goBackToRevision");
  EXPECT_EQ(document.undoStack().count(), 1) << "there is nothing more to go back to";
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
}

TEST_F(RevisionsUnderTest, leavesVehiclesTheKeysThatTheyHaveNow) {
  list();
  choose(1, older());
  ASSERT_TRUE(document.edit("New key", [](Site& s) { s.vehicles[0].key.fill(9); }));
  const auto key = document.site().vehicles[0].key;
  press("goBackToRevision");
  EXPECT_EQ(document.site().routes[0].name, "old");
  EXPECT_EQ(document.site().vehicles[0].key, key) << "with an older one the vehicle would obey nobody";
  EXPECT_TRUE(told.last()[0].toString().contains("keys")) << told.last()[0].toString().toStdString();
}

TEST_F(RevisionsUnderTest, saysWhyARevisionCannotBeRead) {
  list();
  QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(table().model()->index(0, 0)).center());
  panel.setRevisionTrouble(1, "of another one");
  EXPECT_TRUE(head().startsWith("Comparing"));
  panel.setRevisionTrouble(2, "This revision is damaged.");
  EXPECT_EQ(head(), "This revision is damaged.");
  EXPECT_FALSE(action("exportRevision").isEnabled());
}

TEST_F(RevisionsUnderTest, keepsTheChosenOneWhenTheListGrowsAndLeavesOneThatIsGone) {
  list();
  choose(1, older());
  panel.setRevisions({line(3, "More"), line(2, "Draw a route"), line(1, "New site")});
  EXPECT_EQ(table().currentIndex().row(), 2);
  EXPECT_EQ(differences().count(), 3);
  EXPECT_TRUE(wanted.empty()) << "it is not read again";
  panel.setRevisions({line(3, "More")});
  EXPECT_TRUE(panel.marks().empty());
}

TEST_F(RevisionsUnderTest, forgetsThemWhenAnotherSiteIsOpened) {
  list();
  choose(1, older());
  ASSERT_FALSE(panel.marks().empty());
  document.replace(tiledMap(2, 2), "/sites/other.tessera.json");
  EXPECT_TRUE(panel.marks().empty());
  EXPECT_EQ(table().model()->rowCount(), 0);
  panel.setRevision(1, older());  // an answer that comes late
  EXPECT_FALSE(QTest::qWaitFor([&] { return !panel.marks().empty(); }, 300));
}

TEST_F(RevisionsUnderTest, handsTheRevisionOutForAFile) {
  list();
  QSignalSpy exported{&panel, &RevisionPanel::exportWanted};
  const auto map = older();
  choose(1, map);
  press("exportRevision");
  ASSERT_EQ(exported.count(), 1);
  EXPECT_EQ(exported[0][0].value<std::shared_ptr<const SiteMap>>(), map);
}

TEST_F(RevisionsUnderTest, takesTheNameThatIsTyped) {
  QSignalSpy named{&panel, &RevisionPanel::authorChanged};
  panel.setAuthor({}, "root");
  auto& name = *panel.findChild<QLineEdit*>("revisionAuthor");
  QTest::mouseClick(&name, Qt::LeftButton);
  QTest::keyClicks(&name, "Grace ");
  QTest::keyClick(&name, Qt::Key_Return);
  ASSERT_GE(named.count(), 1);
  EXPECT_EQ(named.last()[0].toString(), "Grace");
}

}  // namespace
}  // namespace tessera::ui
