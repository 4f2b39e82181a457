// The drivers against registers that are plain memory: what they write, and that they give up when nothing happens.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "firmware/boards/lm3s6965/clock.h"
#include "firmware/boards/lm3s6965/i2c_master.h"
#include "firmware/boards/lm3s6965/motor_pwm.h"
#include "firmware/boards/lm3s6965/uart.h"
#include "firmware/boards/lm3s6965/watchdog.h"

namespace tessera::firmware::lm3s6965 {
namespace {

TEST(Clock, runsFiftyMegahertzFromThePllOnceItHasLocked) {
  SystemControlRegisters control{};
  control.RCC = 0x078E3AC0;  // after reset
  control.RIS = 1U << 6;
  EXPECT_TRUE(startClock(control));
  EXPECT_EQ(control.RCC >> 23 & 0xFU, 3U) << "200 MHz by four";
  EXPECT_NE(control.RCC & 1U << 22, 0U) << "the divider is used";
  EXPECT_EQ(control.RCC >> 6 & 0xFU, 0xEU) << "8 MHz crystal";
  EXPECT_EQ(control.RCC & (1U << 0 | 3U << 4 | 1U << 11 | 1U << 13), 0U) << "main oscillator, powered, not bypassed";
}

TEST(Clock, givesUpOnAPllThatNeverLocksAndStaysBypassed) {
  SystemControlRegisters control{};
  control.RCC = 0x078E3AC0;
  EXPECT_FALSE(startClock(control));
  EXPECT_NE(control.RCC & 1U << 11, 0U);
}

TEST(Clock, raisesTheCoreVoltageOnRevisionA2Only) {
  SystemControlRegisters control{};
  control.RIS = 1U << 6;
  control.DID0 = 0x10010002;
  EXPECT_TRUE(startClock(control));
  EXPECT_EQ(control.LDOPCTL, 0x1BU);
  SystemControlRegisters later{};
  later.RIS = 1U << 6;
  later.DID0 = 0x10010003;
  EXPECT_TRUE(startClock(later));
  EXPECT_EQ(later.LDOPCTL, 0U);
}

TEST(Uart, divisorsAreTheDataSheets) {
  // 50 MHz / (16 * 115200) = 27 + 8/64 (rounded), 50 MHz / (16 * 9600) = 325 + 33/64.
  EXPECT_EQ(uartDivisor(50'000'000, 115200), 27U * 64 + 8);
  EXPECT_EQ(uartDivisor(50'000'000, 9600), 325U * 64 + 33);
  for (std::uint32_t baud : {1200U, 2400U, 4800U, 9600U, 19200U, 38400U, 57600U, 115200U}) {
    const double real = 50e6 * 4.0 / uartDivisor(50'000'000, baud);
    EXPECT_NEAR(real / baud, 1.0, 0.0005) << baud;
  }
}

TEST(Uart, setsUpTheLineAndListens) {
  UartRegisters registers{};
  UartPort port{registers};
  port.setBaud(9600);
  EXPECT_EQ(registers.IBRD, 325U);
  EXPECT_EQ(registers.FBRD, 33U);
  EXPECT_EQ(registers.LCRH, 0x70U);
  EXPECT_EQ(registers.CTL, 0x301U);
  EXPECT_EQ(registers.IM, 1U << 4 | 1U << 6);
}

TEST(Uart, keepsWhatTheHardwareDoesNotTakeYetAndAsksToBeCalled) {
  constexpr std::uint32_t kTxFull = 1U << 5, kRxEmpty = 1U << 4, kTransmit = 1U << 5;
  UartRegisters registers{};
  UartPort port{registers};
  port.setBaud(9600);
  registers.FR = kTxFull | kRxEmpty;
  const std::vector<std::uint8_t> data(300, 0x55);
  EXPECT_EQ(port.write(data), 256U) << "as many as the queue holds";
  EXPECT_FALSE(port.sent());
  EXPECT_NE(registers.IM & kTransmit, 0U);
  registers.FR = kRxEmpty;
  registers.MIS = kTransmit;
  port.onInterrupt();
  EXPECT_TRUE(port.sent());
  EXPECT_EQ(registers.DR, 0x55U);
  EXPECT_EQ(registers.IM & kTransmit, 0U) << "no interrupt without something to send";
  registers.FR = kRxEmpty | 1U << 3;
  EXPECT_FALSE(port.sent()) << "the last byte is still on the line";
}

TEST(Uart, writingToAnIdlePortNeedsNoInterrupt) {
  UartRegisters registers{};
  UartPort port{registers};
  port.setBaud(9600);
  registers.FR = 1U << 4;
  const std::array<std::uint8_t, 2> data = {1, 2};
  EXPECT_EQ(port.write(data), 2U);
  EXPECT_EQ(registers.DR, 2U);
  EXPECT_EQ(registers.IM & 1U << 5, 0U);
}

class MotorPwmTest : public ::testing::Test {
protected:
  std::unique_ptr<PwmRegisters> pwm_ = std::make_unique<PwmRegisters>();
  std::unique_ptr<GpioRegisters> port_ = std::make_unique<GpioRegisters>();
  MotorPwm motors_{*pwm_, *port_, 0x10, 0x20};
};

TEST_F(MotorPwmTest, startsAtTwentyKilohertzWithBothMotorsOff) {
  EXPECT_EQ(pwm_->GENERATOR[1].LOAD, 2499U);
  EXPECT_EQ(pwm_->GENERATOR[1].GENA, 0x8CU);
  EXPECT_EQ(pwm_->GENERATOR[1].GENB, 0x80CU);
  EXPECT_EQ(pwm_->ENABLE, 0U);
}

TEST_F(MotorPwmTest, drivesEachMotorOnItsOwn) {
  motors_.drive(Wheel::Left, 500);
  EXPECT_EQ(pwm_->GENERATOR[1].CMPA, 1249U);
  EXPECT_EQ(pwm_->ENABLE, 4U);
  motors_.drive(Wheel::Right, -250);
  EXPECT_EQ(pwm_->GENERATOR[1].CMPB, 1874U);
  EXPECT_EQ(pwm_->ENABLE, 12U);
  EXPECT_EQ(port_->DATA[0x20], 0x20U);
  EXPECT_EQ(port_->DATA[0x10], 0U);
  motors_.drive(Wheel::Left, 0);
  EXPECT_EQ(pwm_->ENABLE, 8U);
  motors_.drive(Wheel::Right, 250);
  EXPECT_EQ(port_->DATA[0x20], 0U);
}

TEST_F(MotorPwmTest, writesOnlyWhatChanges) {
  motors_.drive(Wheel::Left, 500);
  pwm_->GENERATOR[1].CMPA = 7777;  // a trap: would be overwritten
  pwm_->ENABLE = 7777;
  port_->DATA[0x10] = 7777;
  motors_.drive(Wheel::Left, 500);
  EXPECT_EQ(pwm_->GENERATOR[1].CMPA, 7777U);
  EXPECT_EQ(pwm_->ENABLE, 7777U);
  EXPECT_EQ(port_->DATA[0x10], 7777U);
}

TEST_F(MotorPwmTest, holdsDutyToItsRange) {
  motors_.drive(Wheel::Left, 32767);
  EXPECT_EQ(pwm_->GENERATOR[1].CMPA, 0U);
  motors_.drive(Wheel::Right, -32768);
  EXPECT_EQ(pwm_->GENERATOR[1].CMPB, 0U);
  EXPECT_EQ(port_->DATA[0x20], 0x20U);
}

TEST(MotorPwmScale, isHighForTheShareOfThePeriodThatIsAsked) {
  EXPECT_EQ(highClocks(0), 0U);
  EXPECT_EQ(highClocks(1), 2U);
  EXPECT_EQ(highClocks(1000), 2500U);
  EXPECT_EQ(highClocks(5000), 2500U);
  EXPECT_EQ(compareFor(0), 2499U);
  EXPECT_EQ(compareFor(2499), 0U);
  EXPECT_EQ(compareFor(2500), 0U);
}

TEST(I2c, runsJustBelowFourHundredKilohertz) {
  I2cRegisters registers{};
  const I2cMaster bus{registers};
  EXPECT_EQ(registers.MTPR, 6U) << "50 MHz / (20 * 7) is 357 kHz";
  EXPECT_EQ(registers.MCR, 0x10U);
}

TEST(I2c, givesUpOnAControllerThatStaysBusy) {
  // Memory reads back the command as status: RUN stands where BUSY does, so that the transfer never ends.
  I2cRegisters registers{};
  I2cMaster bus{registers};
  const std::array<std::uint8_t, 2> data = {1, 2};
  std::array<std::uint8_t, 2> in{};
  EXPECT_FALSE(bus.write(0x1E, data));
  EXPECT_EQ(registers.MSA, 0x3CU);
  EXPECT_EQ(registers.MCS, 3U) << "START and RUN, and nothing after them";
  EXPECT_FALSE(bus.read(0x1E, in));
  EXPECT_EQ(registers.MSA, 0x3DU);
}

TEST(I2c, doesNotBeginOnABusThatSomebodyElseHolds) {
  I2cRegisters registers{};
  I2cMaster bus{registers};
  registers.MCS = 1U << 6;
  const std::array<std::uint8_t, 1> data = {1};
  EXPECT_FALSE(bus.write(0x1E, data));
  EXPECT_EQ(registers.MCS, 1U << 6) << "no command was given";
}

TEST(I2c, refusesATransferOfNothing) {
  I2cRegisters registers{};
  I2cMaster bus{registers};
  EXPECT_FALSE(bus.write(0x1E, {}));
  EXPECT_FALSE(bus.read(0x1E, {}));
}

TEST(Watchdog, locksItselfAfterEachWrite) {
  auto registers = std::make_unique<WatchdogRegisters>();
  Watchdog dog{*registers};
  dog.start();
  EXPECT_EQ(registers->LOAD, 15'000'000U);
  EXPECT_EQ(registers->CTL, 3U);
  EXPECT_EQ(registers->LOCK, 0U);
  dog.feed();
  EXPECT_EQ(registers->ICR, 1U);
  EXPECT_EQ(registers->LOCK, 0U);
}

}  // namespace
}  // namespace tessera::firmware::lm3s6965
