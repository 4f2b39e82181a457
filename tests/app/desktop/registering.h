// The whole window before a floor of two tiles, with a reader at a pseudo terminal.
#pragma once

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <optional>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/register_desk.h"
#include "app/tessera/site_files.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "sim/pty/pty.h"

namespace tessera::desktop {

using Contact = ui::Registrar::Contact;

class Registering : public DesktopTest {
protected:
  void SetUp() override {
    const auto site = floor::layNewFloor({"hall", floor::usualTileTypes().front(), 2, 1, false}).value();
    ASSERT_TRUE(floor::saveSite(site, path().toStdString()));
    plugIn();
    openWindow(false);
    ASSERT_TRUE(window->files().open(path()));
  }
  [[nodiscard]] QString path() const { return home.filePath("hall.tessera.json"); }
  [[nodiscard]] std::string port() const { return home.filePath("reader").toStdString(); }
  void plugIn() { reader.emplace(sim::Pty::open(port()).value()); }
  void send(const std::string& bytes) {
    reader->write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
  void say(const std::string& line) { send(line + "\r\n"); }
  [[nodiscard]] ui::Registrar& registrar() const { return window->registerDesk().registrar(); }
  [[nodiscard]] std::size_t registered() const { return registrar().registration()->progress().registered; }
  void scan(const std::string& uid) {
    const std::size_t before = registered();
    say(uid);
    EXPECT_TRUE(until([&] { return registered() == before + 1; })) << uid;
  }
  /// form: as the panel lists them.
  void start(int form = 0) {
    trigger("registerTags");
    EXPECT_TRUE(find<QDockWidget>("registerDock")->isVisible());
    find<QComboBox>("scanReader")->setCurrentIndex(1);
    find<QComboBox>("scanForm")->setCurrentIndex(form);
    find<QComboBox>("scanPort")->setEditText(QString::fromStdString(port()));
    QTest::mouseClick(find("startScan"), Qt::LeftButton);
    ASSERT_TRUE(until([&] { return registrar().contact() == Contact::Open; }));
  }
  /// The program is killed once all is kept, started again, and goes on scanning.
  void dieAndGoOn() {
    const auto site = window->document().site();
    ASSERT_TRUE(until([&] {
      const auto kept = window->keeper().unsaved(path());
      return kept != nullptr && kept->site() == site;
    }));
    killWindow();
    answerQuestion("recoverQuestion", "Take them up");
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_EQ(window->document().site(), site);
    trigger("registerTags");
    auto* goOn = find<QPushButton>("goOnScanning");
    ASSERT_TRUE(until([&] { return goOn->isVisible() && goOn->isEnabled(); }));
    QTest::mouseClick(goOn, Qt::LeftButton);
  }
  void pressOnFloor(Qt::Key key) const { QTest::keyClick(&window->canvas(), key); }
  [[nodiscard]] QString said(const char* label) const { return find<QLabel>(label)->text(); }

  std::optional<sim::Pty> reader;
};

}  // namespace tessera::desktop
