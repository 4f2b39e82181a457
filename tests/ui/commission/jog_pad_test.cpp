// Driving by hand: what is held drives, what is let go stops, whatever the reason.
#include "ui/commission/jog_pad.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>
#include <QVBoxLayout>

#include "tests/ui/commission/fake_link.h"

namespace tessera::ui {
namespace {

using supervisor::Jog;
using supervisor::Stop;

class JogPadTest : public testing::Test {
protected:
  void SetUp() override {
    auto* column = new QVBoxLayout{&window};
    column->addWidget(&pad);
    column->addWidget(&other);
    link.show(seenVehicles({1, 2}));
    selection.setVehicle(VehicleId{1});
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    pad.setFocus();
  }
  QToolButton& button(const char* name) { return *pad.findChild<QToolButton*>(QLatin1String{name}); }
  QString hint() { return pad.findChild<QLabel*>("jogHint")->text(); }
  void expectOneStopAndSilence(std::uint8_t vehicle = 1) {
    EXPECT_EQ(link.count<Stop>(), 1U);
    EXPECT_EQ(link.last<Stop>().vehicle, VehicleId{vehicle});
    const std::size_t orders = link.orders.size();
    QTest::qWait(250);  // two of its repetitions
    EXPECT_EQ(link.orders.size(), orders);
    EXPECT_FALSE(pad.isHeld());
  }

  FakeLink link;
  Selection selection;
  QWidget window;
  JogPad pad{link, selection};
  QLineEdit other;
};

TEST_F(JogPadTest, AHeldKeyDrivesAgainAndAgainUntilItIsLetGo) {
  QTest::keyPress(&pad, Qt::Key_Up);
  EXPECT_EQ(link.count<Jog>(), 1U);
  EXPECT_TRUE(QTest::qWaitFor([&] { return link.count<Jog>() >= 3; }));
  EXPECT_EQ(link.last<Jog>().vehicle, VehicleId{1});
  EXPECT_DOUBLE_EQ(link.last<Jog>().speed.value(), 0.05);
  EXPECT_DOUBLE_EQ(link.last<Jog>().turnRate.value(), 0.0);
  QTest::keyRelease(&pad, Qt::Key_Up);
  expectOneStopAndSilence();
}

TEST_F(JogPadTest, TheKeyboardsOwnRepetitionIsNoLettingGo) {
  QTest::keyPress(&pad, Qt::Key_Down);
  for (int i = 0; i < 5; ++i) {
    QKeyEvent up{QEvent::KeyRelease, Qt::Key_Down, Qt::NoModifier, {}, true};
    QKeyEvent down{QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier, {}, true};
    QApplication::sendEvent(&pad, &up);
    QApplication::sendEvent(&pad, &down);
  }
  EXPECT_EQ(link.count<Stop>(), 0U);
  EXPECT_EQ(link.count<Jog>(), 1U);
  EXPECT_LT(link.last<Jog>().speed.value(), 0.0);
  QTest::keyRelease(&pad, Qt::Key_Down);
  EXPECT_EQ(link.count<Stop>(), 1U);
}

TEST_F(JogPadTest, TwoArrowsTogetherDriveACurveAndOppositeOnesStand) {
  QTest::keyPress(&pad, Qt::Key_Up);
  QTest::keyPress(&pad, Qt::Key_Left);
  EXPECT_GT(link.last<Jog>().speed.value(), 0.0);
  EXPECT_GT(link.last<Jog>().turnRate.value(), 0.0);
  QTest::keyRelease(&pad, Qt::Key_Up);
  EXPECT_DOUBLE_EQ(link.last<Jog>().speed.value(), 0.0);
  EXPECT_GT(link.last<Jog>().turnRate.value(), 0.0);
  QTest::keyPress(&pad, Qt::Key_Right);
  EXPECT_DOUBLE_EQ(link.last<Jog>().turnRate.value(), 0.0);
  QTest::keyRelease(&pad, Qt::Key_Left);
  EXPECT_LT(link.last<Jog>().turnRate.value(), 0.0);
  QTest::keyRelease(&pad, Qt::Key_Right);
  EXPECT_EQ(link.count<Stop>(), 1U);
}

TEST_F(JogPadTest, LosingTheKeyboardStops) {
  QTest::keyPress(&pad, Qt::Key_Up);
  other.setFocus();
  expectOneStopAndSilence();
  QTest::keyRelease(&pad, Qt::Key_Up);
  EXPECT_EQ(link.count<Stop>(), 1U);
}

TEST_F(JogPadTest, AnotherWindowStops) {
  QTest::keyPress(&pad, Qt::Key_Up);
  QWidget elsewhere;
  elsewhere.show();
  elsewhere.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&elsewhere));
  expectOneStopAndSilence();
}

