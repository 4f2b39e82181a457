#include "firmware/boards/host/host_board.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "sim/blank_eeprom.h"

namespace tessera::firmware {
namespace {

TEST(HostBoard, sendsAtThePaceOfItsBaud) {
  HostBoard board{blank()};
  board.setBaud(Uart::Radio, 9600);  // 1.04 ms a byte
  const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 5};
  EXPECT_EQ(board.write(Uart::Radio, bytes), 5U);
  board.advanceTo(1000);
  EXPECT_TRUE(board.takeSent(Uart::Radio).empty());
  board.advanceTo(2090);
  EXPECT_EQ(board.takeSent(Uart::Radio), (std::vector<std::uint8_t>{1, 2}));
  EXPECT_FALSE(board.sent(Uart::Radio));
  board.advanceTo(5210);
  EXPECT_TRUE(board.sent(Uart::Radio));
  EXPECT_EQ(board.takeSent(Uart::Radio), (std::vector<std::uint8_t>{3, 4, 5}));
}

TEST(HostBoard, takesNoMoreThanItsBufferHolds) {
  HostBoard board{blank()};
  const std::vector<std::uint8_t> bytes(300, 9);
  EXPECT_EQ(board.write(Uart::Readers, bytes), 256U);
}

TEST(HostBoard, keepsWhatHasLeftAndDropsWhatHasNotWhenTheBaudChanges) {
  HostBoard board{blank()};
  board.setBaud(Uart::Radio, 9600);
  const std::vector<std::uint8_t> bytes{1, 2, 3};
  board.write(Uart::Radio, bytes);
  board.advanceTo(1500);
  board.setBaud(Uart::Radio, 115200);
  board.advanceTo(9000);
  EXPECT_EQ(board.takeSent(Uart::Radio), (std::vector<std::uint8_t>{1}));
}

TEST(HostBoard, receivesAPacedWireAtOnceAndPacesOneThatIsNot) {
  HostBoard board{blank()};
  board.setBaud(Uart::Readers, 38400);  // 0.26 ms a byte
  std::vector<std::uint8_t> out(8);
  board.advanceTo(10'000);
  board.receive(Uart::Readers, std::vector<std::uint8_t>{1});
  EXPECT_EQ(board.read(Uart::Readers, out), 1U);
  board.receive(Uart::Readers, std::vector<std::uint8_t>{2, 3, 4});
  EXPECT_LE(board.read(Uart::Readers, out), 1U);
  board.advanceTo(11'000);
  EXPECT_GE(board.read(Uart::Readers, out), 2U);
}

TEST(HostBoard, answersAPingWithTheEchosLengthWhenItHasCome) {
  HostBoard board{blank()};
  HostInputs inputs;
  inputs.range = {1.0, 0.0};
  board.setInputs(inputs);
  board.ping(0);
  board.ping(1);
  board.advanceTo(6000);
  EXPECT_EQ(board.echo(0), 0U);
  board.advanceTo(6300);
  EXPECT_EQ(board.echo(0), 5800U);
  board.advanceTo(38'400);
  EXPECT_EQ(board.echo(1), 0U);
  board.advanceTo(38'500);
  EXPECT_EQ(board.echo(1), 38'000U) << "nothing in reach";
}

TEST(HostBoard, givesNoPulseFromADeadRanger) {
  HostBoard board{blank()};
  HostInputs inputs;
  inputs.range = {std::numeric_limits<double>::quiet_NaN(), 1.0};
  board.setInputs(inputs);
  board.ping(0);
  board.ping(1);
  board.advanceTo(100'000);
  EXPECT_EQ(board.echo(0), 0U);
  EXPECT_EQ(board.echo(1), 5800U);
}

TEST(HostBoard, spendsTimeOnTheI2cBusSoThatWaitingForTheEepromEnds) {
  HostBoard board{blank()};
  const std::vector<std::uint8_t> data{0, 0, 42};
  ASSERT_TRUE(board.i2cWrite(EepromChip::kAddress, data));
  const std::uint64_t before = board.now();
  while (!board.i2cWrite(EepromChip::kAddress, std::vector<std::uint8_t>{0, 0})) ASSERT_LT(board.now(), 20'000U);
  EXPECT_NEAR(static_cast<double>(board.now() - before), 5000.0, 200.0);
  std::vector<std::uint8_t> out(1);
  ASSERT_TRUE(board.i2cRead(EepromChip::kAddress, out));
  EXPECT_EQ(out[0], 42);
  EXPECT_FALSE(board.i2cWrite(0x33, data));
}

TEST(HostBoard, wantsARestartWhenTheWatchdogIsNotFed) {
  HostBoard board{blank()};
  board.advanceTo(400'000);
  board.feedWatchdog();
  board.advanceTo(899'000);
  EXPECT_FALSE(board.restartDue());
  board.advanceTo(901'000);
  EXPECT_TRUE(board.restartDue());
  EXPECT_EQ(board.nextCause(), wire::ResetCause::Watchdog);
  board.powerOn(901'000, board.nextCause());
  EXPECT_FALSE(board.restartDue());
  EXPECT_EQ(board.resetCause(), wire::ResetCause::Watchdog);
}

TEST(HostBoard, letsAFirmwareThatHasAskedForARestartTouchNothingMore) {
  HostBoard board{blank()};
  board.drive(Wheel::Left, 300);
  board.restart();
  board.drive(Wheel::Left, 900);
  board.write(Uart::Radio, std::vector<std::uint8_t>{1});
  board.advanceTo(10'000);
  EXPECT_TRUE(board.takeSent(Uart::Radio).empty());
  EXPECT_EQ(board.nextCause(), wire::ResetCause::Software);
  EXPECT_EQ(board.duty()[0], 300);
  board.powerOn(10'000, board.nextCause());
  EXPECT_EQ(board.duty()[0], 0);
}

TEST(HostBoard, countsTheWheelsFromItsStart) {
  HostBoard board{blank()};
  HostInputs inputs;
  inputs.encoderCounts = {1000, -5};
  board.setInputs(inputs);
  board.powerOn(0, wire::ResetCause::PowerOn);
  inputs.encoderCounts = {1007, -9};
  board.setInputs(inputs);
  EXPECT_EQ(board.counts(Wheel::Left), 7);
  EXPECT_EQ(board.counts(Wheel::Right), -4);
}

}  // namespace
}  // namespace tessera::firmware
