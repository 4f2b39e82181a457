// The compass calibrated by mouse, with a simulated vehicle that runs the firmware's own sources.
#include "ui/calibrate/compass_panel.h"

#include <gtest/gtest.h>

#include <QTest>

#include "firmware/vehicle/compass.h"
#include "tests/sim/test_floor.h"
#include "tests/ui/calibrate/bench_fleet.h"
#include "tests/ui/connect/look.h"

namespace tessera::ui {
namespace {

sim::BodyParameters ironBody() {
  sim::BodyParameters body = sim::bodyParametersFor(sim::testVehicle());
  body.compass.hardIron = 35.0;
  body.compass.softIron = 0.15;
  body.compass.bias = Radians{};  // a chip mounted askew cannot be told from the field alone
  return body;
}

class CompassByTurning : public testing::Test {
protected:
  void SetUp() override {
    floor::Site site = sim::testSite(4);
    site.vehicles = {sim::testVehicle()};
    document.replace(floor::SiteMap::build(std::move(site)).value(), {});
    panel.resize(900, 330);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    selection.setVehicle(VehicleId{7});
    ASSERT_TRUE(QTest::qWaitFor([&] { return button("turnForSurvey").isEnabled(); }));
  }
  QPushButton& button(const char* name) { return *panel.findChild<QPushButton*>(QString::fromLatin1(name)); }
  void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
  bool done() {
    return QTest::qWaitFor([&] { return !work.isBusy(); }, 60'000);
  }
  /// Largest error over all headings that the settings kept in the EEPROM leave, degrees.
  double worstError() {
    const firmware::CompassCorrection correction = firmware::correctionFrom(fleet.kept());
    sim::CompassParameters still = ironBody().compass;
    still.noise = 0.0;
    sim::CompassField field{still, {}, {}, sim::RandomStream{1, "compass", 7}};
    double worst = 0.0;
    for (double heading = -3.1; heading < 3.1; heading += 0.05) {
      const auto raw = field.measure({{}, Radians{heading}});
      const auto c = correction.apply({static_cast<float>(raw[0]), static_cast<float>(raw[1])});
      const double bearing = std::atan2(double{c.y}, double{c.x});
      const double truth = kPi / 2.0 - heading;
      worst = std::max(worst, std::abs(std::remainder(bearing - truth, 2.0 * kPi)));
    }
    return worst * 180.0 / kPi;
  }

  BenchFleet fleet{sim::testVehicle(), ironBody()};
  Selection selection;
  SiteDocument document;
  CompassSurvey work{fleet};
  CompassPanel panel{work, fleet, selection, document};
};

TEST_F(CompassByTurning, showsTheEllipseWritesWhatCorrectsItAndBringsTheOldValuesBack) {
  const firmware::Settings before = fleet.kept();
  EXPECT_GT(worstError(), 30.0);
  click("turnForSurvey");
  EXPECT_EQ(button("turnForSurvey").text(), "Stop");
  ASSERT_TRUE(QTest::qWaitFor([&] { return work.points().size() > 12; }, 60'000));
  EXPECT_EQ(work.phase(), CompassSurvey::Phase::Turning) << "the chart grows while it turns";
  look::take(panel, "compass-turning");
  ASSERT_TRUE(done());
  EXPECT_EQ(work.points().size(), 64U);
  EXPECT_EQ(work.tone(), Notice::Tone::Warning) << work.message().toStdString();
  ASSERT_TRUE(work.fit());
  EXPECT_FALSE(work.fit()->objection());
  EXPECT_EQ(work.fit()->missing(), 0);
  EXPECT_EQ(fleet.kept(), before) << "nothing is written before it was looked at";
  for (const bool dark : {false, true}) {
    look::setDark(dark);
    look::take(panel, dark ? "compass-dark" : "compass-light");
  }
  look::setDark(false);
  ASSERT_TRUE(button("writeSurvey").isEnabled());
  EXPECT_FALSE(button("restoreCompass").isEnabled());
  click("writeSurvey");
  ASSERT_TRUE(done());
  EXPECT_EQ(work.tone(), Notice::Tone::Good) << work.message().toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return worstError() < 2.0; })) << worstError() << ", in the EEPROM";
  EXPECT_FALSE(button("writeSurvey").isEnabled()) << "they stand there";
  EXPECT_EQ(work.isRight(), true);

  click("turnForSurvey");
  ASSERT_TRUE(done());
  EXPECT_TRUE(work.message().startsWith("The values in the vehicle are right")) << work.message().toStdString();
  EXPECT_EQ(work.isRight(), true);

  click("restoreCompass");
  ASSERT_TRUE(done());
  EXPECT_TRUE(work.message().startsWith("The vehicle has its old values back")) << work.message().toStdString();
  EXPECT_EQ(work.isRight(), false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return fleet.kept() == before; }));
}

TEST_F(CompassByTurning, stopsTheVehicleWhenToldAndWhenItIsNoLongerLookedAt) {
  for (const bool byButton : {true, false}) {
    click("turnForSurvey");
    ASSERT_TRUE(QTest::qWaitFor([&] { return work.points().size() > 3; }, 60'000));
    EXPECT_GT(std::abs(fleet.body->turnRate().value()), 0.3);
    if (byButton)
      click("turnForSurvey");
    else
      panel.hide();
    EXPECT_FALSE(work.isBusy());
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(fleet.body->turnRate().value()) < 0.01; }));
    EXPECT_FALSE(button("writeSurvey").isEnabled());
    EXPECT_TRUE(work.message().startsWith("Stopped.")) << work.message().toStdString();
  }
}

TEST_F(CompassByTurning, refusesATurnThatWasCutShortWithASentence) {
  click("turnForSurvey");
  ASSERT_TRUE(QTest::qWaitFor([&] { return work.points().size() > 20; }, 60'000));
  // By somebody else, so that what is there does not go around.
  fleet.post(supervisor::Stop{VehicleId{7}});
  ASSERT_TRUE(done());
  EXPECT_EQ(work.tone(), Notice::Tone::Error);
  EXPECT_TRUE(work.message().contains("did not turn all around")) << work.message().toStdString();
  EXPECT_FALSE(button("writeSurvey").isEnabled());
  look::take(panel, "compass-refused");
}

TEST_F(CompassByTurning, saysThatAnOlderVehicleCannotTell) {
  fleet.old = true;
  click("turnForSurvey");
  ASSERT_TRUE(done());
  EXPECT_EQ(work.tone(), Notice::Tone::Error);
  EXPECT_TRUE(work.message().contains("too old")) << work.message().toStdString();
  EXPECT_EQ(fleet.body->turnRate().value(), 0.0);
}

TEST_F(CompassByTurning, showsNoChartOfAnotherVehicle) {
  click("turnForSurvey");
  ASSERT_TRUE(done());
  EXPECT_TRUE(button("writeSurvey").isEnabled());
  selection.setVehicle(std::nullopt);
  EXPECT_FALSE(button("writeSurvey").isEnabled());
  EXPECT_FALSE(panel.findChild<Notice*>("surveyResult")->isVisible());
}

}  // namespace
}  // namespace tessera::ui
