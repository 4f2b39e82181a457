// Saving makes revisions; what has changed since one is listed and drawn, and one can go back to it.
#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTreeView>
#include <QUndoStack>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/revision_desk.h"
#include "app/tessera/site_files.h"
#include "app/tessera/step_log.h"
#include "floor/site_json.h"

namespace tessera::desktop {
namespace {

class SavedSites : public DesktopTest {
protected:
  void openDemoFloor() {
    openWindow(false);
    ASSERT_TRUE(window->files().openDemo());
    press(Qt::Key_H, Qt::ControlModifier);
    ASSERT_TRUE(find<QDockWidget>("revisionsDock")->isVisible());
    ASSERT_TRUE(until([&] { return table().model()->rowCount() == 1; })) << "the file as it was opened";
  }
  void saveAndWait() {
    const int before = table().model()->rowCount();
    press(Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(until([&] { return table().model()->rowCount() == before + 1; }));
  }
  /// After a dialogue, as the window's keys are the active window's.
  void saveByKey() {
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    press(Qt::Key_S, Qt::ControlModifier);
  }
  QTreeView& table() { return *find<QTreeView>("revisionTable"); }
  QListWidget& differences() { return *find<QListWidget>("revisionDifferences"); }
  QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
  QString head() { return find<QLabel>("revisionHead")->text(); }
  void choose(int row) {
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(table().model()->index(row, 0)).center());
  }
};

TEST_F(SavedSites, areComparedOnTheFloorAndGoneBackTo) {
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  const floor::Site first = window->document().site();
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  ASSERT_NO_FATAL_FAILURE(saveAndWait());
  drawRoute({{0.6, 0.3}, {0.6, 1.5}});
  ASSERT_TRUE(window->document().edit("Take up a tile", [](floor::Site& s) { s.placements.pop_back(); }));
  ASSERT_NO_FATAL_FAILURE(saveAndWait());
  const floor::Site last = window->document().site();
  EXPECT_EQ(cell(0, 1), systemUser());
  EXPECT_TRUE(cell(0, 2).contains("Take up a tile")) << cell(0, 2).toStdString();
  EXPECT_TRUE(cell(0, 3).contains("1 tile taken up")) << cell(0, 3).toStdString();
  EXPECT_TRUE(cell(0, 3).contains("1 route")) << cell(0, 3).toStdString();
  EXPECT_EQ(cell(2, 2), "the file as it was opened");

  EXPECT_TRUE(window->canvas().changes().empty());
  press(Qt::Key_H, Qt::ControlModifier);
  EXPECT_TRUE(table().hasFocus()) << "the arrow keys walk through the revisions at once";
  choose(1);
  ASSERT_TRUE(until([&] { return differences().count() == 2; })) << head().toStdString();
  EXPECT_EQ(window->canvas().changes().signs.size(), 2U);
  const double scale = window->canvas().view().scale();
  QTest::mouseClick(differences().viewport(), Qt::LeftButton, {},
                    differences().visualItemRect(differences().item(0)).center());
  const Point taken = window->canvas().changes().signs.at(0).place.centre();
  EXPECT_LT(distance(window->canvas().view().centre(), taken), Metres{0.05}) << "a click goes there";
  EXPECT_GE(window->canvas().view().scale(), std::min(scale, 60.0));

  choose(2);
  ASSERT_TRUE(until([&] { return differences().count() == 3; })) << head().toStdString();
  trigger("goBackToRevision");
  EXPECT_EQ(window->document().site(), first);
  EXPECT_TRUE(window->isWindowModified()) << "the file has the newer one until it is saved";
  EXPECT_TRUE(until([&] { return head().startsWith("The site is the same"); })) << head().toStdString();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), last);
  EXPECT_FALSE(window->isWindowModified());

  // Closed, the panel takes its marks off the floor.
  EXPECT_TRUE(until([&] { return !window->canvas().changes().empty(); }));
  find<QDockWidget>("revisionsDock")->close();
  EXPECT_TRUE(window->canvas().changes().empty());
}

TEST_F(SavedSites, areNotOverwrittenUnaskedWhereSomebodyElseChangedThem) {
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  const std::string path = window->document().path().toStdString();
  floor::Site other = window->document().site();
  other.name = "Somebody else's";
  other.placements.pop_back();
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  const floor::Site ours = window->document().site();
  ASSERT_TRUE(floor::saveSite(other, path));
  answerQuestion("changedQuestion", "Cancel");
  ASSERT_NO_FATAL_FAILURE(saveByKey());
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_EQ(floor::loadSite(path).value(), other);

  const QString copy = home.filePath("ours.tessera.json");
  answerQuestion("changedQuestion", "Save under another name…");
  nameTheFile(copy);
  ASSERT_NO_FATAL_FAILURE(saveByKey());
  EXPECT_EQ(floor::loadSite(copy.toStdString()).value(), ours);
  EXPECT_EQ(floor::loadSite(path).value(), other);

  ASSERT_TRUE(floor::saveSite(other, copy.toStdString()));
  ASSERT_TRUE(until([&] { return table().model()->rowCount() == 2; }));
  answerQuestion("changedQuestion", "Overwrite it");
  ASSERT_NO_FATAL_FAILURE(saveByKey());
  EXPECT_EQ(floor::loadSite(copy.toStdString()).value(), ours);
  ASSERT_TRUE(until([&] { return table().model()->rowCount() == 4; }));
  EXPECT_EQ(cell(1, 2), "Saved by somebody else");
  choose(1);
  ASSERT_TRUE(until([&] { return find<QAction>("goBackToRevision")->isEnabled(); }));
  trigger("goBackToRevision");
  EXPECT_EQ(window->document().site(), other);
}

