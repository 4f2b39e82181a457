// A whole shop floor in virtual time for tests: vehicles with the firmware's own sources, a paced and lossy radio, the
// supervisor, and a hand that lets things go wrong. The same seed gives the same run.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/experiment/lockstep.h"
#include "app/experiment/report.h"
#include "app/world/make_world.h"
#include "floor/site_json.h"

namespace tessera::scenario {

struct ScenarioSetup {
  std::string site = "paper.tessera.json";
  std::vector<experiment::Assignment> assignments{{VehicleId{1}, "paper"}};
  MetresPerSecond speed{0.12};
  std::uint64_t seed = 1;
  world::WorldOptions world;  ///< site, vehicles and seed are filled in
  std::string locator;
  std::string controller;
  std::function<void(floor::Site&)> change = [](floor::Site&) {};  ///< to the site that world and supervisor share
  std::map<VehicleId, wire::Key> offeredKeys;                      ///< supervisor::Config::offeredKeys
  bool byMagneticMap = false;                                      ///< supervisor::Config::byMagneticMap
  bool wrongKey = false;  ///< the supervisor's site has another key for every vehicle than its EEPROM
};

class Scenario {
public:
  explicit Scenario(ScenarioSetup setup);

  /// Waits for every vehicle's session, then orders the routes.
  void orderRoutes();
  /// Goes on until the condition holds. False: it did not within `within` (virtual seconds).
  template <class Condition>
  [[nodiscard]] bool until(Seconds within, Condition&& condition) {
    return lockstep_->run(lockstep_->now() + within, [&] {
      keepTruth();
      return condition();
    });
  }
  void go(Seconds time) {
    (void)until(time, [] { return false; });
  }

  [[nodiscard]] sim::World& world() { return *made_->world; }
  [[nodiscard]] supervisor::Supervisor& supervisor() { return *supervisor_; }
  [[nodiscard]] experiment::Lockstep& lockstep() { return *lockstep_; }
  [[nodiscard]] experiment::Recorder& recorder() { return *recorder_; }
  [[nodiscard]] const supervisor::VehicleView& view(std::size_t assignment = 0) const;
  [[nodiscard]] bool finished() const { return recorder_->allFinished(); }
  /// The vehicle's true speed; an assertion fails when there is no such vehicle.
  [[nodiscard]] MetresPerSecond trueSpeed(VehicleId vehicle = VehicleId{1}) const;
  [[nodiscard]] std::size_t eventCount(supervisor::EventKind kind, bool over = false) const;
  [[nodiscard]] std::string sentences() const;  ///< all events, a line each, for a failure's message
  [[nodiscard]] std::vector<experiment::Outcome> outcomes() const;

private:
  void keepTruth();

  ScenarioSetup setup_;
  std::shared_ptr<const floor::SiteMap> map_;
  std::unique_ptr<world::MadeWorld> made_;
  std::unique_ptr<supervisor::Supervisor> supervisor_;
  std::unique_ptr<experiment::Recorder> recorder_;
  std::unique_ptr<experiment::Lockstep> lockstep_;
  std::vector<std::vector<experiment::Truth>> truths_;
};

}  // namespace tessera::scenario
