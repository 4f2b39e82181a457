#include "firmware/vehicle/command.h"

#include <gtest/gtest.h>

namespace tessera::firmware::test {
namespace {

using Kind = Command::Kind;
using wire::CommandMode;

wire::CycleEntry entry(CommandMode mode, std::int16_t speed = 0, std::uint16_t bearing = 0, std::uint8_t expiry = 0) {
  return {1, mode, speed, bearing, expiry, 0};
}

TEST(Command, standsUntilItIsTold) { EXPECT_EQ(Command{}.at(Micros{100s}), Kind::Stand); }

TEST(Command, runsOutAtItsExpiryAndStaysSo) {
  Command c;
  c.take(entry(CommandMode::Drive, 120, 16384, 25), Micros{1s});
  EXPECT_EQ(c.at(Micros{1499ms}), Kind::Drive);
  EXPECT_FLOAT_EQ(c.speed(), 0.120F);
  EXPECT_NEAR(c.bearing(), kPi / 2, 1e-5);
  EXPECT_EQ(c.at(Micros{1500ms}), Kind::Expired);
  EXPECT_EQ(c.at(Micros{1400ms}), Kind::Expired);
}

TEST(Command, isProlongedByTheNextDriveButNotByAPoll) {
  Command c;
  c.take(entry(CommandMode::Drive, 100, 0, 10), Micros{1s});
  c.take(entry(CommandMode::Poll), Micros{1100ms});
  EXPECT_EQ(c.at(Micros{1150ms}), Kind::Drive);
  EXPECT_EQ(c.at(Micros{1200ms}), Kind::Expired);
  c.take(entry(CommandMode::Drive, 100, 0, 10), Micros{1300ms});
  EXPECT_EQ(c.at(Micros{1499ms}), Kind::Drive);
}

TEST(Command, stopsAtOnceAndDoesNotExpireThen) {
  for (const CommandMode mode : {CommandMode::Stop, CommandMode::Clear}) {
    Command c;
    c.take(entry(CommandMode::Drive, 100, 0, 10), Micros{1s});
    c.take(entry(mode), Micros{1050ms});
    EXPECT_EQ(c.at(Micros{1051ms}), Kind::Stand);
    EXPECT_EQ(c.at(Micros{9s}), Kind::Stand);
  }
}

TEST(Command, withAnExpiryOfZeroNeverRuns) {
  Command c;
  c.take(entry(CommandMode::Drive, 100, 0, 0), Micros{1s});
  EXPECT_EQ(c.at(Micros{1s}), Kind::Expired);
}

}  // namespace
}  // namespace tessera::firmware::test
