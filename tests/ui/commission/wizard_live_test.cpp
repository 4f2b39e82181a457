// The steps that speak to the vehicle, over a fleet that answers as the test says.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QProgressBar>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include "floor/bearing.h"
#include "tests/ui/commission/fake_link.h"
#include "tests/ui/commission/wizard_hands.h"
#include "ui/base/notice.h"
#include "ui/calibrate/compass_survey.h"
#include "ui/commission/commission_wizard.h"
#include "ui/commission/settings_page.h"

namespace tessera::ui {
namespace {

using supervisor::Contact;

class WizardLiveTest : public testing::Test {
protected:
  void SetUp() override {
    const auto put = document.edit("route", [](floor::Site& s) {
      s.routes.push_back({"short", {{Metres{0}, Metres{0}}, {Metres{1}, Metres{0}}}, Metres{0.2}});
      s.northToY = Radians{0.3};
    });
    ASSERT_TRUE(put);
  }
  /// Skips to that page; the vehicle has address 1.
  void open(CommissionWizard::Page page) {
    while (wizard.currentId() != page) {
      if (wizard.currentId() < CommissionWizard::kFirmware)
        hands.next();
      else
        hands.skip();
    }
  }
  /// As far as the answer that its program knows nothing of surveys.
  void openCompassOfAnOldVehicle() {
    link.show(seen());
    open(CommissionWizard::kCompass);
    EXPECT_FALSE(hands.at<QAbstractButton>("calibrateCompass").isVisible()) << "a chart is the better way";
    hands.click("turnForSurvey");
    for (std::size_t n = 0; n < CompassSurvey::Values{}.size(); ++n) link.answer(wire::Outcome::Done, 0);
    EXPECT_EQ(link.last<supervisor::Ask>().request.parameter, static_cast<int>(wire::Action::SurveyCompass));
    link.answer(wire::Outcome::Unknown, 0);
    EXPECT_TRUE(hands.at<QAbstractButton>("calibrateCompass").isVisible());
  }
  supervisor::Snapshot seen(double time = 10.0) { return seenVehicles({1}, Seconds{time}); }
  bool nextAllowed() { return hands.button(QWizard::NextButton).isEnabled(); }
  Notice& notice(const char* name) { return hands.at<Notice>(name); }