TEST_F(JogPadTest, HidingOrDisablingStops) {
  QTest::keyPress(&pad, Qt::Key_Up);
  pad.setEnabled(false);
  expectOneStopAndSilence();
}

TEST_F(JogPadTest, AButtonHeldByTheMouseDrivesUntilItIsReleased) {
  QTest::mousePress(&button("jogLeft"), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return link.count<Jog>() >= 2; }));
  EXPECT_GT(link.last<Jog>().turnRate.value(), 0.0);
  QTest::mouseRelease(&button("jogLeft"), Qt::LeftButton);
  expectOneStopAndSilence();
}

TEST_F(JogPadTest, AnotherWindowStopsTheMouseToo) {
  QTest::mousePress(&button("jogForward"), Qt::LeftButton);
  QWidget elsewhere;
  elsewhere.show();
  elsewhere.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&elsewhere));
  expectOneStopAndSilence();
  QTest::mouseRelease(&button("jogForward"), Qt::LeftButton);
  EXPECT_EQ(link.count<Stop>(), 1U);
}

TEST_F(JogPadTest, AnotherChosenVehicleStopsTheOneThatDrives) {
  QTest::keyPress(&pad, Qt::Key_Up);
  selection.setVehicle(VehicleId{2});
  expectOneStopAndSilence(1);
}

TEST_F(JogPadTest, AfterAStopTheNextPressWaitsUntilItWillBeTaken) {
  QTest::keyClick(&pad, Qt::Key_Up);
  ASSERT_EQ(link.count<Stop>(), 1U);
  const std::size_t before = link.count<Jog>();
  QTest::keyPress(&pad, Qt::Key_Up);
  EXPECT_EQ(link.count<Jog>(), before);
  EXPECT_TRUE(QTest::qWaitFor([&] { return link.count<Jog>() > before; }));
  QTest::keyRelease(&pad, Qt::Key_Up);
  EXPECT_EQ(link.count<Stop>(), 2U);
}

TEST_F(JogPadTest, TheSliderSetsTheSpeed) {
  auto* slider = pad.findChild<QSlider*>("jogSpeed");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_End);
  pad.setFocus();
  QTest::keyPress(&pad, Qt::Key_Up);
  EXPECT_DOUBLE_EQ(link.last<Jog>().speed.value(), 0.15);
  QTest::keyRelease(&pad, Qt::Key_Up);
}

TEST_F(JogPadTest, SaysWhyNothingCanBeDriven) {
  selection.setVehicle(std::nullopt);
  EXPECT_FALSE(button("jogForward").isEnabled());
  const QString choose = hint();
  link.vanish();
  EXPECT_NE(hint(), choose);
  QTest::keyClick(&pad, Qt::Key_Up);
  EXPECT_TRUE(link.orders.empty());
}

TEST_F(JogPadTest, AVehicleThatFallsSilentIsLetGo) {
  QTest::keyPress(&pad, Qt::Key_Up);
  auto silent = seenVehicles({1});
  silent.vehicles.front().contact = supervisor::Contact::Silent;
  link.show(silent);
  expectOneStopAndSilence();
  EXPECT_TRUE(hint().contains("AGV 1"));
}

TEST_F(JogPadTest, AVehicleWithARouteIsNotDrivenByHand) {
  auto busy = seenVehicles({1});
  busy.vehicles.front().task = supervisor::Task::Running;
  link.show(busy);
  QTest::keyClick(&pad, Qt::Key_Up);
  EXPECT_TRUE(link.orders.empty());
}

TEST_F(JogPadTest, AnOrderThatIsNotTakenEndsTheHolding) {
  link.takes = false;
  QTest::keyPress(&pad, Qt::Key_Up);
  EXPECT_FALSE(pad.isHeld());
}

}  // namespace
}  // namespace tessera::ui
