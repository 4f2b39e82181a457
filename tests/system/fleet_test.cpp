// Several vehicles share one channel and one port.
#include <gtest/gtest.h>
#include <signal.h>

#include <QDeadlineTimer>
#include <QThread>
#include <nlohmann/json.hpp>

#include "app/cli/exit_codes.h"
#include "system/supervision.h"
#include "system/world.h"

namespace tessera::system_test {
namespace {

TEST(ThreeVehiclesOnOnePort, driveToTheEndsOfTheirRoutes) {
  const QTemporaryDir folder;
  Program cli{TESSERA_CLI,
              {"experiment", TESSERA_SITES "/three.tessera.json", "--drive", "1=one", "--drive", "2=two", "--drive",
               "3=three", "--speed", "0.3", "--vehicle", "native", "--json", "--out", folder.path().toStdString()}};
  const std::string result = cli.line();  // comes when all have arrived
  ASSERT_EQ(cli.exitCode(), cli::kDone) << cli.errors();
  const auto summary = nlohmann::json::parse(result + cli.output(), nullptr, false);
  ASSERT_TRUE(summary.is_object());
  ASSERT_EQ(summary["vehicles"].size(), 3U);
  for (const auto& vehicle : summary["vehicles"]) {
    EXPECT_EQ(vehicle["finished"], true) << vehicle;
    EXPECT_EQ(vehicle["reversals"], 0) << vehicle;
    EXPECT_LT(vehicle["cross_track_rms_m"], 0.03) << vehicle;
  }
}

TEST(ThreeVehiclesOnOnePort, standWhenTheProgramIsInterrupted) {
  const std::string site = TESSERA_SITES "/three.tessera.json";
  const QTemporaryDir folder;
  World world{folder, site, {}};
  ASSERT_NE(world.port(), "") << world.program().errors();
  std::vector<Point> starts;
  for (int vehicle = 1; vehicle <= 3; ++vehicle) starts.push_back(world.where(vehicle));
  Program cli{TESSERA_CLI,
              {"drive", site, "--port", world.port(), "--drive", "1=one", "--drive", "2=two", "--drive", "3=three",
               "--speed", "0.3", "--limit", "120"}};
  int moved = 0;
  for (int vehicle = 1; vehicle <= 3; ++vehicle) {
    const QDeadlineTimer end{kPatienceMs};
    const Point start = starts[static_cast<std::size_t>(vehicle - 1)];
    while (!end.hasExpired() && distance(world.where(vehicle), start) < Metres{0.1}) QThread::msleep(50);
    moved += end.hasExpired() ? 0 : 1;
  }
  EXPECT_EQ(moved, 3) << cli.errors();
  // All three are on their way now; Ctrl-C stops them all before the program ends.
  cli.signal(SIGINT);
  EXPECT_EQ(cli.exitCode(), cli::kInterrupted) << cli.errors();
  const Seconds ended = host::steadyNow();
  for (int vehicle = 1; vehicle <= 3; ++vehicle) {
    EXPECT_LT(world.movedOnFor(ended, vehicle), Seconds{0.1}) << "vehicle " << vehicle << " was left rolling";
    EXPECT_LT(distance(world.where(vehicle), starts[static_cast<std::size_t>(vehicle - 1)]), Metres{3.0});
  }
}

}  // namespace
}  // namespace tessera::system_test
