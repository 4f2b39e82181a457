// The whole window over a port behind which the unmodified firmware runs in an emulated microcontroller: a vehicle is
// set up with the survey of its compass, and its readers and wheels are calibrated from a drive.
#include <QFile>
#include <QPushButton>
#include <QTableWidget>

#include "app/desktop/new_vehicle.h"
#include "firmware/vehicle/settings.h"

namespace tessera::desktop {
namespace {

class EmulatedVehicle : public NewVehicle {
protected:
  [[nodiscard]] world::Kind kind() const override { return world::Kind::Qemu; }
  /// What its EEPROM holds; nullopt: nothing whole.
  [[nodiscard]] std::optional<firmware::Settings> kept() const {
    QFile file{home.filePath(QStringLiteral("eeproms/vehicle-%1.eeprom").arg(type.id.value))};
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QByteArray bytes = file.readAll();
    return firmware::settingsFromImage(
        {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())});
  }
};

TEST_F(EmulatedVehicle, isSetUpWithASurveyOfItsCompassAndCalibratedByDriving) {
  ASSERT_TRUE(window->files().open(path()));
  ASSERT_NO_FATAL_FAILURE(connectToWorld());
  inDialogue(QStringLiteral("commissionWizard"), [this](QDialog& dialog) {
    WizardHands hands{dynamic_cast<CommissionWizard&>(dialog)};
    describe(hands, "Ant");
    ASSERT_NO_FATAL_FAILURE(pair(hands));
    hands.next();
    ASSERT_TRUE(nextOffered(hands)) << hands.at<Notice>("silence").text().toStdString();
    EXPECT_TRUE(hands.at<QLabel>("contactFirmware").text().contains("LM3S6965"));
    hands.next();
    ASSERT_TRUE(until([&] { return hands.at<QAbstractButton>("writeSettings").isEnabled(); }));
    hands.click("writeSettings");
    ASSERT_TRUE(nextOffered(hands)) << hands.at<Notice>("settingsResult").text().toStdString();
    hands.next();
    hands.skip();
    const auto before = kept();
    ASSERT_TRUE(before);
    ASSERT_NO_FATAL_FAILURE(calibrateCompass(hands));
    const auto after = kept();
    ASSERT_TRUE(after);
    EXPECT_NE(after->get(wire::Parameter::CompassOffsetX), before->get(wire::Parameter::CompassOffsetX));
    EXPECT_NE(after->get(wire::Parameter::CompassOffsetY), before->get(wire::Parameter::CompassOffsetY));
    hands.next();
    ASSERT_NO_FATAL_FAILURE(jogOverTags(hands));
    hands.next();
    hands.skip();
    hands.click("calibrateNext");
  });
  trigger("commission");
  QTest::mouseClick(find("drawFigure"), Qt::LeftButton);
  EXPECT_EQ(window->selection().route(), "Calibration");
  ASSERT_TRUE(until([&] { return find("recordCalibration")->isEnabled(); }));
  QTest::mouseClick(find("recordCalibration"), Qt::LeftButton);
  ASSERT_TRUE(until([&] { return find<QAction>("runAction")->isEnabled(); }));
  trigger("runAction");
  ASSERT_TRUE(until([&] { return vehicle().task == supervisor::Task::Running; }))
      << vehicle().waits.english() << vehicle().doing.english();
  const auto* table = find<QTableWidget>("calibrateTable");
  ASSERT_TRUE(until([&] { return table->rowCount() == 2 * 3 + 1; })) << "enough reads for an estimate";
  trigger("stopAll");
}

}  // namespace
}  // namespace tessera::desktop
