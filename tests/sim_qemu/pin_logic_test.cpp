#include "sim/qemu/pin_logic.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace tessera::sim {
namespace {

MotorOutputs running() {
  MotorOutputs motors;
  motors.write({0x090, 2499});
  motors.write({0x080, 1});
  return motors;
}

TEST(MotorOutputs, turnRegistersIntoSignedDuty) {
  MotorOutputs motors = running();
  motors.write({0x098, 1249});
  motors.write({0x09C, 1874});
  motors.write({0x008, 0xC});
  motors.setBackwards(1, true);
  EXPECT_EQ(motors.duty(0), 500);
  EXPECT_EQ(motors.duty(1), -250);
}

TEST(MotorOutputs, showFullDutyAlthoughTheOutputIsLowForOneClock) {
  MotorOutputs motors = running();
  motors.write({0x098, 0});
  motors.write({0x008, 0x4});
  EXPECT_EQ(motors.duty(0), 1000);
}

TEST(MotorOutputs, areOffWhileDisabledStoppedOrReset) {
  MotorOutputs motors = running();
  motors.write({0x098, 1249});
  EXPECT_EQ(motors.duty(0), 0);
  motors.write({0x008, 0x8});
  EXPECT_EQ(motors.duty(0), 0);
  motors.write({0x008, 0x4});
  EXPECT_EQ(motors.duty(0), 500);
  motors.write({0x080, 0});
  EXPECT_EQ(motors.duty(0), 0);
  motors.write({0x080, 1});
  motors.reset();
  EXPECT_EQ(motors.duty(0), 0);
}

TEST(EncoderLevels, changeOneChannelPerCountAlsoBelowZero) {
  for (std::int64_t count = -9; count < 9; ++count)
    EXPECT_EQ(std::popcount(encoderLevels(count) ^ encoderLevels(count + 1)), 1) << count;
  EXPECT_EQ(encoderLevels(-4), encoderLevels(4));
}

TEST(EchoSource, answersATriggerWithAPulseAsLongAsTheWayOfSound) {
  EchoSource echo;
  echo.triggerFell(Seconds{1.0}, Metres{1.0});
  ASSERT_TRUE(echo.nextEdge());
  EXPECT_DOUBLE_EQ(echo.nextEdge()->value(), 1.00045);
  EXPECT_TRUE(echo.nextLevel());
  echo.changed(Seconds{1.0006});
  EXPECT_TRUE(echo.high());
  EXPECT_DOUBLE_EQ(echo.nextEdge()->value(), 1.0006 + 0.0058);
  echo.changed(Seconds{1.0064});
  EXPECT_FALSE(echo.high());
  EXPECT_FALSE(echo.nextEdge());
}

TEST(EchoSource, endsItsPulseByItselfWithoutAnObstacleInReach) {
  for (double range : {0.0, -1.0, 4.01}) {
    EchoSource echo;
    echo.triggerFell(Seconds{1.0}, Metres{range});
    ASSERT_TRUE(echo.nextEdge()) << range;
    echo.changed(*echo.nextEdge());
    EXPECT_DOUBLE_EQ(echo.nextEdge()->value(), 1.00045 + 0.038) << range;
  }
}

TEST(EchoSource, staysSilentWhenItIsDead) {
  EchoSource echo;
  echo.triggerFell(Seconds{1.0}, Metres{std::numeric_limits<double>::quiet_NaN()});
  EXPECT_FALSE(echo.nextEdge());
}

TEST(EchoSource, ignoresATriggerDuringAnEcho) {
  EchoSource echo;
  echo.triggerFell(Seconds{1.0}, Metres{1.0});
  echo.changed(Seconds{1.001});
  const auto fall = echo.nextEdge();
  echo.triggerFell(Seconds{1.002}, Metres{3.0});
  EXPECT_EQ(echo.nextEdge(), fall);
}

}  // namespace
}  // namespace tessera::sim
