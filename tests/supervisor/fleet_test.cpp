// Many vehicles on one channel.
#include <gtest/gtest.h>

#include <algorithm>

#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

std::shared_ptr<const floor::SiteMap> siteOf(std::uint8_t count) {
  floor::Site site = test::siteMap("paper.tessera.json")->site();
  const floor::VehicleSetup first = site.vehicles[0];
  site.vehicles.clear();
  for (std::uint8_t id = 1; id <= count; ++id) {
    floor::VehicleSetup v = first;
    v.id = VehicleId{id};
    v.name = "AGV " + std::to_string(id);
    v.key[0] = id;
    site.vehicles.push_back(v);
  }
  return floor::SiteMap::build(std::move(site)).value();
}

TEST(Fleet, ofTenSharesOneChannelAndStandsWhenAllAreStopped) {
  test::SupervisorRig rig{siteOf(10)};
  const auto all = [&](auto&& holds) {
    return rig.last && std::all_of(rig.last->vehicles.begin(), rig.last->vehicles.end(), holds);
  };
  ASSERT_TRUE(rig.runUntil([&] { return all([](const VehicleView& v) { return v.contact == Contact::Connected; }); },
                           Seconds{60}));
  for (std::uint8_t id = 1; id <= 10; ++id) rig.runRoute(id, "paper", 0.1);
  EXPECT_TRUE(
      rig.runUntil([&] { return all([](const VehicleView& v) { return v.progress > Metres{0.3}; }); }, Seconds{60}));
  EXPECT_EQ(rig.air->overlaps, 0U);
  rig.supervisor.post(StopAll{});
  EXPECT_TRUE(rig.runUntil([&] { return rig.supervisor.allStopped(); }, Seconds{20}));
  EXPECT_EQ(rig.told(EventKind::StoppedAll).size(), 1U) << "once, whatever each vehicle was doing";
}

TEST(Fleet, ofAHundredIsSeenWholeThoughOneChannelIsTooSmallForIt) {
  test::SupervisorRig rig{siteOf(100)};
  rig.run(Seconds{5});
  ASSERT_EQ(rig.last->vehicles.size(), 100U);
  for (std::uint8_t id = 1; id <= 100; ++id) EXPECT_EQ(rig.view(id).name, "AGV " + std::to_string(id));
  EXPECT_TRUE(std::any_of(rig.last->vehicles.begin(), rig.last->vehicles.end(),
                          [](const VehicleView& v) { return v.contact == Contact::Connected; }));
}

}  // namespace
}  // namespace tessera::supervisor
