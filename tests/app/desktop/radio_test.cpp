// The radio module of this computer is read and set in the window, over the port of a simulated world whose jumpers
// the test sets as a person would.
#include <QAbstractButton>
#include <QComboBox>
#include <QTableWidget>

#include "app/desktop/desktop_fixture.h"
#include "app/process/world_process.h"
#include "app/tessera/site_files.h"
#include "app/world/world_options.h"
#include "floor/site_json.h"
#include "ui/base/notice.h"

namespace tessera::desktop {
namespace {

using ui::Notice;

constexpr int kPowerRow = 8;
constexpr int kModuleColumn = 1;

class RadioOfThisComputer : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    const auto demo = SiteFiles::demoPath();
    ASSERT_TRUE(demo);
    world::WorldOptions options;
    options.site = demo->toStdString();
    ASSERT_TRUE(world.start(world::worldArguments(options)));
    auto site = floor::loadSite(options.site);
    ASSERT_TRUE(site);
    channel = site->radio.channel;
  }
  /// The site's file with this channel, opened and connected.
  void connectWithChannel(int number) {
    auto site = floor::loadSite(SiteFiles::demoPath().value().toStdString()).value();
    site.radio.channel = number;
    const QString path = home.filePath("hall.tessera.json");
    ASSERT_TRUE(floor::saveSite(site, path.toStdString()));
    ASSERT_TRUE(window->files().open(path));
    ui::ConnectionChoice choice;
    choice.kind = ui::ConnectionChoice::Kind::Serial;
    choice.port = QString::fromStdString(world.port());
    window->connectTo(choice);
    ASSERT_TRUE(until([&] {
      const auto picture = window->session().latest();
      return picture && picture->port.state == supervisor::PortState::Open;
    }));
  }
  void setJumpers(bool off) { world.command(off ? "jumpers 1 1" : "jumpers 0 0"); }

  /// Presses it and waits until the module has answered, or has not.
  static Notice& press(QDialog& dialog, const char* button) {
    auto& result = *dialog.findChild<Notice*>("radioResult");
    QTest::mouseClick(dialog.findChild<QAbstractButton*>(QLatin1String{button}), Qt::LeftButton);
    EXPECT_TRUE(until([&] { return result.tone() != Notice::Tone::Info; }));
    return result;
  }
  /// The world hears of its jumpers a moment after the hand has left them.
  static Notice& readOnceItListens(QDialog& dialog) {
    Notice* result = &press(dialog, "readModule");
    for (int i = 0; i < 5 && result->tone() == Notice::Tone::Error; ++i) result = &press(dialog, "readModule");
    return *result;
  }
  static QString cell(QDialog& dialog, int row, int column) {
    return dialog.findChild<QTableWidget*>("radioTable")->item(row, column)->text();
  }

  process::WorldProcess world;
  int channel = 0;
};

TEST_F(RadioOfThisComputer, isReadGivenAnotherPowerAndReadBack) {
  ASSERT_NO_FATAL_FAILURE(connectWithChannel(channel));
  ASSERT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Connected; }));
  inDialogue(QStringLiteral("radioDialog"), [this](QDialog& dialog) {
    EXPECT_EQ(window->session().state(), FleetSession::State::Resting);
    const Notice& refused = press(dialog, "readModule");
    EXPECT_EQ(refused.tone(), Notice::Tone::Error);
    EXPECT_TRUE(refused.text().contains("jumpers")) << refused.text().toStdString();

    setJumpers(true);
    EXPECT_EQ(readOnceItListens(dialog).tone(), Notice::Tone::Good);
    auto* power = dialog.findChild<QComboBox*>("powerField");
    const QString before = cell(dialog, kPowerRow, kModuleColumn);
    EXPECT_EQ(before, power->currentText());
    power->setFocus();
    QTest::keyClick(power, power->currentIndex() == 3 ? Qt::Key_Home : Qt::Key_End);
    ASSERT_NE(power->currentText(), before);
    EXPECT_EQ(cell(dialog, kPowerRow, kModuleColumn), before) << "not written yet";
    EXPECT_EQ(press(dialog, "writeModule").tone(), Notice::Tone::Good);
    EXPECT_EQ(cell(dialog, kPowerRow, kModuleColumn), power->currentText());
    EXPECT_EQ(press(dialog, "readModule").tone(), Notice::Tone::Good);
    EXPECT_EQ(cell(dialog, kPowerRow, kModuleColumn), power->currentText()) << "the module keeps it";
    setJumpers(false);
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  trigger("radio");
  EXPECT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Connected; })) << "the vehicles are back";
}

TEST_F(RadioOfThisComputer, isToldToBeOnAnotherChannelUntilItIsWritten) {
  ASSERT_NO_FATAL_FAILURE(connectWithChannel(channel + 1));
  inDialogue(QStringLiteral("radioDialog"), [this](QDialog& dialog) {
    const auto& advice = *dialog.findChild<Notice*>("radioAdvice");
    setJumpers(true);
    EXPECT_EQ(readOnceItListens(dialog).tone(), Notice::Tone::Warning);
    EXPECT_TRUE(advice.text().contains(QStringLiteral("channel %1").arg(channel))) << advice.text().toStdString();
    EXPECT_EQ(press(dialog, "writeModule").tone(), Notice::Tone::Good);
    EXPECT_TRUE(advice.text().isEmpty()) << advice.text().toStdString();
    setJumpers(false);
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  trigger("radio");
}

}  // namespace
}  // namespace tessera::desktop
