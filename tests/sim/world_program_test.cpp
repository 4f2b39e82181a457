// The parts of tessera-world: options, making a world of a site file, commands.
#include <gtest/gtest.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/world/commands.h"
#include "app/world/line_reader.h"
#include "app/world/make_world.h"
#include "app/world/world_options.h"
#include "floor/site_json.h"

namespace tessera::world {
namespace {

namespace fs = std::filesystem;

const std::string kSites = std::string{TESSERA_SOURCE_DIR} + "/resources/sites/";

WorldOptions parsed(std::vector<std::string> words) {
  CLI::App app;
  WorldOptions options;
  addWorldCast(app, options);
  addWorldConditions(app, options);
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  app.parse(words);
  return options;
}

TEST(WorldOptions, surviveTheWayThroughTheWordsOfACall) {
  std::istringstream rest{
      "--vehicle 1 --vehicle 3 --kind qemu --seed 42 --air-rate 9600 --air-factor 1.25 --loss 0.1 --delay 0.3 --poll "
      "0.2 --read-time 0.15 --detection 0.8 --radius 0.07 --true-radius 0.065 --slip 0.05 --compass-noise 2 "
      "--compass-bias 3 --compass-spots 12 --corrupt 0.01 --drop 0.02 --replay 0.03 --fresh 3 --truth t.csv "
      "--eeprom-dir e"};
  std::vector<std::string> words{kSites + "three.tessera.json"};
  for (std::string word; rest >> word;) words.push_back(word);
  const WorldOptions once = parsed(words);
  EXPECT_EQ(once.vehicles, (std::vector<unsigned>{1, 3}));
  EXPECT_EQ(once.fresh, std::vector<unsigned>{3});
  EXPECT_EQ(once.kind, Kind::Qemu);
  EXPECT_EQ(once.seed, 42U);
  EXPECT_EQ(once.airRate, 9600.0);
  EXPECT_EQ(once.readTime, 0.15);
  EXPECT_EQ(once.compassSpots, 12.0);
  EXPECT_EQ(once.trueRadius, 0.065);
  EXPECT_EQ(worldArguments(parsed(worldArguments(once))), worldArguments(once));
  EXPECT_EQ(worldArguments(once).size(), words.size());
}

TEST(WorldOptions, takeTheSiteBeforeAndBehindAVehicle) {
  const std::string site = kSites + "paper.tessera.json";
  EXPECT_EQ(parsed({"--vehicle", "1", site}).site, site);
  EXPECT_EQ(parsed({site, "--vehicle", "1"}).site, site);
}

TEST(WorldOptions, refuseWhatIsOutOfRange) {
  const std::string site = kSites + "paper.tessera.json";
  EXPECT_THROW(parsed({site, "--loss", "1.5"}), CLI::ParseError);
  EXPECT_THROW(parsed({site, "--air-rate", "9601"}), CLI::ParseError);
  EXPECT_THROW(parsed({site, "--vehicle", "255"}), CLI::ParseError);
  EXPECT_THROW(parsed({site, "--kind", "real"}), CLI::ParseError);
  EXPECT_THROW(parsed({site, "--read-time", "0.3"}), CLI::ParseError);
}

WorldOptions three() {
  WorldOptions options;
  options.site = kSites + "three.tessera.json";
  return options;
}

TEST(MakeWorld, putsTheSitesVehiclesAtTheirPlaces) {
  auto made = makeWorld(three(), Seconds{});
  ASSERT_TRUE(made) << made.error().sentence;
  const auto site = floor::loadSite(three().site);
  ASSERT_TRUE(site);
  ASSERT_EQ(made->vehicles.size(), site->vehicles.size());
  for (const auto& setup : site->vehicles) {
    const auto truth = made->world->truth(setup.id);
    ASSERT_TRUE(truth && setup.start);
    EXPECT_EQ(truth->pose.position, setup.start->position);
    EXPECT_FALSE(made->world->running(setup.id));
  }
  ASSERT_TRUE(made->world->startAll());
  made->world->advance(Seconds{0.5});
  EXPECT_TRUE(made->world->running(site->vehicles.front().id));
}

TEST(Radius, isWhatTheSiteIsToldAndTrueUnlessATrueOneIsGiven) {
  auto site = floor::loadSite(three().site);
  ASSERT_TRUE(site);
  auto options = three();
  options.radius = 0.08;
  applyTo(*site, options);
  for (const auto& setup : site->vehicles) {
    EXPECT_EQ(setup.readerRadius, Metres{0.08});
    EXPECT_EQ(bodyFor(setup, options).readers.radius, Metres{0.08});
  }
  options.trueRadius = 0.05;
  applyTo(*site, options);
  EXPECT_EQ(site->vehicles.front().readerRadius, Metres{0.08}) << "nobody tells the site";
  EXPECT_EQ(bodyFor(site->vehicles.front(), options).readers.radius, Metres{0.05});
}

TEST(MakeWorld, takesOnlyTheVehiclesThatAreNamed) {
  auto options = three();
  options.vehicles = {2, 2};
  const auto made = makeWorld(options, Seconds{});
  ASSERT_TRUE(made);
  EXPECT_EQ(made->world->vehicles(), std::vector<VehicleId>{VehicleId{2}});
  options.vehicles = {77};
  const auto refused = makeWorld(options, Seconds{});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.english().find("77"), std::string::npos);
}

TEST(MakeWorld, tellsWhatIsWrongWithItsFiles) {
  auto options = three();
  options.site = "/no-such-folder/x.tessera.json";
  EXPECT_FALSE(makeWorld(options, Seconds{}));
  options = three();
  options.truth = "/no-such-folder/truth.csv";
  EXPECT_FALSE(makeWorld(options, Seconds{}));
}

TEST(MakeWorld, keepsEepromsInTheFolderGiven) {
  auto options = three();
  options.vehicles = {1};
  const fs::path folder = fs::temp_directory_path() / ("tessera-eeproms-" + std::to_string(::getpid()));
  options.eepromDir = folder.string();
  const auto bytes = [&] {
    std::ifstream file{folder / "vehicle-1.eeprom", std::ios::binary};
    return std::string{std::istreambuf_iterator<char>{file}, {}};
  };
  std::string first;
  {
    auto made = makeWorld(options, Seconds{});
    ASSERT_TRUE(made) << made.error().sentence;
    first = bytes();
    EXPECT_EQ(first.size(), firmware::kEepromSize);
    ASSERT_TRUE(made->world->startAll());
    made->world->advance(Seconds{2.0});
    ASSERT_TRUE(made->saveEeproms());
  }
  EXPECT_NE(bytes(), first);  // it counted its start
  std::ofstream{folder / "vehicle-1.eeprom"} << "short";
  const auto refused = makeWorld(options, Seconds{});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.english().find("vehicle-1.eeprom"), std::string::npos);
  fs::remove_all(folder);
}

