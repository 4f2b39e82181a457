#include "supervisor/supervisor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/polyline.h"
#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

using test::SupervisorRig;

TEST(Supervisor, drivesAVehicleAlongTheRouteToItsEnd) {
  SupervisorRig rig;
  rig.runRoute(1, "paper", 0.12);
  double worst = 0;
  double worstError = 0;
  const Polyline line{rig.map->route("paper")->vertices};
  const bool finished = rig.runUntil(
      [&] {
        if (rig.vehicle(1).speed > 0.01) {
          worst = std::max(worst, std::abs(line.project(rig.vehicle(1).pose.position).across.value()));
          worstError = std::max(worstError, distance(rig.view(1).pose.position, rig.vehicle(1).pose.position).value());
        }
        return rig.last && rig.view(1).finished;
      },
      Seconds{120});
  ASSERT_TRUE(finished) << rig.view(1).waits << rig.view(1).doing;
  EXPECT_LT(distance(rig.vehicle(1).pose.position, line.vertices().back()).value(), 0.06);
  EXPECT_LT(worst, 0.06);
  EXPECT_LT(worstError, 0.06);
  ASSERT_EQ(rig.told(EventKind::RouteFinished).size(), 1U);
  EXPECT_EQ(rig.told(EventKind::RouteFinished)[0].sentence, "AGV 1 has reached the end of the route paper.");
  EXPECT_GT(rig.view(1).reads, 20U);
  rig.run(Seconds{2});
  EXPECT_EQ(rig.view(1).command->mode, wire::CommandMode::Stop);
  EXPECT_EQ(rig.view(1).command->status, CommandStatus::Done);
}

TEST(Supervisor, drivesThreeVehiclesOnOneChannel) {
  SupervisorRig rig{"three.tessera.json"};
  const char* const routes[] = {"one", "two", "three"};
  for (std::uint8_t id = 1; id <= 3; ++id) rig.runRoute(id, routes[id - 1], 0.15);
  const auto done = [&] { return rig.last && rig.view(1).finished && rig.view(2).finished && rig.view(3).finished; };
  EXPECT_TRUE(rig.runUntil(done, Seconds{200}))
      << rig.view(1).doing << rig.view(2).doing << rig.view(3).doing << rig.view(3).waits;
  EXPECT_EQ(rig.air->overlaps, 0U);
}

TEST(Supervisor, writesTheSameBytesForTheSameInputs) {
  std::vector<std::uint8_t> wrote[2];
  std::vector<Event> events[2];
  for (int i = 0; i < 2; ++i) {
    SupervisorRig rig;
    rig.runRoute(1, "paper", 0.12);
    rig.run(Seconds{15});
    wrote[i] = rig.wrote;
    events[i] = rig.events;
  }
  EXPECT_GT(wrote[0].size(), 1000U);
  EXPECT_EQ(wrote[0], wrote[1]);
  EXPECT_EQ(events[0], events[1]);
}

TEST(Supervisor, refusesSitesVehiclesAndNamesThatDoNotExist) {
  const auto map = test::siteMap("paper.tessera.json");
  Config stranger;
  stranger.vehicles = {VehicleId{200}};
  EXPECT_FALSE(Supervisor::create(map, stranger).has_value());
  Config seer;
  seer.locator = "crystal ball";
  EXPECT_FALSE(Supervisor::create(map, seer).has_value());
  Config rider;
  rider.controller = "horse";
  const auto refused = Supervisor::create(map, rider);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().sentence.english().find("horse"), std::string::npos);
}

TEST(Supervisor, refusesOrdersThatCannotBeCarriedOutWithTheReason) {
  SupervisorRig rig;
  rig.runRoute(1, "moon", 0.1);
  rig.runRoute(1, "paper", 0.0);
  rig.runRoute(1, "paper", std::nan(""));
  rig.runRoute(99, "paper", 0.1);
  rig.supervisor.post(Resume{VehicleId{1}});
  rig.supervisor.post(Pause{VehicleId{1}});
  rig.run(Seconds{0.1});
  const auto refused = rig.told(EventKind::OrderRefused);
  ASSERT_EQ(refused.size(), 6U);
  EXPECT_EQ(refused[0].sentence, "AGV 1: the site has no route called \"moon\".");
  EXPECT_EQ(rig.view(1).task, Task::None);
}

TEST(Supervisor, pausesAndGoesOn) {
  SupervisorRig rig;
  rig.runRoute(1, "paper", 0.2);
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed > 0.15; }, Seconds{10}));
  rig.supervisor.post(Pause{VehicleId{1}});
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed == 0.0; }, Seconds{2}));
  rig.run(Seconds{1});
  EXPECT_EQ(rig.vehicle(1).speed, 0.0);
  EXPECT_EQ(rig.view(1).waits, "AGV 1 waits: it was told to pause.");
  rig.supervisor.post(Resume{VehicleId{1}});
  EXPECT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed > 0.15; }, Seconds{3}));
}

TEST(Supervisor, stopsAllAndNothingMovesAgainByItself) {
  SupervisorRig rig{"three.tessera.json"};
  rig.runRoute(1, "one", 0.2);
  rig.runRoute(2, "two", 0.2);
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed > 0.15 && rig.vehicle(2).speed > 0.15; }, Seconds{10}));
  EXPECT_FALSE(rig.supervisor.allStopped());
  rig.supervisor.post(StopAll{});
  ASSERT_TRUE(rig.runUntil([&] { return rig.supervisor.allStopped(); }, Seconds{3}));
  EXPECT_EQ(rig.vehicle(1).speed, 0.0);
  EXPECT_EQ(rig.vehicle(2).speed, 0.0);
  rig.vehicle(1).restart();
  rig.unplug();
  rig.run(Seconds{1});
  rig.plug();
  rig.run(Seconds{5});
  EXPECT_EQ(rig.view(1).contact, Contact::Connected);
  EXPECT_EQ(rig.vehicle(1).speed, 0.0);
  EXPECT_EQ(rig.view(1).task, Task::Stopped);
}

TEST(Supervisor, answersAnAskWithASentence) {
  SupervisorRig rig;
  rig.run(Seconds{2});
  rig.supervisor.post(Ask{VehicleId{1}, {wire::MessageType::Set, 7, 250}});
  ASSERT_TRUE(rig.runUntil([&] { return !rig.told(EventKind::Answer).empty(); }, Seconds{2}));
  EXPECT_EQ(rig.told(EventKind::Answer)[0].sentence,
            "AGV 1, setting the stop distance to 250 mm: done, the value is 250 mm.");
}

}  // namespace
}  // namespace tessera::supervisor
