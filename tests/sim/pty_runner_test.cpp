#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <ctime>

#include "sim/commission.h"
#include "sim/native_host.h"
#include "sim/pty/runner.h"
#include "wire/messages.h"

namespace tessera::sim {
namespace {

floor::VehicleSetup setup() {
  floor::VehicleSetup v;
  v.id = VehicleId{3};
  v.key.fill(3);
  v.readers = {{Metres{0.15}, Metres{}}};
  return v;
}

std::unique_ptr<VehicleBody> vehicle() {
  VehicleWorldConfig config;
  config.setup = setup();
  const auto settings = settingsFor(config.setup, floor::RadioSetup{}, BodyParameters{});
  EXPECT_TRUE(settings) << (settings ? "" : settings.error().sentence);
  return std::make_unique<VehicleBody>(config, std::make_unique<NativeHost>(firmware::makeEepromImage(*settings)));
}

/// A host program: says Hello through the port until it is answered.
class HostProgram {
public:
  explicit HostProgram(const std::string& path) : fd_{::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)} {}
  ~HostProgram() { ::close(fd_); }
  HostProgram(const HostProgram&) = delete;
  HostProgram& operator=(const HostProgram&) = delete;
  [[nodiscard]] int fd() const { return fd_; }
  void hello() const {
    std::array<std::uint8_t, 16> body{};
    const std::size_t size = wire::encode(wire::Hello{5, 0}, body);
    std::array<std::uint8_t, wire::kMaxFrame> frame{};
    const wire::FrameHeader header{3, 0, static_cast<std::uint8_t>(wire::MessageType::Hello), 0};
    const std::size_t n = wire::sealFrame(setup().key, 0, header, wire::Bytes{body}.first(size), frame);
    ASSERT_EQ(::write(fd_, frame.data(), n), static_cast<ssize_t>(n));
  }
  /// True when an Identity has come.
  bool listen() {
    std::array<std::uint8_t, 256> bytes{};
    const ssize_t n = ::read(fd_, bytes.data(), bytes.size());
    bool found = false;
    if (n > 0)
      decoder_.feed(wire::Bytes{bytes}.first(static_cast<std::size_t>(n)), [&](const wire::Frame& f) {
        found = found || f.header.type == static_cast<std::uint8_t>(wire::MessageType::Identity);
      });
    return found;
  }

private:
  int fd_;
  wire::FrameDecoder decoder_;
};

class RealTimeRunnerTest : public ::testing::Test {
protected:
  RealTimeRunnerTest() {
    world.add(vehicle(), Metres{0.2});
    auto port = Pty::open();
    EXPECT_TRUE(port);
    runner.setPort(std::move(*port));
  }
  /// Runs until the vehicle has answered through the port; false after ten seconds.
  bool answers(HostProgram& program) {
    bool answered = false;
    // Asked again each half second: a vehicle that has just started sets its radio first.
    int nth = 0;
    runner.watch(program.fd(), [&] {
      answered = answered || program.listen();
      if (answered) runner.stop();
    });
    while (!answered && ++nth <= 20) {
      program.hello();
      EXPECT_TRUE(runner.run(monotonicNow() + Seconds{0.5}));
    }
    runner.unwatch(program.fd());
    return answered;
  }

  World world{WorldConfig{floor::RadioSetup{}, {1.0, 0.0, Seconds{}}, Scene{}, 1, monotonicNow()}};
  RealTimeRunner runner{world};
};

TEST_F(RealTimeRunnerTest, answersAProgramThatOpensThePort) {
  ASSERT_TRUE(world.startAll());
  HostProgram program{runner.port()->path()};
  EXPECT_TRUE(answers(program));
}

TEST_F(RealTimeRunnerTest, goesOnWhenTheProgramHasGoneAndComesBack) {
  ASSERT_TRUE(world.startAll());
  {
    HostProgram program{runner.port()->path()};
    ASSERT_TRUE(answers(program));
  }
  ASSERT_TRUE(runner.run(monotonicNow() + Seconds{0.1}));
  HostProgram again{runner.port()->path()};
  EXPECT_TRUE(answers(again));
}

TEST_F(RealTimeRunnerTest, keepsTheWorldAtTheClock) {
  const Seconds before = monotonicNow();
  ASSERT_TRUE(runner.run(before + Seconds{0.3}));
  EXPECT_GT((world.time() - before).value(), 0.15);
  EXPECT_LE(world.time(), monotonicNow());
}

TEST_F(RealTimeRunnerTest, doesNotSpinWhileNobodyHoldsThePort) {
  { const HostProgram gone{runner.port()->path()}; }
  timespec start{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
  ASSERT_TRUE(runner.run(monotonicNow() + Seconds{0.5}));
  timespec end{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
  EXPECT_LT(static_cast<double>(end.tv_sec - start.tv_sec) + 1e-9 * static_cast<double>(end.tv_nsec - start.tv_nsec),
            0.4);
}

TEST_F(RealTimeRunnerTest, skipsAndTellsWhatItCannotMakeUpFor) {
  std::string said;
  World late{WorldConfig{floor::RadioSetup{}, AirSettings{}, Scene{}, 1, monotonicNow() - Seconds{3600}}};
  RealTimeRunner second{late};
  second.onTrouble([&](const std::string& sentence) { said = sentence; });
  ASSERT_TRUE(second.run(monotonicNow() + Seconds{0.05}));
  EXPECT_NE(said.find("does not keep up"), std::string::npos);
  EXPECT_GT(second.skipped().value(), 3599.0);
}

}  // namespace
}  // namespace tessera::sim
