// Zones bind whoever drives: speeds of slow zones, and one vehicle at a time where only one may be. Judged by the true
// places of the bodies, which the supervisor does not see.
#include <set>

#include "region/region.h"
#include "scenario/scenario.h"
#include "traffic/body_box.h"

namespace tessera::scenario {
namespace {

using floor::ZoneKind;

Point place(double x, double y) { return {Metres{x}, Metres{y}}; }
floor::Zone zoneOf(ZoneKind kind, const char* name, double x0, double y0, double x1, double y1) {
  return {name, kind, {place(x0, y0), place(x1, y0), place(x1, y1), place(x0, y1)}, {}, {}};
}

/// The zones in which a part of the vehicle's true body is.
std::set<std::string> under(Scenario& scenario, const floor::Site& site, VehicleId id) {
  std::set<std::string> names;
  const auto truth = scenario.world().truth(id);
  const auto setup =
      std::find_if(site.vehicles.begin(), site.vehicles.end(), [&](const auto& v) { return v.id == id; });
  if (!truth || setup == site.vehicles.end()) return names;
  const auto body = region::Region::of(traffic::bodyBoxOf(*setup).at(truth->pose));
  for (const floor::Zone& zone : site.zones)
    if (zone.kind != ZoneKind::Running && !(body & region::Region::of(zone.outline)).empty()) names.insert(zone.name);
  return names;
}

class Zones : public testing::Test {
protected:
  void build(const std::function<void(floor::Site&)>& change, double speed = 0.20) {
    ScenarioSetup setup;
    setup.site = "three.tessera.json";
    setup.assignments = {{VehicleId{1}, "one"}, {VehicleId{2}, "two"}};
    setup.speed = MetresPerSecond{speed};
    setup.change = [&](floor::Site& s) {
      change(s);
      site = s;
    };
    scenario = std::make_unique<Scenario>(setup);
  }
  /// Drives to the end; how often both vehicles were in one zone, and what was said about waiting.
  void drive() {
    scenario->orderRoutes();
    const bool done = scenario->until(Seconds{400}, [this] {
      const auto first = under(*scenario, site, VehicleId{1});
      for (const std::string& name : under(*scenario, site, VehicleId{2})) together += first.contains(name) ? 1 : 0;
      for (const std::size_t i : {0U, 1U})
        if (const Sentence& why = scenario->view(i).waits; !why.empty()) said.insert(why.english());
      return scenario->finished();
    });
    std::string all;
    for (const std::string& why : said) all += why + "\n";
    ASSERT_TRUE(done) << scenario->sentences() << all;
  }

  floor::Site site;
  std::unique_ptr<Scenario> scenario;
  int together = 0;
  std::set<std::string> said;
};

TEST_F(Zones, ofASingleVehicleAreDrivenThroughByOneAfterTheOther) {
  build([](floor::Site& s) { s.zones.push_back(zoneOf(ZoneKind::SingleVehicle, "gate", 0.1, 0.9, 2.3, 1.3)); });
  drive();
  EXPECT_EQ(together, 0);
  EXPECT_TRUE(said.contains("AGV 2 waits before the single-vehicle zone gate: AGV 1 drives through it."));
  EXPECT_TRUE(said.contains("AGV 2 waits before the single-vehicle zone gate: AGV 1 is in it."));
}

TEST_F(Zones, ofASingleVehicleThatNobodyMindsAreEnteredByBothAtOnce) {
  // The same drive: without the zone both are there together, or the test above would prove nothing.
  build([](floor::Site& s) { s.zones.push_back(zoneOf(ZoneKind::Parking, "gate", 0.1, 0.9, 2.3, 1.3)); });
  drive();
  EXPECT_GT(together, 0);
  for (const std::string& why : said) EXPECT_EQ(why.find("zone"), std::string::npos) << why;
}

TEST_F(Zones, thatOverlapAreDrivenThroughFromBothEndsWithoutStandingInEachOthersWay) {
  build([](floor::Site& s) {
    s.zones.push_back(zoneOf(ZoneKind::SingleVehicle, "south", 0.1, 0.9, 2.2, 1.5));
    s.zones.push_back(zoneOf(ZoneKind::SingleVehicle, "north", 0.1, 1.3, 2.2, 2.1));
    s.routes[1].vertices = {place(2, 0.4), place(2.8, 0.4), place(2.8, 3.2), place(2, 3.2), place(2, 0.4)};
    s.routes[1].legSpeeds.clear();
  });
  drive();
  EXPECT_EQ(together, 0);
  EXPECT_FALSE(said.empty()) << "they meet";
}

TEST_F(Zones, thatAreSlowAreDrivenThroughNoFasterWithAnyPartOfTheBody) {
  static constexpr double kSlow = 0.08;
  build([](floor::Site& s) {
    s.zones.push_back(zoneOf(ZoneKind::Slow, "people", 0.0, 1.5, 4.8, 1.9));
    s.zones.back().speed = MetresPerSecond{kSlow};
  });
  scenario->orderRoutes();
  double inside = 0;
  double outside = 0;
  ASSERT_TRUE(scenario->until(Seconds{400}, [&] {
    for (const VehicleId id : {VehicleId{1}, VehicleId{2}}) {
      double& top = under(*scenario, site, id).empty() ? outside : inside;
      top = std::max(top, scenario->trueSpeed(id).value());
    }
    return scenario->finished();
  })) << scenario->sentences();
  RecordProperty("top_speed_inside_cm_s", std::to_string(100 * inside));
  EXPECT_LE(inside, kSlow + 0.015) << "but for what its speed control overshoots";
  EXPECT_GE(inside, kSlow - 0.01) << "no slower than it has to be";
  EXPECT_GE(outside, 0.18);
}

}  // namespace
}  // namespace tessera::scenario
