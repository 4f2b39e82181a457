#include "sim/world.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "sim/commission.h"
#include "sim/native_host.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tessera::sim {
namespace {

floor::VehicleSetup setup(std::uint8_t id) {
  floor::VehicleSetup v;
  v.id = VehicleId{id};
  v.key.fill(id);
  v.readers = {{Metres{0.15}, Metres{0.10}}, {Metres{0.15}, Metres{}}, {Metres{0.15}, Metres{-0.10}}};
  return v;
}

/// Vehicles with fresh settings (no calibrated compass) a metre apart, and a host that has nothing but the port.
class WorldTest : public ::testing::Test {
protected:
  explicit WorldTest(AirSettings air = {1.8, 0.0, Seconds{}}, std::uint64_t seed = 1)
      : world{WorldConfig{floor::RadioSetup{}, air, Scene{}, seed, Seconds{}}}, seed_{seed} {
    for (const std::uint8_t id : {std::uint8_t{1}, std::uint8_t{2}}) add(id);
    const auto started = world.startAll();
    EXPECT_TRUE(started) << (started ? "" : started.error().sentence);
  }
  void add(std::uint8_t id) {
    const auto vehicle = setup(id);
    const auto settings = settingsFor(vehicle, floor::RadioSetup{}, BodyParameters{});
    ASSERT_TRUE(settings) << settings.error().sentence;
    VehicleWorldConfig config;
    config.setup = vehicle;
    config.start = {{Metres{1.0 * id}, Metres{}}, Radians{}};
    config.seed = seed_;
    auto host = std::make_unique<NativeHost>(firmware::makeEepromImage(*settings));
    world.add(std::make_unique<VehicleBody>(config, std::move(host)), Metres{0.2});
  }
  void run(double seconds) {
    const Seconds end = world.time() + Seconds{seconds};
    while (world.time() < end) step();
  }
  void step() {
    world.advance(world.time() + World::kStep);
    decoder_.feed(world.takeHostBytes(), [&](const wire::Frame& f) {
      frames.push_back({f.header, {f.payload.begin(), f.payload.end()}});
    });
  }
  bool until(const std::function<bool()>& done, double patience = 5.0) {
    const Seconds end = world.time() + Seconds{patience};
    while (!done() && world.time() < end) step();
    return done();
  }
  void hello(std::uint8_t to, std::uint32_t nonce = 77) {
    std::array<std::uint8_t, 16> body{};
    const std::size_t size = wire::encode(wire::Hello{nonce, 0}, body);
    std::array<std::uint8_t, wire::kMaxFrame> frame{};
    const wire::FrameHeader header{to, wire::kHostAddress, static_cast<std::uint8_t>(wire::MessageType::Hello), 0};
    const std::size_t n = wire::sealFrame(setup(to).key, 0, header, wire::Bytes{body}.first(size), frame);
    world.hostBytes(std::span{frame}.first(n));
  }
  [[nodiscard]] std::size_t identities() const {
    return static_cast<std::size_t>(std::count_if(frames.begin(), frames.end(), [](const auto& f) {
      return f.header.type == static_cast<std::uint8_t>(wire::MessageType::Identity);
    }));
  }
  /// A Hello each half second until the vehicle answers, as a host does.
  bool meets(std::uint8_t id) {
    const std::size_t before = identities();
    for (int i = 0; i < 10; ++i) {
      hello(id);
      if (until([&] { return identities() > before; }, 0.5)) return true;
    }
    return false;
  }

  struct Got {
    wire::FrameHeader header;
    std::vector<std::uint8_t> payload;
  };
  World world;
  std::vector<Got> frames;

private:
  std::uint64_t seed_;
  wire::FrameDecoder decoder_;
};

TEST_F(WorldTest, bringsAHelloToTheVehicleAndItsIdentityBack) {
  ASSERT_TRUE(meets(1));
  const auto& answer = frames.back();
  EXPECT_EQ(answer.header.from, 1);
  const auto sealed = wire::splitMac(answer.payload);
  ASSERT_TRUE(sealed);
  const auto identity = wire::decodeIdentity(sealed->body);
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->hostNonce, 77U);
  EXPECT_TRUE(wire::sameMac(wire::macOf(setup(1).key, 0, answer.header, sealed->body), sealed->mac));
}

