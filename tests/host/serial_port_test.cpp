#include "host/serial_port.h"

#include <gtest/gtest.h>

#include <QCoreApplication>

#include "host/pty_radio.h"
#include "host/until.h"

namespace tessera::host {
namespace {

using namespace std::chrono_literals;

using test::until;

class SerialPortTest : public ::testing::Test {
protected:
  SerialPortTest() : radio{{}}, port{QString::fromStdString(radio.name()), 115200, {20ms, 50ms}} {
    QObject::connect(&port, &SerialPort::opened, [this] { ++opened; });
    QObject::connect(&port, &SerialPort::lost, [this](const Sentence& why) {
      ++lost;
      reason = why.english();
    });
  }
  test::PtyRadio radio;
  SerialPort port;
  int opened = 0;
  int lost = 0;
  std::string reason;
};

TEST_F(SerialPortTest, opensAPty) {
  radio.put();
  port.open();
  EXPECT_EQ(opened, 1);
  EXPECT_TRUE(port.isOpen());
}

TEST_F(SerialPortTest, tellsALossOnceAndOpensAgainByItself) {
  radio.put();
  port.open();
  for (int round = 1; round <= 3; ++round) {
    radio.pull();
    ASSERT_TRUE(until([&] { return lost == round; }));
    until([] { return false; }, 0.2);
    EXPECT_EQ(lost, round) << "one word for one loss";
    EXPECT_FALSE(port.isOpen());
    radio.put();
    ASSERT_TRUE(until([&] { return opened == round + 1; }));
  }
}

TEST_F(SerialPortTest, countsAsLostWhenNobodyReads) {
  radio.put();
  port.open();
  const std::array<std::uint8_t, 58> frame{};
  int taken = 0;
  while (taken < 100000 && port.write(frame)) {
    ++taken;
    QCoreApplication::processEvents();
  }
  EXPECT_LT(taken, 1000) << "the backlog is bounded";
  EXPECT_EQ(lost, 1);
  EXPECT_EQ(reason, "the other end does not read");
}

TEST_F(SerialPortTest, writesNothingWhileClosed) {
  const std::array<std::uint8_t, 3> frame{};
  EXPECT_FALSE(port.write(frame));
  EXPECT_EQ(lost, 0);
}

TEST_F(SerialPortTest, staysClosedWhenItWasClosed) {
  radio.put();
  port.open();
  port.close();
  radio.pull();
  until([] { return false; }, 0.2);
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(opened, 1);
}

}  // namespace
}  // namespace tessera::host
