// What must be within reach whatever the window looks like: at any size, with panels closed, in both languages.
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QToolButton>
#include <tuple>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/site_files.h"
#include "ui/help/help_window.h"

namespace tessera::desktop {
namespace {

using supervisor::Task;

class Reach : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    ASSERT_NO_FATAL_FAILURE(startDemo());
  }
};

TEST_F(Reach, showsTheStopButtonInTheSmallestWindow) {
  auto* button = find("stopAllButton");
  for (const char* language : {"en", "zh_CN"}) {
    window->setLanguage(QString::fromLatin1(language));
    window->resize(window->minimumSizeHint());
    EXPECT_TRUE(until([&] { return window->width() <= std::max(800, window->minimumSizeHint().width()); }));
    QApplication::processEvents();
    EXPECT_TRUE(button->isVisible()) << language;
    const QRect there{button->mapTo(window.get(), QPoint{}), button->size()};
    EXPECT_TRUE(window->rect().contains(there)) << language << ": cut off";
    EXPECT_GE(button->width(), button->sizeHint().width()) << language;
  }
}

TEST_F(Reach, fitsOnTheScreenOfALaptop) {
  for (const char* language : {"en", "zh_CN"}) {
    window->setLanguage(QString::fromLatin1(language));
    QApplication::processEvents();
    EXPECT_LE(window->minimumSizeHint().height(), 700) << language << ", of 768 with a bar of the desktop";
    EXPECT_LE(window->minimumSizeHint().width(), 1024) << language;
  }
}

TEST_F(Reach, givesOrdersByKeyWhileTheirPanelIsClosed) {
  find<QDockWidget>("runDock")->close();
  pressWhenOffered("runAction", Qt::Key_F5);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Running; }));
  pressWhenOffered("pauseAction", Qt::Key_F6);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Paused; }));
  pressWhenOffered("stopAction", Qt::Key_F7);
  EXPECT_TRUE(until([&] { return vehicle().task == Task::Stopped; }));
}

// What Alt and a letter reach at once: the menus and whatever is in sight beside them.
QStringList lettersOfTwoMeanings(const QMainWindow& window) {
  QMap<QString, QStringList> meant;
  const auto note = [&](const QKeySequence& key, const QString& what) {
    if (!key.isEmpty() && !meant[key.toString()].contains(what)) meant[key.toString()] << what;
  };
  for (const QAction* menu : window.menuBar()->actions()) note(QKeySequence::mnemonic(menu->text()), menu->text());
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
    if (button->isVisible() && !QKeySequence::mnemonic(button->text()).isEmpty())
      note(button->shortcut(), button->objectName() + QLatin1Char{' '} + button->text());
  for (const QLabel* label : window.findChildren<QLabel*>())
    if (label->isVisible() && label->buddy() != nullptr) note(QKeySequence::mnemonic(label->text()), label->text());
  QStringList twice;
  for (auto it = meant.cbegin(); it != meant.cend(); ++it)
    if (it->size() > 1) twice << it.key() + QStringLiteral(": ") + it->join(QStringLiteral(", "));
  return twice;
}

TEST_F(Reach, givesNoLetterTwoMeaningsAtOnce) {
  for (const char* language : {"en", "zh_CN"}) {
    window->setLanguage(QString::fromLatin1(language));
    for (const char* view : {"browse", "editRoutes", "editZones", "layTiles", "registerTags", "showFaults",
                             "showRevisions", "floorPlan"}) {
      trigger(view);
      QApplication::processEvents();
      EXPECT_EQ(lettersOfTwoMeanings(*window).join("; ").toStdString(), "") << language << " " << view;
    }
  }
}

TEST_F(Reach, givesNoLetterTwoMeaningsOnASiteWithoutVehicles) {
  ASSERT_TRUE(window->document().edit("Without vehicles", [](floor::Site& site) {
    site.vehicles.clear();
    site.routes.clear();
  }));
  for (const char* language : {"en", "zh_CN"}) {
    window->setLanguage(QString::fromLatin1(language));
    QApplication::processEvents();
    EXPECT_EQ(lettersOfTwoMeanings(*window).join("; ").toStdString(), "") << language;
  }
}

TEST_F(Reach, leavesTheButtonsWhereTheyAreWhenADriveBegins) {
  const auto places = [&] {
    QList<QPoint> all;
    for (const char* name : {"runButton", "pauseButton", "stopButton", "clearButton"})
      all << find(name)->mapTo(window.get(), QPoint{});
    return all;
  };
  const auto before = places();
  pressWhenOffered("runAction", Qt::Key_F5);
  EXPECT_TRUE(until([&] { return vehicle().progress > Metres{0.1}; }));
  QApplication::processEvents();
  EXPECT_EQ(places(), before);
}

TEST_F(Reach, helpsWithTheViewThatAsksByKeyInDialoguesAsWell) {
  const auto shown = [](const QWidget& within) {
    const auto* help = within.findChild<ui::HelpWindow*>();
    return help != nullptr && help->isVisible() ? help->topic().toStdString() : "no help";
  };
  window->canvas().setFocus();
  press(Qt::Key_F1);
  EXPECT_EQ(shown(*window), "floor");
  for (const auto& [action, name, topic] :
       {std::tuple{"connect", "connectDialog", "connecting"}, std::tuple{"tileTypes", "tileTypesDialog", "tiles"}}) {
    inDialogue(QString::fromLatin1(name), [&shown, topic](QDialog& dialog) {
      QTest::keyClick(&dialog, Qt::Key_F1);
      EXPECT_EQ(shown(dialog), topic);
    });
    trigger(action);
  }
}