TEST_F(WorldTest, letsTheFirmwareSetItsOwnRadio) {
  ASSERT_NE(world.radio(VehicleId{1})->registers(), world.hostRadio().registers());  // as from the factory
  ASSERT_TRUE(until([&] {
    return world.radio(VehicleId{1})->registers().tuning() == world.hostRadio().registers().tuning() &&
           world.radio(VehicleId{1})->mode() == firmware::RadioMode::Normal;
  }));
}

TEST_F(WorldTest, takesTheTimeOfTheRadioForAnAnswer) {
  ASSERT_TRUE(meets(1));
  run(1.0);
  const std::size_t before = identities();
  const Seconds asked = world.time();
  hello(1, 78);
  ASSERT_TRUE(until([&] { return identities() > before; }));
  const double waited = (world.time() - asked).value();
  // Hello has 21 bytes, Identity 30: UART, silence, air, 5 ms, UART, each way; the vehicle itself adds little.
  const double least = 1.8 * (timeOnAir(5, 21) + timeOnAir(5, 30)).value() + 2 * 0.005 + 51 * 2 * 10.0 / 115200;
  EXPECT_GT(waited, least);
  EXPECT_LT(waited, least + 0.05);
}

TEST_F(WorldTest, silencesAVehicleWithoutPowerAndBringsItBack) {
  ASSERT_TRUE(meets(2));
  ASSERT_TRUE(world.kill(VehicleId{2}));
  EXPECT_FALSE(world.running(VehicleId{2}));
  EXPECT_FALSE(meets(2));
  EXPECT_TRUE(meets(1));
  ASSERT_TRUE(world.start(VehicleId{2}));
  EXPECT_TRUE(meets(2));
  EXPECT_TRUE(world.takeTroubles().empty());
}

TEST_F(WorldTest, tellsWhoIsNotThere) {
  EXPECT_FALSE(world.kill(VehicleId{9}));
  EXPECT_FALSE(world.push(VehicleId{9}, {}, {}));
  EXPECT_FALSE(world.truth(VehicleId{9}));
  const auto started = world.start(VehicleId{9});
  ASSERT_FALSE(started);
  EXPECT_NE(started.error().sentence.english().find("vehicle 9"), std::string::npos);
}

TEST_F(WorldTest, movesAVehicleThatIsPushed) {
  ASSERT_TRUE(world.push(VehicleId{1}, {Metres{0.5}, Metres{-0.25}}, fromDegrees(90)));
  const Pose pose = world.truth(VehicleId{1})->pose;
  EXPECT_NEAR(pose.position.x.value(), 1.5, 1e-9);
  EXPECT_NEAR(pose.position.y.value(), -0.25, 1e-9);
  EXPECT_NEAR(degrees(pose.heading), 90, 1e-9);
}

TEST_F(WorldTest, survivesNoiseOnTheChannel) {
  ASSERT_TRUE(meets(1));
  world.noise(3000);
  run(3.0);
  EXPECT_TRUE(meets(1));
}

TEST_F(WorldTest, letsAHeardPacketBeInjectedAgain) {
  ASSERT_TRUE(meets(1));
  run(0.5);
  const auto heard = world.tap().heard();
  ASSERT_FALSE(heard.empty());
  const std::size_t before = frames.size();
  world.inject(heard.back());
  ASSERT_TRUE(until([&] { return frames.size() > before; }));
  EXPECT_EQ(frames.back().header.from, 1);
}

TEST_F(WorldTest, hidesAChangedPacketFromTheDecoder) {
  ASSERT_TRUE(meets(1));
  world.tap().corruptNext(
      1, [](std::span<const std::uint8_t> b) { return b.size() > 4 && b[3] == 1; }, 12);
  const std::size_t before = identities();
  hello(1, 79);
  run(0.5);
  EXPECT_EQ(identities(), before);
  EXPECT_EQ(world.tap().counters().corrupted, 1U);
}

