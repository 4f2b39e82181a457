// The floor's iron in the whole window: learned while a vehicle drives, shown, kept for the next time, forgotten.
#include <QFile>
#include <QHelpEvent>
#include <QMenu>
#include <QMenuBar>
#include <QToolTip>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/keeper.h"
#include "app/tessera/magnetic_desk.h"
#include "app/tessera/site_files.h"
#include "locate/magnetic_map.h"
#include "store/database.h"
#include "store/magnetic_maps.h"
#include "store/site_store.h"
#include "store/transaction.h"
#include "ui/connect/look.h"

namespace tessera::desktop {
namespace {

class IronInWindow : public DesktopTest {
protected:
  void openFloor() {
    const QString path = home.filePath("floor.tessera.json");
    ASSERT_TRUE(QFile::exists(path) || QFile::copy(QStringLiteral(TESSERA_SITES "/paper.tessera.json"), path));
    ASSERT_NO_FATAL_FAILURE(openWindow(false));
    ASSERT_TRUE(window->files().open(path));
  }
  /// One node of the real floor's, kept when the window was closed.
  void leaveIronBehind() {
    ASSERT_NO_FATAL_FAILURE(openFloor());
    locate::MagneticMap some;
    some.learn({1, 1}, 0.1, 0.001);
    window->keeper().keepMagneticMap(window->keeper().key(), false, std::make_shared<locate::MagneticMap>(some));
    ASSERT_TRUE(closeWindow());
  }
  /// While no window is open. Null: nothing.
  [[nodiscard]] std::shared_ptr<const locate::MagneticMap> stored(const char* file, bool simulated) const {
    const auto database = store::Database::open(Keeper::databasePath().toStdString());
    EXPECT_TRUE(database);
    if (!database) return nullptr;
    const auto kept =
        store::MagneticMaps{**database}.load(store::keyOfFile(home.filePath(file).toStdString()), simulated);
    EXPECT_TRUE(kept);
    return kept.value_or(nullptr);
  }
  [[nodiscard]] const locate::MagneticMap& iron() const { return *window->magneticDesk().map(); }
  /// Drives until so much was learned.
  void learn(std::size_t nodes) {
    window->connectTo({});
    ASSERT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Connected && vehicle().located; }));
    ASSERT_TRUE(until([&] { return find<QAction>("runAction")->isEnabled(); }));
    trigger("runAction");
    ASSERT_TRUE(until([&] { return vehicle().task == supervisor::Task::Running; })) << vehicle().waits.english();
    ASSERT_TRUE(until([&] { return iron().nodeCount() >= nodes; }))
        << iron().nodeCount() << " nodes after " << vehicle().progress.value() << " m " << vehicle().waits.english();
  }
  /// With the mouse, as a person finds it.
  void chooseInMenu(QMenu* menu, QAction* action) const {
    menu->popup(window->mapToGlobal(QPoint{}));
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
  }
  [[nodiscard]] QMenu* menuWith(QAction* action) const {
    for (QMenu* menu : window->findChildren<QMenu*>())
      if (menu->actions().contains(action)) return menu;
    return nullptr;
  }
  /// Under the mouse, at the place that is known best.
  [[nodiscard]] QString tip() const {
    Point best;
    double known = 0.0;
    iron().forEach([&](locate::MagneticNode node, const locate::MagneticValue& value) {
      const Point place = locate::MagneticMap::placeOf(node);
      if (value.known() <= known || distance(place, vehicle().pose.position) < Metres{0.4}) return;
      known = value.known();
      best = place;
    });
    // Tags have tips of their own.
    const QPoint at = pixelOf(best.x.value(), best.y.value());
    QHelpEvent asks{QEvent::ToolTip, at, window->canvas().mapToGlobal(at)};
    QApplication::sendEvent(&window->canvas(), &asks);
    return QToolTip::text();
  }
};

TEST_F(IronInWindow, isLearnedShownKeptAndForgotten) {
  ASSERT_NO_FATAL_FAILURE(openFloor());
  auto* layer = find<QAction>("layerIron");
  auto* forget = find<QAction>("forgetIron");
  EXPECT_FALSE(layer->isChecked());
  EXPECT_FALSE(forget->isEnabled()) << "there is nothing to forget";
  chooseInMenu(menuWith(layer), layer);
  EXPECT_TRUE(window->canvas().layers().iron);
  window->canvas().finishDrawing();
  ui::look::take(*window, QStringLiteral("iron-empty-en"));
  find<QAction>("layerTags")->setChecked(false);  // their tips would cover the iron's
  ASSERT_NO_FATAL_FAILURE(learn(20));
  EXPECT_EQ(window->canvas().magnetic().map(), window->magneticDesk().map());
  EXPECT_TRUE(tip().contains("Iron turns the compass")) << tip().toStdString();
  EXPECT_TRUE(forget->isEnabled());
  for (const char* language : {"en", "zh_CN"}) {
    window->setLanguage(QString::fromLatin1(language));
    window->canvas().fit();
    window->canvas().finishDrawing();
    ui::look::take(*window, QStringLiteral("iron-window-") + QString::fromLatin1(language));
  }
  window->setLanguage(QStringLiteral("en"));
  ASSERT_TRUE(closeWindow());

  ASSERT_NO_FATAL_FAILURE(openFloor());
  ASSERT_TRUE(until([&] { return !window->magneticDesk().isLoading(); }));
  EXPECT_TRUE(iron().empty()) << "what was learned in the simulated world is none of the real floor's";
  window->connectTo({});
  ASSERT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Connected; }));
  EXPECT_TRUE(until([&] { return iron().nodeCount() >= 20U; }));
  EXPECT_TRUE(until([&] { return window->session().latest()->magnetic->nodeCount() >= 20U; }))
      << "the supervision has it";
  forget = find<QAction>("forgetIron");
  answerQuestion("forgetIronQuestion", "Cancel");
  chooseInMenu(menuWith(forget), forget);
  EXPECT_FALSE(iron().empty());
  answerQuestion("forgetIronQuestion", "Forget");
  chooseInMenu(menuWith(forget), forget);
  EXPECT_TRUE(iron().empty());
  EXPECT_FALSE(forget->isEnabled());
  EXPECT_TRUE(until([&] { return window->session().latest()->magnetic->empty(); }));
  ASSERT_TRUE(closeWindow());
  EXPECT_EQ(stored("floor.tessera.json", true), nullptr);
}

