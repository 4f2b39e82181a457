// A file that contradicts itself is opened in the window, and mended there by mouse; no vehicle is led by it before.
#include <QAbstractItemView>
#include <QDockWidget>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/keeper.h"
#include "app/tessera/site_files.h"
#include "floor/site_json.h"

namespace tessera::desktop {
namespace {

class Mending : public DesktopTest {
protected:
  void SetUp() override {
    floor::Site site = *floor::loadSite(TESSERA_SITES "/paper.tessera.json");
    ASSERT_GE(site.tiles.size(), 3U);
    serial = site.tiles[0].serial;
    doubled = site.tiles[0].uids[0];
    site.tiles[1].uids[0] = doubled;
    site.tiles.push_back({serial, site.tiles[0].type, {}});
    ASSERT_TRUE(floor::saveSite(site, path().toStdString()));
    broken = site;
    openWindow(false);
  }
  [[nodiscard]] QString path() const { return home.filePath("broken.tessera.json"); }
  void openBroken() {
    inDialogue(QStringLiteral("trouble"), [this](QDialog& box) {
      told = dynamic_cast<QMessageBox&>(box).text();
      QTest::mouseClick(dynamic_cast<QMessageBox&>(box).button(QMessageBox::Ok), Qt::LeftButton);
    });
    ASSERT_TRUE(window->files().open(path()));
    backToTheWindow();
    ASSERT_TRUE(until([&] { return rows() > 0 && !find<QToolButton>("faultSummary")->text().contains("Checking"); }));
  }
  /// Offscreen nobody makes it the active one again when a dialogue is gone.
  void backToTheWindow() {
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
  [[nodiscard]] QAbstractItemView& list() const { return *find<QAbstractItemView>("faultList"); }
  [[nodiscard]] int rows() const { return list().model()->rowCount(); }
  [[nodiscard]] int rowWith(const QString& words) const {
    for (int n = 0; n < rows(); ++n)
      if (list().model()->index(n, 0).data().toString().contains(words)) return n;
    return -1;
  }
  void clickFault(const QString& words) {
    ASSERT_TRUE(until([&] { return rowWith(words) >= 0; })) << words.toStdString();
    const QModelIndex row = list().model()->index(rowWith(words), 0);
    list().scrollTo(row);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(row).center());
  }
  void clickMend() {
    auto* bar = find("faultPanel")->findChild<QToolBar*>();
    QTest::mouseClick(bar->widgetForAction(find<QAction>("mendFault")), Qt::LeftButton);
  }
  [[nodiscard]] bool contradicts() const { return !window->document().map()->contradictions().empty(); }

  floor::Site broken;
  std::string serial;
  floor::TagUid doubled;
  QString told;
};

TEST_F(Mending, opensAFileThatContradictsItselfListsAndMendsItsFaultsAndSavesItSound) {
  ASSERT_NO_FATAL_FAILURE(openBroken());
  EXPECT_TRUE(told.contains(QString::fromStdString("Two tiles have the serial number \"" + serial + "\".")))
      << told.toStdString();
  EXPECT_TRUE(told.contains("opened so that it can be mended")) << told.toStdString();
  EXPECT_EQ(window->document().site(), broken) << "nothing is mended unasked";
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(find("faultPanel")->isVisible());
  EXPECT_FALSE(window->canvas().marked().empty());
  EXPECT_FALSE(window->document().map()->find(doubled)) << "it is at neither place";

  ASSERT_NO_FATAL_FAILURE(clickFault("is registered twice"));
  clickMend();
  EXPECT_TRUE(window->document().site().tiles[1].uids[0].empty());
  EXPECT_TRUE(window->document().map()->contradictions().size() == 1U);
  ASSERT_NO_FATAL_FAILURE(clickFault("Two tiles have the serial number"));
  clickMend();
  EXPECT_FALSE(contradicts());
  EXPECT_EQ(window->document().site().tiles.back().serial, serial + "-2");
  const floor::Site mended = window->document().site();
  press(Qt::Key_Z, Qt::ControlModifier);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), broken);
  EXPECT_TRUE(contradicts());
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(window->document().site(), mended);
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_FALSE(window->isWindowModified());
  ASSERT_TRUE(closeWindow());

  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  ASSERT_TRUE(window->files().open(path()));
  EXPECT_EQ(window->document().site(), mended);
  EXPECT_FALSE(contradicts());
  ASSERT_TRUE(until([&] { return !find<QToolButton>("faultSummary")->text().contains("Checking"); }));
  EXPECT_EQ(rowWith("twice"), -1);
  EXPECT_EQ(rowWith("Two tiles"), -1);
}

TEST_F(Mending, superviseNoVehicleBeforeItIsMended) {
  ASSERT_NO_FATAL_FAILURE(openBroken());
  QString refused;
  QObject::connect(&window->session(), &FleetSession::failed, window.get(), [&](const QString& s) { refused = s; });
  window->connectTo({});
  EXPECT_TRUE(refused.contains("Mend it first")) << refused.toStdString();
  EXPECT_EQ(window->session().state(), FleetSession::State::Off);
  ASSERT_NO_FATAL_FAILURE(clickFault("is registered twice"));
  clickMend();
  ASSERT_NO_FATAL_FAILURE(clickFault("Two tiles have the serial number"));
  clickMend();
  refused.clear();
  window->connectTo({});
  ASSERT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Connected; })) << refused.toStdString();
  // Back to the contradiction while vehicles are supervised: they stop and are let go.
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(refused.contains("Mend it first")) << refused.toStdString();
  EXPECT_TRUE(until([&] { return window->session().state() == FleetSession::State::Off; }));
}

TEST_F(Mending, goesOnWithWhatWasHalfMendedWhenTheProgramDied) {
  ASSERT_NO_FATAL_FAILURE(openBroken());
  ASSERT_NO_FATAL_FAILURE(clickFault("is registered twice"));
  clickMend();
  const floor::Site half = window->document().site();
  ASSERT_TRUE(until([&] {
    const auto kept = window->keeper().unsaved(path());
    return kept && kept->site() == half;
  }));
  killWindow();
  openWindow(false);
  answerQuestion("recoverQuestion", "Take them up");
  inDialogue(QStringLiteral("trouble"), [](QDialog& box) {
    QTest::mouseClick(dynamic_cast<QMessageBox&>(box).button(QMessageBox::Ok), Qt::LeftButton);
  });
  ASSERT_TRUE(window->files().open(path()));
  backToTheWindow();
  EXPECT_EQ(window->document().site(), half);
  EXPECT_TRUE(contradicts());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), broken);
}

TEST_F(Mending, refusesAFixThatWouldContradictItselfElsewhere) {
  ASSERT_NO_FATAL_FAILURE(openBroken());
  const auto done =
      window->document().edit("Lay", [&](floor::Site& site) { site.placements.push_back(site.placements.front()); });
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().sentence.english().find("is laid twice"), std::string::npos) << done.error().sentence;
  EXPECT_EQ(window->document().site(), broken);
}

}  // namespace
}  // namespace tessera::desktop
