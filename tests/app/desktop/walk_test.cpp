// An integrator's day from an empty floor to a saved site, by mouse and keys, with a reader at a port; in the middle of
// it the program is killed as the kernel kills.
#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <csignal>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/exchange_files.h"
#include "app/tessera/keeper.h"
#include "app/tessera/register_desk.h"
#include "app/tessera/site_files.h"
#include "sim/pty/pty.h"
#include "store/site_store.h"

namespace tessera::desktop {
namespace {

// Where the first half leaves what the second half goes on with; set in the process that is to be killed.
constexpr const char* kWalkHome = "TESSERA_WALK_HOME";
constexpr std::size_t kTagsOfATile = 8;

class Walk : public DesktopTest {
protected:
  Walk() {
    if (!isFirstHalf()) return;
    home.remove();  // nobody will be left to do it
    qputenv("XDG_DATA_HOME", at("data").toUtf8());
    qputenv("XDG_CONFIG_HOME", at("config").toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, at("config"));
  }
  [[nodiscard]] static bool isFirstHalf() { return qEnvironmentVariableIsSet(kWalkHome); }
  [[nodiscard]] QString at(const char* name) const {
    return (isFirstHalf() ? qEnvironmentVariable(kWalkHome) : home.path()) + "/" + QString::fromLatin1(name);
  }
  [[nodiscard]] const floor::Site& site() const { return window->document().site(); }
  [[nodiscard]] ui::Registrar& registrar() const { return window->registerDesk().registrar(); }
  [[nodiscard]] QString summary() const { return find<QToolButton>("faultSummary")->text(); }

  [[nodiscard]] std::string firstFault() const {
    const auto* faults = find<QAbstractItemView>("faultList")->model();
    return faults->rowCount() == 0 ? "none" : faults->index(0, 0).data().toString().toStdString();
  }

  void drag(double x, double y, double toX, double toY) const {
    auto& canvas = window->canvas();
    const QPoint from = pixelOf(x, y);
    const QPoint to = pixelOf(toX, toY);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
    for (int n = 1; n <= 20; ++n) {
      const QPoint now = from + (to - from) * n / 20;
      QMouseEvent move{QEvent::MouseMove, now, canvas.mapToGlobal(now), Qt::NoButton, Qt::LeftButton, {}};
      QApplication::sendEvent(&canvas, &move);
    }
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
  }

