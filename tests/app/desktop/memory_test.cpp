// What the window still knows after it was closed, or died.
#include <QDockWidget>
#include <QFile>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/keeper.h"
#include "app/tessera/site_files.h"
#include "app/tessera/site_lock.h"
#include "store/site_store.h"

namespace tessera::desktop {
namespace {

class Memory : public DesktopTest {
protected:
  void openDemoFloor() {
    const auto demo = SiteFiles::demoPath();
    ASSERT_TRUE(demo) << demo.error().sentence;
    ASSERT_TRUE(window->files().open(*demo));
  }
};

TEST_F(Memory, bringsBackTheSiteThePanelsAndTheLanguage) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  window->resize(798, 733);
  find<QDockWidget>("routesDock")->close();
  trigger("language_zh_CN");
  trigger("appearance_dark");
  const QString path = window->document().path();
  ASSERT_TRUE(closeWindow());

  window = std::make_unique<MainWindow>();
  window->restore();
  window->show();
  window->reopen();
  EXPECT_EQ(window->document().path(), path);
  EXPECT_EQ(window->size(), QSize(798, 733));
  EXPECT_TRUE(find<QDockWidget>("routesDock")->isHidden());
  EXPECT_FALSE(find<QDockWidget>("runDock")->isHidden());
  EXPECT_TRUE(find<QAction>("language_zh_CN")->isChecked());
  EXPECT_TRUE(find<QAction>("appearance_dark")->isChecked());
}

TEST_F(Memory, takesUpWhatWasNotSavedWhenTheProgramDied) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  const auto drawn = window->document().site();
  const QString path = window->document().path();
  ASSERT_TRUE(until([&] { return window->keeper().unsaved(path) != nullptr; }));
  killWindow();

  answerQuestion("recoverQuestion", "Take them up");
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_EQ(window->document().site(), drawn);
  EXPECT_TRUE(window->isWindowModified()) << "its file does not have them yet";
  window->document().undoStack().undo();
  EXPECT_NE(window->document().site(), drawn) << "the file's own contents are one step back";
}

TEST_F(Memory, tellsThatAnotherCopyOfTheProgramHasTheSiteOpen) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  const auto demo = SiteFiles::demoPath();
  ASSERT_TRUE(demo);
  SiteLock other;
  other.take(store::keyOfFile(demo->toStdString()));
  answerQuestion("sharedQuestion", "Do not open it");
  EXPECT_FALSE(window->files().open(*demo));
  answerQuestion("sharedQuestion", "Open it here as well");
  EXPECT_TRUE(window->files().open(*demo));
  other.take("another site");
  killWindow();
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_TRUE(window->files().open(*demo)) << "nobody has it any more";
}

class NewSite : public Memory {
protected:
  /// Made and given a route, then the program dies.
  void makeAndDie() {
    openWindow(false);
    inDialogue(QStringLiteral("newSiteDialog"), [](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
    QTest::mouseClick(find("newButton"), Qt::LeftButton);
    ASSERT_TRUE(window->canvas().isVisible());
    drawRoute({{0.3, 0.3}, {0.3, 1.5}});
    drawn = window->document().site();
    ASSERT_EQ(drawn.routes.size(), 1U);
    EXPECT_TRUE(window->document().path().isEmpty());
    const auto kept = [this] {
      const auto database = store::Database::open(Keeper::databasePath().toStdString());
      if (!database) return false;
      const auto list = store::SiteStore{**database}.list();
      return list && !list->empty() && list->front().differsFromFile;
    };
    ASSERT_TRUE(until(kept));
    killWindow();
  }
  floor::Site drawn;
};

TEST_F(NewSite, isOfferedAgainThoughItWasInNoFileWhenTheProgramDied) {
  ASSERT_NO_FATAL_FAILURE(makeAndDie());
  answerQuestion("homelessQuestion", "Open it");
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_EQ(window->document().site(), drawn);
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_TRUE(window->document().path().isEmpty());
  answerQuestion("saveQuestion", "Discard");
  ASSERT_TRUE(closeWindow());
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_TRUE(find("demoButton")->isVisible()) << "nobody is asked again about what was given up";
}

TEST_F(NewSite, isNotOfferedWhileAnotherCopyOfTheProgramHasItOpen) {
  ASSERT_NO_FATAL_FAILURE(makeAndDie());
  SiteLock other;
  {
    const auto database = store::Database::open(Keeper::databasePath().toStdString());
    ASSERT_TRUE(database);
    other.take(store::SiteStore{**database}.list().value().front().key);
  }
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_TRUE(find("demoButton")->isVisible()) << "nobody was asked";
  other.take("another site");
  EXPECT_EQ(window->keeper().homeless().size(), 1U);
}

TEST_F(NewSite, isForgottenWhenThatIsChosen) {
  ASSERT_NO_FATAL_FAILURE(makeAndDie());
  answerQuestion("homelessQuestion", "Forget it");
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_TRUE(find("demoButton")->isVisible());
  ASSERT_TRUE(closeWindow());
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_TRUE(find("demoButton")->isVisible());
}

class EndWithoutQuestions : public Memory {
protected:
  /// As a polite kill does, as soon as a dialogue of this name is open.
  void endWithin(const QString& name) {
    inDialogue(name, [this](QDialog&) { window->endUnasked(); });
  }
};

TEST_F(EndWithoutQuestions, answersTheQuestionThatIsOpenByNothing) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  const auto drawn = window->document().site();
  endWithin("saveQuestion");
  EXPECT_TRUE(window->close()) << "the question was open within close()";
  EXPECT_FALSE(window->isVisible());
  window.reset();
  answerQuestion("recoverQuestion", "Take them up");
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_EQ(window->document().site(), drawn);
}

TEST_F(EndWithoutQuestions, leavesWhatAnEarlierRunKeptForTheNext) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  const auto drawn = window->document().site();
  ASSERT_TRUE(until([&] { return window->keeper().unsaved(window->document().path()) != nullptr; }));
  killWindow();
  endWithin("recoverQuestion");
  openWindow();
  EXPECT_FALSE(window->isVisible());
  window.reset();
  answerQuestion("recoverQuestion", "Take them up");
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_EQ(window->document().site(), drawn);
}

TEST_F(Memory, forgetsWhatWasGivenUp) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  const auto before = window->document().site();
  drawRoute({{0.3, 0.3}, {0.3, 1.5}});
  answerQuestion("saveQuestion", "Discard");
  ASSERT_TRUE(closeWindow());
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_EQ(window->document().site(), before);
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(Memory, keepsTheOpenSiteInTheDatabase) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  ASSERT_NO_FATAL_FAILURE(openDemoFloor());
  const auto site = window->document().site();
  const auto key = store::keyOfFile(window->document().path().toStdString());
  ASSERT_TRUE(closeWindow());
  const auto database = store::Database::open(Keeper::databasePath().toStdString());
  ASSERT_TRUE(database);
  const auto kept = store::SiteStore{**database}.load(key);
  ASSERT_TRUE(kept && *kept);
  EXPECT_EQ(**kept, site);
}

TEST_F(Memory, tellsOfAFileThatIsNoSiteAndGoesOn) {
  ASSERT_NO_FATAL_FAILURE(openWindow());
  const QString path = home.filePath("broken.tessera.json");
  QFile file{path};
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"tessera-site\", ");
  file.close();
  answerQuestion("trouble", "OK");
  EXPECT_FALSE(window->files().open(path));
  EXPECT_TRUE(find("demoButton")->isVisible()) << "the start page still stands";
}

}  // namespace
}  // namespace tessera::desktop