TEST_F(WorldTest, dropsWhatTheHostHandsOverBeyondThePortsBuffer) {
  const std::vector<std::uint8_t> much(5000, 0);
  world.hostBytes(much);
  EXPECT_EQ(world.hostRoom(), 0U);
  run(0.2);
  EXPECT_EQ(world.hostRoom(), World::kPortRoom);
}

TEST_F(WorldTest, skipsTimeWithoutRunningIt) {
  run(0.1);
  world.skipTo(Seconds{100});
  EXPECT_EQ(world.time(), Seconds{100});
  world.advance(Seconds{50});
  EXPECT_EQ(world.time(), Seconds{100});
  world.advance(Seconds{100.01});
  EXPECT_NEAR(world.time().value(), 100.01, 1e-9);
  world.advance(Seconds{std::nan("")});
  EXPECT_NEAR(world.time().value(), 100.01, 1e-9);
  EXPECT_TRUE(meets(1));
}

/// Half a minute of a world with losses and a driving hand, as its truth log tells it.
class LoggedWorld : public WorldTest {
public:
  explicit LoggedWorld(std::uint64_t seed) : WorldTest({1.8, 0.1, Seconds{}}, seed) {}
  void TestBody() override {}
  std::string log() {
    const auto path = std::filesystem::temp_directory_path() / ("tessera-truth-" + std::to_string(::getpid()) + ".csv");
    auto opened = TruthLog::open(path.string());
    EXPECT_TRUE(opened);
    world.setTruthLog(std::move(*opened));
    for (int i = 0; i < 5; ++i) {
      meets(1);
      world.body(VehicleId{2})->plant().step(Seconds{0.5}, {400, 300}, 12.0);
      run(0.2);
    }
    std::ifstream file{path};
    std::string text{std::istreambuf_iterator<char>{file}, {}};
    std::filesystem::remove(path);
    for (const Got& f : frames) text += std::to_string(f.header.type) + (f.payload.empty() ? "" : "p");
    return text + std::to_string(world.time().value());
  }
};

TEST(World, repeatsItselfByteForByteWithTheSameSeedOnly) {
  const auto run = [](std::uint64_t seed) { return LoggedWorld{seed}.log(); };
  const std::string first = run(5);
  EXPECT_GT(first.size(), 1000U);
  EXPECT_EQ(first, run(5));
  EXPECT_NE(first, run(6));
}

TEST(World, logsTruePosesFiftyTimesASecond) {
  const auto path = std::filesystem::temp_directory_path() / ("tessera-rows-" + std::to_string(::getpid()) + ".csv");
  World world{WorldConfig{floor::RadioSetup{}, AirSettings{}, Scene{}, 1, Seconds{}}};
  VehicleWorldConfig config;
  config.setup = setup(4);
  config.start = {{Metres{0.25}, Metres{-0.5}}, Radians{1.5}};
  world.add(std::make_unique<VehicleBody>(config, std::make_unique<NativeHost>(firmware::EepromChip::Image{})),
            Metres{});
  auto log = TruthLog::open(path.string());
  ASSERT_TRUE(log);
  world.setTruthLog(std::move(*log));
  world.advance(Seconds{1.0});
  std::ifstream file{path};
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 51U);
  EXPECT_EQ(lines[0], "time_s,vehicle,x_m,y_m,heading_rad,v_mps,omega_radps");
  EXPECT_EQ(lines[1], "0.001,4,0.250000,-0.500000,1.500000,0.00000,0.00000");
  std::filesystem::remove(path);
}

TEST(TruthLog, tellsThatAFileCannotBeWritten) {
  const auto log = TruthLog::open("/no-such-folder/truth.csv");
  ASSERT_FALSE(log);
  EXPECT_NE(log.error().sentence.english().find("/no-such-folder/truth.csv"), std::string::npos);
}

}  // namespace
}  // namespace tessera::sim