TEST_F(SavedSites, areOverwrittenUnaskedWhereTheirFileWasOnlyTouched) {
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  QFile file{window->document().path()};
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime));
  file.close();
  ASSERT_NO_FATAL_FAILURE(saveAndWait());
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(SavedSites, keepTheirRevisionsOverAnotherStart) {
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  ASSERT_NO_FATAL_FAILURE(saveAndWait());
  const QString path = window->document().path();
  ASSERT_TRUE(closeWindow());

  // Meanwhile somebody else writes to the file.
  auto site = floor::loadSite(path.toStdString()).value();
  site.name = "else";
  ASSERT_TRUE(floor::saveSite(site, path.toStdString()));
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_EQ(window->document().site().name, "else");
  press(Qt::Key_H, Qt::ControlModifier);
  ASSERT_TRUE(until([&] { return table().model()->rowCount() == 3; }));
  EXPECT_EQ(cell(0, 2), "the file as it was opened");
  choose(1);
  ASSERT_TRUE(until([&] { return differences().count() == 1; })) << head().toStdString();
  EXPECT_TRUE(window->canvas().changes().signs.at(0).place.empty()) << "a name lies nowhere on the floor";
}

TEST_F(SavedSites, takeTheirRevisionsAlongToAnotherNameAndPlace) {
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  const QString old = window->document().path();
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  ASSERT_NO_FATAL_FAILURE(saveAndWait());
  drawRoute({{0.6, 0.3}, {0.6, 1.5}});
  const QString other = home.filePath("other.tessera.json");
  nameTheFile(other);
  ASSERT_TRUE(window->files().saveAs());
  ASSERT_TRUE(until([&] { return table().model()->rowCount() == 3; })) << "with what was before the new name";
  ASSERT_TRUE(window->files().open(old));
  EXPECT_TRUE(until([&] { return table().model()->rowCount() == 2; })) << "the old file has its own";

  const QString moved = home.filePath("moved.tessera.json");
  ASSERT_TRUE(QFile::rename(other, moved));
  ASSERT_TRUE(window->files().open(moved));
  EXPECT_TRUE(until([&] { return table().model()->rowCount() == 3; })) << "moved beside the program";
  choose(2);
  EXPECT_TRUE(until([&] { return differences().count() == 2; })) << head().toStdString();
}

TEST_F(SavedSites, giveARevisionAsAFileOfItsOwn) {
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  const floor::Site first = window->document().site();
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  ASSERT_NO_FATAL_FAILURE(saveAndWait());
  choose(1);
  ASSERT_TRUE(until([&] { return find<QAction>("exportRevision")->isEnabled(); }));
  const QString path = home.filePath("then.tessera.json");
  inDialogue("QFileDialog", [&](QDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    ASSERT_NE(name, nullptr);
    name->setText(path);
    QTest::keyClick(name, Qt::Key_Return);
  });
  trigger("exportRevision");
  ASSERT_TRUE(QFile::exists(path));
  EXPECT_EQ(floor::loadSite(path.toStdString()).value(), first);
  EXPECT_NE(window->document().site(), first) << "the open site stays as it is";
}

TEST(StepLog, namesWhatWasDoneSinceTheLastSaving) {
  QUndoStack stack;
  StepLog log{stack};
  const auto push = [&stack](const char* name) { stack.push(new QUndoCommand{QString::fromLatin1(name)}); };
  EXPECT_EQ(log.take(), "");
  push("Lay tiles");
  push("Lay tiles");
  push("Draw a route");
  EXPECT_EQ(log.take(), "Lay tiles (2 times), Draw a route");
  push("Move vertex");
  stack.undo();
  EXPECT_EQ(log.take(), "") << "done and undone it never was";
  stack.undo();
  EXPECT_EQ(log.take(), "Undo: Draw a route");
  stack.undo();
  stack.redo();
  EXPECT_EQ(log.take(), "");
  stack.clear();
  log.forget();
  push("Rename site");
  EXPECT_EQ(log.take(), "Rename site");
}

}  // namespace
}  // namespace tessera::desktop