TEST(TemporaryFolder, goesWithItsHolder) {
  std::string path;
  {
    auto folder = TemporaryFolder::make();
    ASSERT_TRUE(folder);
    path = folder->path();
    std::ofstream{path + "/file"} << "x";
    const TemporaryFolder moved = std::move(*folder);
    EXPECT_TRUE(fs::exists(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

class CommandsTest : public ::testing::Test, public Surroundings {
protected:
  void SetUp() override {
    auto options = three();
    options.vehicles = {1};
    auto made = makeWorld(options, Seconds{});
    ASSERT_TRUE(made);
    made_ = std::move(*made);
    ASSERT_TRUE(made_.world->startAll());
  }
  Result<void> pull() override {
    plugged_ = false;
    return {};
  }
  Result<std::string> plug() override {
    plugged_ = true;
    return std::string{"/dev/pts/7"};
  }
  void quit() override { ended_ = true; }
  bool done(const std::string& line) { return obey(line, *made_.world, *this).has_value(); }
  [[nodiscard]] sim::World& world() { return *made_.world; }

  MadeWorld made_;
  bool plugged_ = true;
  bool ended_ = false;
};

TEST_F(CommandsTest, doWhatTheySay) {
  EXPECT_TRUE(done("kill 1"));
  EXPECT_FALSE(world().running(VehicleId{1}));
  EXPECT_TRUE(done("start 1"));
  EXPECT_TRUE(world().running(VehicleId{1}));
  const Pose before = world().truth(VehicleId{1})->pose;
  EXPECT_TRUE(done("  push 1 0.5 -0.25 90 "));
  const Pose after = world().truth(VehicleId{1})->pose;
  EXPECT_NEAR((after.position.x - before.position.x).value(), 0.5, 1e-9);
  EXPECT_NEAR(degrees(turnBetween(before.heading, after.heading)), 90, 1e-9);
  EXPECT_TRUE(done("pull"));
  EXPECT_FALSE(plugged_);
  EXPECT_EQ(obey("plug", world(), *this), "the port is /dev/pts/7");
  EXPECT_TRUE(plugged_);
  const auto packets = world().air().counters().packets;
  EXPECT_TRUE(done("noise 60"));
  EXPECT_TRUE(done("inject a5000103"));
  world().advance(Seconds{1.0});
  EXPECT_GE(world().air().counters().packets, packets + 3);
  EXPECT_TRUE(done("obstacle 1 2 0.1"));
  EXPECT_TRUE(done("obstacle clear"));
  EXPECT_EQ(obey("ranger 1 0 off", world(), *this), "ranger 0 of vehicle 1 is dead");
  EXPECT_EQ(obey("ranger 1 0 on", world(), *this), "ranger 0 of vehicle 1 answers again");
  EXPECT_TRUE(done("corrupt 2"));
  EXPECT_EQ(obey("corrupt 2 from 1", world(), *this), "a byte will change in each of the next 2 packets of vehicle 1");
  EXPECT_TRUE(done("drop 1"));
  EXPECT_TRUE(done("jumpers 1 1"));
  world().advance(world().time() + Seconds{1});
  EXPECT_EQ(world().hostRadio().mode(), firmware::RadioMode::Configure);
  EXPECT_TRUE(done("jumpers 0 0"));
  world().advance(world().time() + Seconds{1});
  EXPECT_EQ(world().hostRadio().mode(), firmware::RadioMode::Normal);
  EXPECT_TRUE(done("where 1"));
  double x = 0.0;
  const std::string truth = obey("truth 1", world(), *this).value();
  ASSERT_EQ(std::sscanf(truth.c_str(), "truth 1 %*f %lf %*f %*f", &x), 1) << truth;
  EXPECT_NEAR(x, world().truth(VehicleId{1})->pose.position.x.value(), 1e-6);
  EXPECT_TRUE(done(""));
  EXPECT_FALSE(ended_);
  EXPECT_TRUE(done("quit"));
  EXPECT_TRUE(ended_);
}

TEST_F(CommandsTest, refuseWhatMakesNoSenseWithASentence) {
  std::istringstream lines{
      "kill\nkill 2\nkill 1 1\nkill -1\nkill 1e9\nstart x\npush 1 2 3\npush 1 nan 0 0\npush 1 0 0 inf\n"
      "obstacle 1 2\nobstacle 1 2 -1\nnoise\nnoise 0\nnoise 1.5\nnoise 1e12\ninject\ninject a\ninject zz\n"
      "replay 1\ndrop\ncorrupt x\nranger 1 2 off\nranger 1 0\nranger 2 0 off\nranger 1 0 away\nreplay 1 0\n"
      "corrupt 1 from 2\ncorrupt 1 from\ncorrupt 1 1\njumpers\njumpers 1\njumpers 2 0\njumpers 1 1 "
      "1\nwhere\ntruth\ntruth 2\npull "
      "now\ndance\nquit quit\n"};
  for (std::string line; std::getline(lines, line);) {
    const auto answer = obey(line, world(), *this);
    ASSERT_FALSE(answer) << line;
    EXPECT_EQ(answer.error().sentence.english().back(), '.') << line;
  }
  EXPECT_TRUE(world().running(VehicleId{1}));
  EXPECT_FALSE(ended_);
}

TEST(LineReader, givesWholeLinesAndForgetsOverlongOnes) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  LineReader reader{pipe[0]};
  const auto put = [&](const std::string& text) {
    ASSERT_EQ(::write(pipe[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  };
  put("kill 1\npu");
  EXPECT_EQ(reader.read(), std::vector<std::string>{"kill 1"});
  put("ll\n");
  EXPECT_EQ(reader.read(), std::vector<std::string>{"pull"});
  put(std::string(20'000, 'x') + "\nquit\n");
  std::vector<std::string> lines;
  while (lines.empty()) lines = reader.read();
  EXPECT_EQ(lines, std::vector<std::string>{"quit"});
  EXPECT_FALSE(reader.ended());
  ::close(pipe[1]);
  EXPECT_TRUE(reader.read().empty());
  EXPECT_TRUE(reader.ended());
  ::close(pipe[0]);
}

}  // namespace
}  // namespace tessera::world