  FakeLink link;
  SiteDocument document;
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
};

TEST_F(WizardLiveTest, ContactShowsTheVehicleOrSaysWhatIsWrong) {
  open(CommissionWizard::kContact);
  auto picture = seen();
  picture.vehicles.front().contact = Contact::Calling;
  link.show(picture);
  const QString calling = notice("silence").text();
  EXPECT_FALSE(calling.isEmpty());
  EXPECT_FALSE(nextAllowed());
  picture.vehicles.front().contact = Contact::Refused;
  link.show(picture);
  EXPECT_NE(notice("silence").text(), calling);
  link.show(seen());
  EXPECT_TRUE(notice("silence").text().isEmpty());
  EXPECT_TRUE(nextAllowed());
  EXPECT_EQ(hands.at<QLabel>("contactFirmware").text(), "1.0.0 on lm3s6965");
  EXPECT_EQ(notice("contactResult").tone(), Notice::Tone::Good);
  link.vanish();
  EXPECT_FALSE(nextAllowed());
}

TEST_F(WizardLiveTest, SettingsAreReadComparedAndWritten) {
  link.show(seen());
  open(CommissionWizard::kSettings);
  const auto wanted = wantedSettings(wizard.draft());
  for (const WantedSetting& s : wanted)
    link.answer(wire::Outcome::Done, s.parameter == wire::Parameter::WheelDiameter ? 1 : s.value);
  EXPECT_EQ(notice("settingsResult").tone(), Notice::Tone::Warning);
  EXPECT_FALSE(nextAllowed());
  hands.click("writeSettings");
  for (const WantedSetting& s : wanted) {
    const auto& ask = link.last<supervisor::Ask>();
    EXPECT_EQ(ask.request.type, wire::MessageType::Set);
    EXPECT_EQ(ask.request.value, s.value);
    link.answer(wire::Outcome::Done, s.value);
  }
  EXPECT_EQ(notice("settingsResult").tone(), Notice::Tone::Good);
  EXPECT_TRUE(nextAllowed());
}

TEST_F(WizardLiveTest, ReadersAreDoneWhenEachHasReadATagSinceThePageWasOpened) {
  link.show(seen(10.0));
  open(CommissionWizard::kReaders);
  const auto uid = floor::TagUid::parse("04B15F823A2F48").value();
  auto picture = seen(12.0);
  auto& reads = picture.vehicles.front().recentReads;
  reads = {{uid, 0, Seconds{5.0}, std::nullopt}};  // long ago: does not count
  link.show(picture);
  for (std::uint8_t r = 0; r < 3; ++r) {
    EXPECT_FALSE(nextAllowed());
    reads.push_back({uid, r, Seconds{11.5}, std::nullopt});
    link.show(picture);
  }
  EXPECT_TRUE(nextAllowed());
  EXPECT_EQ(hands.at<QTableWidget>("readersTable").item(2, 2)->text(), "04B15F823A2F48");
}

TEST_F(WizardLiveTest, AReaderThatDoesNotAnswerIsAnError) {
  open(CommissionWizard::kReaders);
  auto picture = seen();
  picture.vehicles.front().readersAnswering = 0x05;
  link.show(picture);
  EXPECT_EQ(notice("readersResult").tone(), Notice::Tone::Error);
}

TEST_F(WizardLiveTest, TheCompassShowsTheBearingOfTheNose) {
  open(CommissionWizard::kCompass);
  auto picture = seen();
  picture.vehicles.front().heading = floor::headingOfBearing(Radians{kPi / 2}, document.site().northToY);
  link.show(picture);
  EXPECT_EQ(hands.at<QLabel>("bearing").text(), "90°");
  hands.click("compassRight");
  EXPECT_TRUE(nextAllowed());
}

TEST_F(WizardLiveTest, AVehicleTooOldForAChartCalibratesByItself) {
  openCompassOfAnOldVehicle();
  hands.click("calibrateCompass");
  EXPECT_EQ(link.last<supervisor::Ask>().request.type, wire::MessageType::Do);
  link.answer(wire::Outcome::Started, 0);
  auto picture = seen();
  picture.vehicles.front().state = wire::VehicleState::Calibrating;
  link.show(picture);
  const std::size_t orders = link.orders.size();
  link.show(seen());
  ASSERT_EQ(link.orders.size(), orders + 1);
  EXPECT_EQ(link.last<supervisor::Ask>().request.type, wire::MessageType::Get);
  link.answer(wire::Outcome::Done, static_cast<std::int32_t>(wire::Outcome::Failed));
  EXPECT_EQ(notice("compassResult").tone(), Notice::Tone::Error);
  EXPECT_FALSE(nextAllowed());

  hands.click("calibrateCompass");
  link.answer(wire::Outcome::Started, 0);
  link.show(picture);
  link.show(seen());
  link.answer(wire::Outcome::Done, static_cast<std::int32_t>(wire::Outcome::Done));
  EXPECT_EQ(notice("compassResult").tone(), Notice::Tone::Good);
  EXPECT_TRUE(nextAllowed());
}

TEST_F(WizardLiveTest, LeavingThePageStopsACalibration) {
  openCompassOfAnOldVehicle();
  hands.click("calibrateCompass");
  link.answer(wire::Outcome::Started, 0);
  hands.back();
  EXPECT_EQ(link.count<supervisor::Stop>(), 1U);
}

TEST_F(WizardLiveTest, LeavingThePageStopsASurvey) {
  link.show(seen());
  open(CommissionWizard::kCompass);
  hands.click("turnForSurvey");
  for (std::size_t n = 0; n < CompassSurvey::Values{}.size(); ++n) link.answer(wire::Outcome::Done, 0);
  link.answer(wire::Outcome::Started, 0);
  EXPECT_FALSE(nextAllowed());
  hands.back();
  EXPECT_EQ(link.count<supervisor::Stop>(), 1U);
}

TEST_F(WizardLiveTest, TheSummaryLeadsOnToReadersAndWheels) {
  link.show(seen());
  open(CommissionWizard::kSummary);
  EXPECT_FALSE(wizard.goesOnCalibrating());
  hands.click("calibrateNext");
  EXPECT_FALSE(wizard.isVisible());
  EXPECT_EQ(wizard.result(), QDialog::Accepted);
  EXPECT_TRUE(wizard.goesOnCalibrating());
  EXPECT_TRUE(wizard.vehicle());
}

TEST_F(WizardLiveTest, DrivingByHandIsDoneWhenTheVehicleHasMoved) {
  link.show(seen());
  open(CommissionWizard::kJog);
  auto* pad = wizard.currentPage()->findChild<QWidget*>("jogPad");
  pad->setFocus();
  QTest::keyPress(pad, Qt::Key_Up);
  EXPECT_EQ(link.count<supervisor::Jog>(), 1U);
  EXPECT_FALSE(nextAllowed());
  auto picture = seen();
  picture.vehicles.front().task = supervisor::Task::Jogging;
  picture.vehicles.front().speed = MetresPerSecond{0.05};
  link.show(picture);
  EXPECT_TRUE(nextAllowed());
  hands.next();
  EXPECT_EQ(link.count<supervisor::Stop>(), 1U);
}

TEST_F(WizardLiveTest, TheFirstDriveRunsSlowlyAndEndsTheSetUp) {
  link.show(seen());
  open(CommissionWizard::kDrive);
  hands.click("firstRun");
  const auto& run = link.last<supervisor::RunRoute>();
  EXPECT_EQ(run.route, "short");
  EXPECT_DOUBLE_EQ(run.speed.value(), 0.05);
  auto picture = seen();
  auto& v = picture.vehicles.front();
  v.task = supervisor::Task::Running;
  v.located = true;
  v.length = Metres{1.0};
  v.progress = Metres{0.25};
  link.show(picture);
  EXPECT_EQ(hands.at<QProgressBar>("firstProgress").value(), 250);
  EXPECT_FALSE(nextAllowed());
  v.task = supervisor::Task::Finished;
  v.finished = true;
  link.show(picture);
  EXPECT_TRUE(nextAllowed());
}

TEST_F(WizardLiveTest, LeavingTheFirstDriveStopsIt) {
  link.show(seen());
  open(CommissionWizard::kDrive);
  hands.click("firstRun");
  hands.back();
  EXPECT_EQ(link.count<supervisor::Stop>(), 1U);
}

TEST_F(WizardLiveTest, AKnownKeyGoesIntoTheSite) {
  open(CommissionWizard::kKey);
  QSignalSpy changed{&wizard, &CommissionWizard::siteChanged};
  QTest::mouseClick(&hands.at<QRadioButton>("knownKind"), Qt::LeftButton, {}, QPoint{8, 8});
  hands.type("typedKey", "12 34");
  hands.click("useKey");
  EXPECT_EQ(notice("keyResult").tone(), Notice::Tone::Error);
  EXPECT_EQ(changed.count(), 0);
  hands.type("typedKey", "284A 27C7 42C6 15C4 D464 76E3 ADBF CA68");
  hands.click("useKey");
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(document.site().vehicles.back().key[1], 0x4A);
  link.show(seen());
  EXPECT_TRUE(nextAllowed());
}

}  // namespace
}  // namespace tessera::ui
