// Everything that hangs on the emulated chip's pins, through the real drivers on one side and the emulator's traces,
// qtest and QMP on the other.
#include <algorithm>
#include <cmath>
#include <limits>

#include "emulated_board.h"

namespace tessera::sim {
namespace {

using QemuPins = EmulatedBoard;

TEST_F(QemuPins, motorsFollowDutyAndDirection) {
  start();
  ask("drive 500 -250");
  EXPECT_TRUE(eventually([&] {
    collect();
    return duty_ == std::array{500, -250};
  })) << duty_[0]
      << " " << duty_[1];
  ask("drive -1000 1000");
  EXPECT_TRUE(eventually([&] {
    collect();
    return duty_ == std::array{-1000, 1000};
  })) << duty_[0]
      << " " << duty_[1];
  ask("drive 0 0");
  EXPECT_TRUE(eventually([&] {
    collect();
    return duty_ == std::array{0, 0};
  }));
}

TEST_F(QemuPins, radioModeIsSeenOnItsTwoPins) {
  start();
  for (int mode : {3, 1, 2, 0}) {
    ask("mode " + std::to_string(mode));
    EXPECT_TRUE(eventually([&] {
      collect();
      return static_cast<int>(mode_) == mode;
    })) << mode;
  }
}

TEST_F(QemuPins, auxIsSeenByTheFirmware) {
  start();
  EXPECT_EQ(ask("aux"), "1");
  Signals signals;
  signals.radioReady = false;
  host_.setSignals(signals);
  EXPECT_TRUE(eventually([&] { return ask("aux") == "0"; }));
  signals.radioReady = true;
  host_.setSignals(signals);
  EXPECT_TRUE(eventually([&] { return ask("aux") == "1"; }));
}

TEST_F(QemuPins, noEncoderCountIsLostInThousandsBothWays) {
  Signals signals;
  signals.encoderCounts = {17, -23};  // what was counted before the start is nobody's
  host_.setSignals(signals);
  start();
  EXPECT_EQ(askNumbers("counts"), (std::vector<long>{0, 0}));
  // In pieces as a world hands them over, faster than any vehicle drives.
  const auto runTo = [&](std::int64_t left, std::int64_t right) {
    signals.encoderCounts = {17 + left, -23 + right};
    host_.setSignals(signals);
    EXPECT_TRUE(eventually(
        [&] {
          return askNumbers("counts") == std::vector<long>{left, right};
        },
        Seconds{30.0}))
        << ask("counts");
  };
  runTo(1, -1);
  runTo(3000, 2000);
  runTo(-1000, 2001);
  runTo(0, 0);
}

TEST_F(QemuPins, encodersCountExactlyWhileTheProcessorIsBusyOtherwise) {
  start();
  Signals signals;
  for (int i = 1; i <= 1500; ++i) {
    signals.encoderCounts = {i, -2 * i};
    host_.setSignals(signals);
    if (i % 300 == 0) say("say 2000");
    std::this_thread::sleep_for(std::chrono::microseconds{300});
  }
  EXPECT_TRUE(eventually(
      [&] {
        return askNumbers("counts") == std::vector<long>{1500, -3000};
      },
      Seconds{30.0}))
      << ask("counts");
}

/// The firmware takes a median against single echoes that a busy computer delays; this is one of five.
class QemuRangers : public EmulatedBoard {
protected:
  long medianEcho(int ranger) {
    std::vector<long> echoes;
    for (int i = 0; i < 5; ++i) {
      ask("ping " + std::to_string(ranger));
      long echo = 0;
      EXPECT_TRUE(eventually([&] { return (echo = askNumbers("echo " + std::to_string(ranger)).at(0)) != 0; }));
      echoes.push_back(echo);
    }
    std::sort(echoes.begin(), echoes.end());
    return echoes[2];
  }
};

TEST_F(QemuRangers, echoIsAsLongAsTheWayOfSound) {
  start();
  Signals signals;
  for (const double metres : {0.30, 1.00, 2.50}) {
    signals.range = {Metres{metres}, Metres{metres / 2}};
    host_.setSignals(signals);
    for (int ranger : {0, 1}) {
      const double expected = 5800.0 * (ranger == 0 ? metres : metres / 2);
      double echo = 0;
      EXPECT_TRUE(eventually([&] {
        echo = static_cast<double>(medianEcho(ranger));
        return std::abs(echo - expected) < 100.0;  // 1.7 cm
      })) << "ranger "
          << ranger << ": " << echo << " µs instead of " << expected;
    }
  }
}

TEST_F(QemuPins, aPingIntoTheOpenIsAnsweredByALongPulse) {
  start();
  Signals signals;
  signals.range = {Metres{0.0}, Metres{1.0}};
  host_.setSignals(signals);
  ask("ping 0");
  long echo = 0;
  EXPECT_TRUE(eventually([&] { return (echo = askNumbers("echo 0").at(0)) != 0; }));
  EXPECT_GT(echo, 30'000);
}

TEST_F(QemuPins, aDeadRangerAnswersNoPing) {
  start();
  Signals signals;
  signals.range = {Metres{std::numeric_limits<double>::quiet_NaN()}, Metres{0.0}};
  host_.setSignals(signals);
  ask("ping 0");
  ask("ping 1");
  EXPECT_TRUE(eventually([&] { return askNumbers("echo 1").at(0) != 0; }));
  EXPECT_EQ(ask("echo 0"), "0");
}

TEST_F(QemuPins, compassFollowsTheField) {
  start();
  ASSERT_EQ(ask("write 30 10"), "done");
  EXPECT_EQ(askNumbers("read 30 3"), (std::vector<long>{'H', '4', '3'}));
  ask("write 30 1 32");  // gain 1090 LSB/G
  ask("write 30 2 0");   // continuous
  Signals signals;
  signals.field = {60.0, 75.0, 40.0};
  host_.setSignals(signals);
  const auto near = [](const std::vector<long>& raw, std::size_t at, double expected) {
    const double value = static_cast<double>(static_cast<std::int16_t>(raw.at(at) << 8 | raw.at(at + 1)));
    return std::abs(value - expected) < 8.0;
  };
  // 10 LSB/µT on x and y within the model's 1 %, less on z. The order is X, Z, Y.
  EXPECT_TRUE(eventually([&] {
    ask("write 30 3");
    const auto raw = askNumbers("read 30 6");
    return raw.size() == 6 && near(raw, 0, 60.0 * 11.0) && near(raw, 4, 75.0 * 11.0) && near(raw, 2, 40.0 * 9.8);
  })) << ask("read 30 6");
}

}  // namespace
}  // namespace tessera::sim
