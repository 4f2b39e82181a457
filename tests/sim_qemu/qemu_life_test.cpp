// Start, end, reset and loss of the emulated vehicle.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>

#include "emulated_board.h"

namespace tessera::sim {
namespace {

using QemuLife = EmulatedBoard;

constexpr const char* kPowerOn = "0";
constexpr const char* kWatchdog = "1";
constexpr const char* kSoftware = "2";
constexpr const char* kOther = "3";

TEST_F(QemuLife, startsAtOnceAndSaysWhy) {
  EXPECT_FALSE(host_.running());
  EXPECT_NE(host_.trouble(), "");
  start();
  EXPECT_TRUE(host_.running());
  EXPECT_EQ(host_.trouble(), "");
  EXPECT_EQ(ask("cause"), kPowerOn);
}

TEST_F(QemuLife, watchdogBitesAProgramThatDoesNotFeedIt) {
  start();
  ask("drive 300 300");
  ask("hang");
  ASSERT_TRUE(eventually([&] { return host_.resets() == 1; }));
  waitUntilItListens();
  EXPECT_TRUE(host_.running());
  EXPECT_EQ(ask("cause"), kWatchdog);
  EXPECT_TRUE(eventually([&] {
    collect();
    return duty_ == std::array{0, 0};
  })) << "a reset lets go of the motors";
}

TEST_F(QemuLife, watchdogLeavesAProgramAloneThatFeedsIt) {
  start();
  const auto before = askNumbers("micros").at(0);
  EXPECT_TRUE(eventually([&] { return askNumbers("micros").at(0) - before > 1'500'000; }));
  EXPECT_EQ(host_.resets(), 0);
}

TEST_F(QemuLife, restartAndFaultAreTold) {
  start();
  say("restart");
  ASSERT_TRUE(eventually([&] { return host_.resets() == 1; }));
  waitUntilItListens();
  EXPECT_EQ(ask("cause"), kSoftware);
  say("fault");
  ASSERT_TRUE(eventually([&] { return host_.resets() == 2; }));
  waitUntilItListens();
  EXPECT_EQ(ask("cause"), kOther);
}

TEST_F(QemuLife, pinsKeepTheirLevelsThroughAReset) {
  Signals signals;
  signals.encoderCounts = {2, 1};
  start();
  host_.setSignals(signals);
  EXPECT_TRUE(eventually([&] { return askNumbers("counts") == std::vector<long>{2, 1}; }));
  ask("mode 3");
  say("restart");
  ASSERT_TRUE(eventually([&] { return host_.resets() == 1; }));
  waitUntilItListens();
  EXPECT_EQ(ask("aux"), "1");
  EXPECT_TRUE(eventually([&] {
    collect();
    return mode_ == firmware::RadioMode::Normal;
  }));
  const auto from = askNumbers("counts");
  signals.encoderCounts = {102, -99};
  host_.setSignals(signals);
  EXPECT_TRUE(eventually([&] {
    return askNumbers("counts") == std::vector<long>{from[0] + 100, from[1] - 100};
  })) << ask("counts");
}

TEST_F(QemuLife, eepromOutlivesThePower) {
  start();
  ASSERT_EQ(ask("write 80 1 32 11 22 33 44"), "done");
  host_.kill();
  EXPECT_FALSE(host_.running());
  EXPECT_NE(host_.trouble(), "");
  start();
  ASSERT_EQ(ask("write 80 1 32"), "done");
  EXPECT_EQ(askNumbers("read 80 5"), (std::vector<long>{11, 22, 33, 44, 255}));
}

TEST_F(QemuLife, anAbsentPartDoesNotAnswer) {
  start();
  EXPECT_EQ(ask("write 33 0"), "no answer");
  EXPECT_EQ(ask("read 33 1"), "no answer");
  EXPECT_EQ(ask("write 80 0 0"), "done");
}

TEST_F(QemuLife, anEmulatorThatIsPulledAwayIsNoticedAndCanBeStartedAnew) {
  start();
  ASSERT_GT(host_.processId(), 0);
  ::kill(host_.processId(), SIGKILL);
  EXPECT_TRUE(eventually([&] { return !host_.running(); }));
  EXPECT_NE(host_.trouble().find("emulator"), std::string::npos) << host_.trouble();
  start();
  EXPECT_EQ(ask("cause"), kPowerOn);
}

TEST_F(QemuLife, noEmulatorStaysBehind) {
  start();
  const int process = host_.processId();
  host_.kill();
  EXPECT_EQ(::kill(process, 0), -1);
  EXPECT_EQ(host_.take().toRadio.size(), 0U);
}

TEST_F(QemuLife, theEmulatorDiesWithTheProcessThatStartedIt) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const pid_t owner = ::fork();
  if (owner == 0) {
    const bool started = host_.start(Seconds{}).has_value();
    const int emulator = started ? host_.processId() : 0;
    static_cast<void>(!::write(pipe[1], &emulator, sizeof emulator));
    for (;;) ::pause();
  }
  int emulator = 0;
  ASSERT_EQ(::read(pipe[0], &emulator, sizeof emulator), static_cast<ssize_t>(sizeof emulator));
  ASSERT_GT(emulator, 0);
  ::close(pipe[0]);
  ::close(pipe[1]);
  EXPECT_EQ(::kill(emulator, 0), 0);
  ::kill(owner, SIGKILL);
  ::waitpid(owner, nullptr, 0);
  // Where nobody collects orphans, the dead one stays in the list as a zombie (state Z).
  EXPECT_TRUE(eventually([&] {
    std::ifstream status{"/proc/" + std::to_string(emulator) + "/stat"};
    std::string id, name, state;
    return !(status >> id >> name >> state) || state == "Z";
  }));
}

TEST_F(QemuLife, whatCannotStartSaysWhy) {
  const auto failsWith = [](const QemuConfig& config, const std::string& part) {
    QemuHost host{config};
    const auto started = host.start(Seconds{});
    ASSERT_FALSE(started);
    EXPECT_NE(started.error().sentence.english().find(part), std::string::npos) << started.error().sentence;
    EXPECT_FALSE(host.running());
  };
  QemuConfig config = makeConfig();
  config.emulator = "qemu-system-nowhere";
  failsWith(config, "not installed");
  config = makeConfig();
  config.program = directory_ / "missing.elf";
  failsWith(config, "missing.elf");
  config = makeConfig();
  std::ofstream{config.eeprom} << "short";
  failsWith(config, "5 bytes");
  config = makeConfig();
  config.program = config.eeprom;
  failsWith(config, "no ELF");
}

}  // namespace
}  // namespace tessera::sim
