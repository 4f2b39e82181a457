// The compass's step of the wizard, with a survey that is answered as the test says: when it is done, and that the
// wizard stays while values are being written.
#include <gtest/gtest.h>

#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/ui/commission/fake_link.h"
#include "tests/ui/commission/wizard_hands.h"
#include "ui/base/notice.h"
#include "ui/calibrate/compass_survey.h"
#include "ui/commission/commission_wizard.h"

namespace tessera::ui {
namespace {

using Values = CompassSurvey::Values;

constexpr Values kFactory{0, 0, 10'000, 0, 0, 10'000};

class WizardsCompass : public testing::Test {
protected:
  void SetUp() override {
    link.show(seen());
    while (wizard.currentId() != CommissionWizard::kCompass) {
      if (wizard.currentId() < CommissionWizard::kFirmware)
        hands.next();
      else
        hands.skip();
    }
  }
  supervisor::Snapshot seen(std::uint16_t faults = 0) {
    auto picture = seenVehicles({1});
    picture.vehicles.front().faults = faults;
    return picture;
  }
  /// The vehicle holds these values and turns in an even field that hard iron has moved by 10 µT.
  void turn(const Values& held) {
    hands.click("turnForSurvey");
    tell(held);
    link.answer(wire::Outcome::Started, 0);
    for (int n = 0; n < wire::kCompassSamples; ++n) {
      const double angle = 2.0 * kPi * n / wire::kCompassSamples;
      const auto counts = [](double microtesla) {
        return static_cast<std::int16_t>(std::lround(microtesla * 1000.0 / wire::kCompassCountNanotesla));
      };
      link.answer(wire::Outcome::Done,
                  wire::packCompass({counts(10.0 + 20.0 * std::cos(angle)), counts(20.0 * std::sin(angle))}));
    }
    auto turning = seen();
    turning.vehicles.front().state = wire::VehicleState::Calibrating;
    link.show(turning);
    link.show(seen());
  }
  /// It answers as many questions with these.
  void tell(const Values& held) {
    for (const std::int32_t value : held) link.answer(wire::Outcome::Done, value);
  }
  /// It takes what is written, one value after the other; what was.
  Values take(std::size_t count = Values{}.size()) {
    Values taken{};
    for (std::size_t n = 0; n < count; ++n) {
      taken[n] = link.last<supervisor::Ask>().request.value;
      link.answer(wire::Outcome::Done, taken[n]);
    }
    return taken;
  }
  bool isDone() { return hands.button(QWizard::NextButton).isEnabled(); }
  QString result() { return hands.at<Notice>("surveyResult").text(); }
  /// What the question says that this raises; empty: it raised none.
  QString refusalOf(const std::function<void()>& work) {
    QString said;
    QTimer::singleShot(0, &wizard, [&] {
      auto* box = wizard.findChild<QMessageBox*>();
      if (box == nullptr) return;
      said = box->text();
      box->accept();
    });
    work();
    QCoreApplication::processEvents();
    return said;
  }

  FakeLink link;
  SiteDocument document;
  CommissionWizard wizard{link, document};
  WizardHands hands{wizard};
};

TEST_F(WizardsCompass, isDoneWhenWhatWasFoundIsInForceAndOpenAgainWithTheOldValues) {
  turn(kFactory);
  EXPECT_FALSE(isDone()) << result().toStdString();
  hands.click("writeSurvey");
  const Values found = take();
  EXPECT_NEAR(found[0], 10'000, 50) << "nT";
  EXPECT_FALSE(isDone()) << "not read back yet";
  tell(found);
  EXPECT_TRUE(isDone()) << result().toStdString();
  hands.click("restoreCompass");
  EXPECT_EQ(take(), kFactory);
  tell(kFactory);
  EXPECT_TRUE(result().startsWith("The vehicle has its old values back")) << result().toStdString();
  EXPECT_FALSE(isDone());
}

TEST_F(WizardsCompass, isNotDoneByOldValuesAfterAWriteThatWasNotKept) {
  turn(kFactory);
  hands.click("writeSurvey");
  const Values found = take();
  link.show(seen(wire::kFaultEeprom));
  tell(found);
  EXPECT_TRUE(result().contains("could not keep them")) << result().toStdString();
  EXPECT_FALSE(isDone());
  link.show(seen());
  hands.click("restoreCompass");
  tell(take());
  EXPECT_TRUE(result().startsWith("The vehicle has its old values back")) << result().toStdString();
  EXPECT_FALSE(isDone());
}

TEST_F(WizardsCompass, isDoneWhenTheVehicleHadTheRightValuesAlready) {
  turn({10'000, 0, 10'000, 0, 0, 10'000});
  EXPECT_TRUE(result().startsWith("The values in the vehicle are right")) << result().toStdString();
  EXPECT_TRUE(isDone());
}

TEST_F(WizardsCompass, isOpenAgainWhenOnlyAPartWasWritten) {
  hands.click("compassRight");
  EXPECT_TRUE(isDone());
  turn(kFactory);
  EXPECT_TRUE(isDone()) << "the person's word stands as long as nothing is changed";
  hands.click("writeSurvey");
  take(3);
  link.answer(wire::Outcome::Failed, 0);
  EXPECT_EQ(hands.at<Notice>("surveyResult").tone(), Notice::Tone::Error);
  EXPECT_FALSE(isDone());
}

TEST_F(WizardsCompass, keepsTheWizardOpenUntilAllIsWrittenAndReadBack) {
  turn(kFactory);
  hands.click("writeSurvey");
  take(3);
  const auto escape = [this] { QTest::keyClick(&wizard, Qt::Key_Escape); };
  for (const auto& way : std::vector<std::function<void()>>{
           escape, [this] { wizard.close(); },
           [this] { QTest::mouseClick(&hands.button(QWizard::CancelButton), Qt::LeftButton); },
           [this] { wizard.accept(); }}) {
    EXPECT_TRUE(refusalOf(way).startsWith("The values of the compass are being written"));
    EXPECT_TRUE(wizard.isVisible());
    EXPECT_TRUE(wizard.vehicle()) << "the site keeps the vehicle";
  }
  Values found{};
  for (std::size_t n = 3; n < found.size(); ++n)
    link.answer(wire::Outcome::Done, link.last<supervisor::Ask>().request.value);
  EXPECT_FALSE(refusalOf(escape).isEmpty()) << "not read back yet";
  link.tell([] {
    supervisor::Event silent;
    silent.kind = supervisor::EventKind::OrderRefused;
    silent.vehicle = VehicleId{1};
    silent.sentence = "The vehicle does not answer.";
    return silent;
  }());
  EXPECT_EQ(refusalOf(escape), QString{}) << "nothing is under way any more";
  EXPECT_FALSE(wizard.isVisible());
}

TEST_F(WizardsCompass, staysOpenOnAnyPageAndDoesNotGoOnToTheReadersMeanwhile) {
  hands.click("compassRight");
  turn(kFactory);
  hands.click("writeSurvey");
  hands.next();
  hands.skip();
  hands.skip();
  ASSERT_EQ(wizard.currentId(), CommissionWizard::kSummary);
  EXPECT_FALSE(refusalOf([this] { hands.click("calibrateNext"); }).isEmpty());
  EXPECT_TRUE(wizard.isVisible());
  EXPECT_FALSE(wizard.goesOnCalibrating());
  tell(take());
  EXPECT_EQ(refusalOf([this] { hands.click("calibrateNext"); }), QString{});
  EXPECT_FALSE(wizard.isVisible());
  EXPECT_TRUE(wizard.goesOnCalibrating());
}

}  // namespace
}  // namespace tessera::ui