  /// After a dialogue, as the window's keys are the active window's.
  void beActive() const {
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
  void makeAnEmptySite() {
    inDialogue(QStringLiteral("newSiteDialog"), [](QDialog& dialog) {
      dialog.findChild<QLineEdit*>("siteName")->selectAll();
      QTest::keyClicks(dialog.findChild<QLineEdit*>("siteName"), "Walk");
      QTest::mouseClick(dialog.findChild<QCheckBox*>("emptyFloor"), Qt::LeftButton, {}, QPoint{8, 8});
      QTest::keyClick(&dialog, Qt::Key_Return);
    });
    QTest::mouseClick(find("newButton"), Qt::LeftButton);
    ASSERT_EQ(site().name, "Walk");
    ASSERT_TRUE(site().placements.empty());
  }
  void makeATileType() {
    inDialogue(QStringLiteral("tileTypesDialog"), [](QDialog& dialog) {
      dialog.findChild<QMenu*>("addTypeMenu")->actions().front()->trigger();
      auto* name = dialog.findChild<QLineEdit*>("typeName");
      name->selectAll();
      QTest::keyClicks(name, "Hall tile");
      QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
    });
    trigger("tileTypes");
    ASSERT_EQ(site().tileTypes.size(), 2U);
    ASSERT_EQ(site().tileTypes.back().name, "Hall tile");
  }
  void paintSixByFour() {
    ASSERT_NO_FATAL_FAILURE(beActive());
    press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(until([&] { return find("tilePanel")->isVisible(); }));
    auto* type = find<QComboBox>("layType");
    type->setFocus();
    QTest::keyClicks(type, "Hall");
    ASSERT_EQ(type->currentText(), "Hall tile");
    // The first tile decides where the lattice lies.
    drag(0.3, 0.3, 3.3, 0.3);
    ASSERT_EQ(site().placements.size(), 6U);
    const Point first = site().placements.front().origin;
    for (int row = 1; row < 4; ++row) {
      const double y = first.y.value() + 0.6 * row + 0.3;
      drag(first.x.value() + 0.3, y, first.x.value() + 3.3, y);
    }
    ASSERT_EQ(site().placements.size(), 24U);
    QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  }

  void plugIn() { reader.emplace(sim::Pty::open(at("reader").toStdString()).value()); }
  void say(const std::string& line) {
    const std::string text = line + "\r\n";
    reader->write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  void scan(const std::string& uid) {
    const auto registered = [&] { return registrar().registration()->progress().registered; };
    const std::size_t before = registered();
    say(uid);
    ASSERT_TRUE(until([&] { return registered() == before + 1; })) << uid;
  }
  void beginToScan() {
    trigger("registerTags");
    find<QComboBox>("scanReader")->setCurrentIndex(1);
    find<QComboBox>("scanPort")->setEditText(at("reader"));
    QTest::mouseClick(find("startScan"), Qt::LeftButton);
    ASSERT_TRUE(until([&] { return registrar().contact() == ui::Registrar::Contact::Open; }));
  }
  void scanATileAndABit() {
    for (const char* uid : {"0B000001", "0B000002", "0B000003"}) ASSERT_NO_FATAL_FAILURE(scan(uid));
    say("0B000001");
    ASSERT_TRUE(until([&] { return find("scanWhere")->isVisible(); })) << "it is told where that UID is";
    QTest::keyClick(&window->canvas(), Qt::Key_Delete);  // the fourth is dead
    ASSERT_NO_FATAL_FAILURE(scan("0B0000FF"));
    const auto next = registrar().place();
    QTest::keyClick(&window->canvas(), Qt::Key_Backspace);
    EXPECT_NE(registrar().place(), next);
    for (const char* uid : {"0B000005", "0B000006", "0B000007", "0B000008", "0B000009"})
      ASSERT_NO_FATAL_FAILURE(scan(uid));
  }
  void dieOnceItIsKept() {
    ASSERT_TRUE(until([&] {
      const auto database = store::Database::open(Keeper::databasePath().toStdString());
      if (!database) return false;
      const auto kept = store::SiteStore{**database}.load(window->keeper().key());
      return kept && *kept && **kept == site();
    }));
    std::raise(SIGKILL);
  }

  void firstHalf() {
    ASSERT_NO_FATAL_FAILURE(openWindow(false));
    ASSERT_NO_FATAL_FAILURE(makeAnEmptySite());
    ASSERT_NO_FATAL_FAILURE(makeATileType());
    ASSERT_NO_FATAL_FAILURE(paintSixByFour());
    plugIn();
    ASSERT_NO_FATAL_FAILURE(beginToScan());
    ASSERT_NO_FATAL_FAILURE(scanATileAndABit());
    dieOnceItIsKept();
  }

  void goOnAfterTheKill() {
    plugIn();
    answerQuestion("homelessQuestion", "Open it");
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_EQ(site().placements.size(), 24U);
    trigger("registerTags");
    auto* goOn = find<QPushButton>("goOnScanning");
    ASSERT_TRUE(until([&] { return goOn->isVisible() && goOn->isEnabled(); }));
    QTest::mouseClick(goOn, Qt::LeftButton);
    ASSERT_TRUE(until([&] { return registrar().contact() == ui::Registrar::Contact::Open; }));
    EXPECT_EQ(registrar().registration()->progress().registered, kTagsOfATile);
    EXPECT_EQ(registrar().registration()->progress().skipped, 1U);
    for (int n = 10; n <= 16; ++n) ASSERT_NO_FATAL_FAILURE(scan("0B0000" + std::to_string(n)));
    QTest::mouseClick(find("scanPause"), Qt::LeftButton);
    QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  }
  /// The tag that was dead was replaced; it and the other 22 tiles come as a table.
  void importTheRest() {
    QFile table{at("rest.csv")};
    ASSERT_TRUE(table.open(QIODevice::WriteOnly));
    table.write("serial,index,uid\n");
    int number = 0x100;
    for (const floor::Tile& tile : site().tiles)
      for (std::size_t n = 0; n < kTagsOfATile; ++n) {
        if (n < tile.uids.size() && !tile.uids[n].empty()) continue;
        table.write(QStringLiteral("%1,%2,0C%3\n")
                        .arg(QString::fromStdString(tile.serial))
                        .arg(n + 1)
                        .arg(number++, 6, 16, QLatin1Char('0'))
                        .toUtf8());
      }
    table.close();
    inDialogue(QStringLiteral("changesDialog"), [](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
    ASSERT_TRUE(window->findChild<ExchangeFiles*>()->importFrom(table.fileName()));
    ASSERT_EQ(window->document().map()->tags().size(), 24 * kTagsOfATile);
  }
  void drawZonesAndARoute() {
    const Point low = site().placements.front().origin;
    const double x = low.x.value();
    const double y = low.y.value();
    ASSERT_NO_FATAL_FAILURE(beActive());
    trigger("fit");
    trigger("drawZoneKind0");
    drag(x, y, x + 3.6, y + 2.4);
    ASSERT_EQ(site().zones.size(), 1U);
    ASSERT_EQ(site().zones[0].kind, floor::ZoneKind::Running);
    press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    drag(x + 3.0, y + 1.8, x + 3.6, y + 2.4);
    ASSERT_EQ(site().zones.size(), 2U);
    drawRoute({{x + 0.6, y + 0.6}, {x + 0.6, y + 1.8}, {x + 2.1, y + 1.8}, {x + 2.1, y + 0.6}});
    ASSERT_EQ(site().routes.size(), 1U);
  }

  std::optional<sim::Pty> reader;
};

TEST_F(Walk, fromAnEmptyFloorToASavedSiteThatReopensEqual) {
  if (isFirstHalf()) return firstHalf();
  QProcess half;
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.insert(kWalkHome, home.path());
  half.setProcessEnvironment(environment);
  half.setProcessChannelMode(QProcess::ForwardedChannels);
  half.start(QCoreApplication::applicationFilePath(), {"--gtest_filter=Walk.*"});
  ASSERT_TRUE(half.waitForFinished(-1));
  ASSERT_EQ(half.exitStatus(), QProcess::CrashExit) << "it ended by itself, see above";
  ASSERT_EQ(half.exitCode(), SIGKILL);

  ASSERT_NO_FATAL_FAILURE(goOnAfterTheKill());
  ASSERT_NO_FATAL_FAILURE(importTheRest());
  ASSERT_NO_FATAL_FAILURE(drawZonesAndARoute());
  // Vehicles are set up by a wizard of their own; nothing else is left to mend.
  EXPECT_TRUE(until([&] { return summary() == "1 warning"; })) << summary().toStdString();
  EXPECT_EQ(firstFault(), "The site has no vehicle: routes are checked for a usual one.");

  const floor::Site done = site();
  const int steps = window->document().undoStack().count();
  for (int n = 0; n < steps; ++n) press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window->document().undoStack().canUndo());
  for (int n = 0; n < steps; ++n) press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(site(), done);

  nameTheFile(at("walk.tessera.json"));
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(window->document().path(), at("walk.tessera.json"));
  EXPECT_FALSE(window->isWindowModified());
  ASSERT_TRUE(closeWindow());
  ASSERT_NO_FATAL_FAILURE(openWindow());
  EXPECT_EQ(window->document().path(), at("walk.tessera.json"));
  EXPECT_EQ(site(), done);
}

}  // namespace
}  // namespace tessera::desktop