TEST_F(IronInWindow, comesAfterTheWindowHasGoneOn) {
  ASSERT_NO_FATAL_FAILURE(leaveIronBehind());
  ASSERT_NO_FATAL_FAILURE(openFloor());
  EXPECT_TRUE(window->magneticDesk().isLoading()) << "opening does not wait for the database";
  EXPECT_TRUE(iron().empty());
  ASSERT_TRUE(until([&] { return !window->magneticDesk().isLoading(); }));
  EXPECT_EQ(iron().nodeCount(), 1U);
  EXPECT_EQ(window->canvas().magnetic().map(), window->magneticDesk().map());
  EXPECT_TRUE(find<QAction>("forgetIron")->isEnabled());
}

TEST_F(IronInWindow, ofASiteThatWasLeftMeanwhileIsNotShownOnTheNext) {
  ASSERT_NO_FATAL_FAILURE(leaveIronBehind());
  ASSERT_NO_FATAL_FAILURE(openFloor());
  const QString next = home.filePath("next.tessera.json");
  ASSERT_TRUE(QFile::copy(QStringLiteral(TESSERA_SITES "/paper.tessera.json"), next));
  bool shown = false;
  QObject::connect(&window->magneticDesk(), &MagneticDesk::changed, window.get(),
                   [&] { shown = shown || !iron().empty(); });
  ASSERT_TRUE(window->magneticDesk().isLoading());
  ASSERT_TRUE(window->files().open(next));
  // Answers come in the order in which they were asked for.
  ASSERT_TRUE(until([&] { return !window->magneticDesk().isLoading(); }));
  EXPECT_FALSE(shown);
  ASSERT_TRUE(closeWindow());
  EXPECT_EQ(stored("next.tessera.json", false), nullptr);
  EXPECT_NE(stored("floor.tessera.json", false), nullptr);
}

TEST_F(IronInWindow, goesAlongWithASiteThatGotAnotherNameMeanwhile) {
  ASSERT_NO_FATAL_FAILURE(leaveIronBehind());
  ASSERT_NO_FATAL_FAILURE(openFloor());
  ASSERT_TRUE(window->magneticDesk().isLoading());
  window->keeper().onSaved(home.filePath("renamed.tessera.json"));
  ASSERT_TRUE(until([&] { return !window->magneticDesk().isLoading(); }));
  EXPECT_EQ(iron().nodeCount(), 1U);
  ASSERT_TRUE(closeWindow());
  EXPECT_NE(stored("renamed.tessera.json", false), nullptr);
}

TEST_F(IronInWindow, thatIsForgottenBeforeItCameStaysForgotten) {
  ASSERT_NO_FATAL_FAILURE(leaveIronBehind());
  ASSERT_NO_FATAL_FAILURE(openFloor());
  ASSERT_TRUE(window->magneticDesk().isLoading());
  window->magneticDesk().forget();
  bool answered = false;
  QObject::connect(&window->keeper(), &Keeper::magneticMapLoaded, window.get(), [&] { answered = true; });
  ASSERT_TRUE(until([&] { return answered; }));
  EXPECT_TRUE(iron().empty());
  ASSERT_TRUE(closeWindow());
  EXPECT_EQ(stored("floor.tessera.json", false), nullptr);
}

TEST_F(IronInWindow, thatCannotBeReadIsBegunAnewWithASentence) {
  ASSERT_NO_FATAL_FAILURE(leaveIronBehind());
  {
    auto database = store::Database::open(Keeper::databasePath().toStdString());
    ASSERT_TRUE(database);
    store::Transaction writing{**database, store::Transaction::Kind::Write};
    writing.run(QStringLiteral("UPDATE magnetic_map SET nodes=x'00112233'"));
    ASSERT_TRUE(writing.commit());
  }
  ASSERT_NO_FATAL_FAILURE(openWindow(false));
  QString told;
  QObject::connect(&window->magneticDesk(), &MagneticDesk::failed, window.get(), [&](const QString& s) { told = s; });
  ASSERT_TRUE(window->files().open(home.filePath("floor.tessera.json")));
  ASSERT_TRUE(until([&] { return !window->magneticDesk().isLoading(); }));
  EXPECT_TRUE(told.contains("These bytes are no magnetic map.")) << told.toStdString();
  EXPECT_TRUE(iron().empty());
}

}  // namespace
}  // namespace tessera::desktop