// The letters that open a menu, press a button or lead to a field together with Alt.
TEST_F(Reach, givesNoLetterTwoMeanings) {
  static const QRegularExpression letter{QStringLiteral("&([^&])")};
  for (const char* language : {"en", "zh_CN"}) {
    window->setLanguage(QString::fromLatin1(language));
    QApplication::processEvents();
    QMap<QString, QString> taken;
    const auto take = [&](const QString& text) {
      const auto found = letter.match(text);
      if (!found.hasMatch()) return;
      const QString key = found.captured(1).toUpper();
      EXPECT_FALSE(taken.contains(key)) << language << ": Alt+" << key.toStdString() << " is “" << text.toStdString()
                                        << "” and “" << taken.value(key).toStdString() << "”";
      taken.insert(key, text);
    };
    for (const QAction* menu : window->menuBar()->actions()) take(menu->text());
    for (const QLabel* label : window->findChildren<QLabel*>())
      if (label->buddy() != nullptr && label->isVisible()) take(label->text());
    for (const QAbstractButton* button : window->findChildren<QAbstractButton*>())
      if (button->isVisible()) take(button->text());
  }
}

class KeysInTheHelp : public DesktopTest {
protected:
  /// The keys of the page's first table: those that hold in the whole window.
  static QSet<QString> keysOn(const QString& language) {
    QFile file{QStringLiteral(":/help/%1/keyboard.md").arg(language)};
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << language.toStdString();
    const QString table = QString::fromUtf8(file.readAll()).section(QStringLiteral("\n## "), 0, 0);
    static const QRegularExpression row{QStringLiteral("^\\| ([^|]+) \\|"), QRegularExpression::MultilineOption};
    static const QRegularExpression between{QStringLiteral("、|, ")};
    QSet<QString> keys;
    for (auto rows = row.globalMatch(table); rows.hasNext();) {
      const QString cell = rows.next().captured(1).remove(QStringLiteral("**"));
      for (QString key : cell.split(between)) {
        const QKeySequence sequence{key.replace(QChar{0x2212}, QLatin1Char{'-'})};
        // The table's own head and its line are no keys.
        if (sequence[0].key() != Qt::Key_unknown && !sequence.isEmpty()) keys.insert(sequence.toString());
      }
    }
    return keys;
  }
};

TEST_F(KeysInTheHelp, areThoseOfTheWindow) {
  openWindow(false);
  const QSet<QString> english = keysOn(QStringLiteral("en"));
  ASSERT_GT(english.size(), 25);
  for (const char* language : {"en", "zh_CN"}) {
    const QSet<QString> told = keysOn(QString::fromLatin1(language));
    QSet<QString> real{QStringLiteral("F12")};  // pressed in any window, so no action's
    for (const QAction* action : window->actions()) {
      const auto shortcuts = action->shortcuts();
      for (const QKeySequence& key : shortcuts) real.insert(key.toString());
      EXPECT_TRUE(shortcuts.isEmpty() ||
                  std::any_of(shortcuts.begin(), shortcuts.end(),
                              [&](const QKeySequence& key) { return told.contains(key.toString()); }))
          << language << ": nothing of " << action->text().toStdString() << ", "
          << action->shortcut().toString().toStdString();
    }
    for (const QString& key : told) EXPECT_TRUE(real.contains(key)) << language << ": " << key.toStdString();
    EXPECT_EQ(told, english) << language;
  }
}

TEST_F(Reach, sendsTheChosenOneOfThreeVehiclesAndNoOther) {
  ASSERT_TRUE(window->files().open(QStringLiteral(TESSERA_SITES "/three.tessera.json")));
  window->connectTo({});
  const auto all = [&](const auto& holds) {
    const auto picture = window->session().latest();
    return picture && picture->vehicles.size() == 3 &&
           std::all_of(picture->vehicles.begin(), picture->vehicles.end(), holds);
  };
  ASSERT_TRUE(until([&] { return all([](const auto& v) { return v.located; }); }));
  const auto second = [&] { return window->session().latest()->vehicles[1]; };
  // A click takes what is seen, and the floor shows the news with its next frame.
  ASSERT_TRUE(until([&] {
    const QPoint at = pixelOf(second().pose.position.x.value(), second().pose.position.y.value());
    QTest::mouseClick(&window->canvas(), Qt::LeftButton, {}, at);
    return window->selection().vehicle() == second().id;
  }));
  const floor::Route route = window->document().site().routes[1];
  window->selection().setRoute(QString::fromStdString(route.name));
  pressWhenOffered("runAction", Qt::Key_F5);
  ASSERT_TRUE(until([&] { return second().task == Task::Running; }));
  EXPECT_EQ(second().route, route.name);
  EXPECT_TRUE(all([&](const auto& v) { return v.id == second().id || v.task == Task::None; }));
  press(Qt::Key_F12);
  EXPECT_TRUE(until([&] { return second().task == Task::Stopped; }));
}

}  // namespace
}  // namespace tessera::desktop
