// A window beside a simulated world of its own process that has one vehicle fresh from the factory, and hands for the
// wizard that sets it up.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>

#include "app/desktop/desktop_fixture.h"
#include "app/process/world_process.h"
#include "app/tessera/site_files.h"
#include "app/world/world_options.h"
#include "floor/site_json.h"
#include "tests/ui/commission/wizard_hands.h"
#include "ui/base/notice.h"
#include "ui/commission/commission_wizard.h"

namespace tessera::desktop {

using ui::CommissionWizard;
using ui::Notice;
using ui::WizardHands;

inline constexpr std::uint8_t kNewAddress = 7;

class NewVehicle : public DesktopTest {
protected:
  // The world has one vehicle, with an empty EEPROM; the hall's file has none.
  void SetUp() override {
    openWindow(false);
    const auto demo = SiteFiles::demoPath();
    ASSERT_TRUE(demo);
    const auto site = floor::loadSite(demo->toStdString());
    ASSERT_TRUE(site);
    hall = *site;
    type = hall.vehicles.front();
    hall.vehicles.clear();
    ASSERT_TRUE(floor::saveSite(hall, path().toStdString()));
    world::WorldOptions options;
    options.site = demo->toStdString();
    options.vehicles = options.fresh = {type.id.value};
    options.kind = kind();
    options.eepromDir = home.filePath("eeproms").toStdString();
    ASSERT_TRUE(world.start(world::worldArguments(options)));
  }
  /// What its firmware runs on.
  [[nodiscard]] virtual world::Kind kind() const { return world::Kind::Native; }
  [[nodiscard]] QString path() const { return home.filePath("hall.tessera.json"); }
  /// What the file holds of the new vehicle.
  [[nodiscard]] floor::VehicleSetup filed() const {
    const auto site = floor::loadSite(path().toStdString());
    return site && !site->vehicles.empty() ? site->vehicles.back() : floor::VehicleSetup{};
  }
  void connectToWorld() {
    inDialogue(QStringLiteral("connectDialog"), [this](QDialog& dialog) {
      QTest::mouseClick(dialog.findChild<QAbstractButton*>("serialKind"), Qt::LeftButton, {}, QPoint{8, 8});
      auto* field = dialog.findChild<QComboBox*>("portField")->lineEdit();
      field->setFocus();
      field->selectAll();
      QTest::keyClicks(field, QString::fromStdString(world.port()));
      QTest::mouseClick(dialog.findChild<QAbstractButton*>("connectButton"), Qt::LeftButton);
    });
    trigger("connect");
    ASSERT_TRUE(until([&] {
      const auto picture = window->session().latest();
      return picture && picture->port.state == supervisor::PortState::Open;
    }));
  }
  /// As far as the key page.
  static void describe(WizardHands& hands, const char* name) {
    hands.next();
    hands.type("vehicleName", name);
    auto& address = hands.at<QSpinBox>("vehicleAddress");
    address.setFocus();
    address.selectAll();
    QTest::keyClicks(&address, QString::number(kNewAddress));
    hands.next();
    hands.click("flashDone");
    hands.next();
  }
  static bool nextOffered(WizardHands& hands) {
    return until([&] { return hands.button(QWizard::NextButton).isEnabled(); });
  }
  static Notice::Tone tone(WizardHands& hands, const char* name) { return hands.at<Notice>(name).tone(); }
  static void pair(WizardHands& hands) {
    ASSERT_TRUE(until([&] { return hands.at<QAbstractButton>("pairVehicle").isEnabled(); }));
    hands.click("pairVehicle");
    ASSERT_TRUE(nextOffered(hands)) << hands.at<Notice>("keyResult").text().toStdString();
    EXPECT_EQ(tone(hands, "keyResult"), Notice::Tone::Good);
  }

  /// Has it turn, and writes what was found into it. Ends with the step done.
  void calibrateCompass(WizardHands& hands) const {
    ASSERT_TRUE(until([&] { return hands.at<QAbstractButton>("turnForSurvey").isEnabled(); }));
    hands.click("turnForSurvey");
    ASSERT_TRUE(until([&] { return vehicle().state == wire::VehicleState::Calibrating; }));
    ASSERT_TRUE(until([&] { return hands.at<QAbstractButton>("writeSurvey").isEnabled(); }))
        << hands.at<Notice>("surveyResult").text().toStdString();
    EXPECT_EQ(tone(hands, "surveyResult"), Notice::Tone::Warning) << "a vehicle fresh from the factory";
    EXPECT_FALSE(hands.button(QWizard::NextButton).isEnabled());
    hands.click("writeSurvey");
    ASSERT_TRUE(nextOffered(hands)) << hands.at<Notice>("surveyResult").text().toStdString();
    EXPECT_EQ(tone(hands, "surveyResult"), Notice::Tone::Good);
  }

  /// With a key held down, until it knows where it is. Ends with the step done, the vehicle standing.
  void jogOverTags(WizardHands& hands) const {
    auto& pad = hands.at<QWidget>("jogPad");
    pad.setFocus();
    ASSERT_TRUE(until([&] { return pad.hasFocus() && hands.at<QAbstractButton>("jogForward").isEnabled(); }));
    QTest::keyPress(&pad, Qt::Key_Up);
    ASSERT_TRUE(nextOffered(hands)) << hands.at<QLabel>("jogHint").text().toStdString();
    ASSERT_TRUE(until([&] { return vehicle().located; })) << "a few tags on the way tell it where it is";
    EXPECT_EQ(vehicle().task, supervisor::Task::Jogging);
    QTest::keyRelease(&pad, Qt::Key_Up);
    ASSERT_TRUE(until([&] { return vehicle().speed == MetresPerSecond{}; })) << "the released key stops it";
  }

  floor::Site hall;
  floor::VehicleSetup type;
  process::WorldProcess world;
};

}  // namespace tessera::desktop
