#include "scenario/scenario.h"

namespace tessera::scenario {
namespace {

// Fails the test with the sentence and ends it: without its parts a scenario cannot go on.
template <class T>
T expectValue(Result<T> result) {
  if (!result) throw std::runtime_error{result.error().sentence};
  return std::move(*result);
}

}  // namespace

Scenario::Scenario(ScenarioSetup setup) : setup_{std::move(setup)} {
  floor::Site site = expectValue(floor::loadSite(std::string{TESSERA_SITES} + "/" + setup_.site));
  setup_.change(site);
  if (setup_.world.airRate) site.radio.airRate = *setup_.world.airRate;
  setup_.world.seed = setup_.seed;
  supervisor::Config config;
  config.locator = setup_.locator;
  config.controller = setup_.controller;
  config.seed = setup_.seed;
  config.byMagneticMap = setup_.byMagneticMap;
  config.offeredKeys = setup_.offeredKeys;
  for (const auto& a : setup_.assignments) {
    config.vehicles.push_back(a.vehicle);
    setup_.world.vehicles.push_back(a.vehicle.value);
  }
  made_ = std::make_unique<world::MadeWorld>(expectValue(world::makeWorld(setup_.world, site, Seconds{})));
  if (setup_.wrongKey) {
    for (auto& vehicle : site.vehicles) vehicle.key[0] ^= 0xFF;
  }
  map_ = expectValue(floor::SiteMap::build(std::move(site)));
  supervisor_ = std::make_unique<supervisor::Supervisor>(expectValue(supervisor::Supervisor::create(map_, config)));
  if (auto started = made_->world->startAll(); !started) throw std::runtime_error{started.error().sentence};
  recorder_ = std::make_unique<experiment::Recorder>(setup_.assignments);
  lockstep_ = std::make_unique<experiment::Lockstep>(*made_->world, *supervisor_, *recorder_);
  truths_.resize(setup_.assignments.size());
}

void Scenario::orderRoutes() {
  ASSERT_TRUE(until(Seconds{30}, [this] { return recorder_->allConnected(); })) << sentences();
  for (const auto& a : setup_.assignments) supervisor_->post(supervisor::RunRoute{a.vehicle, a.route, setup_.speed});
}

const supervisor::VehicleView& Scenario::view(std::size_t assignment) const {
  return *lockstep_->snapshot()->find(setup_.assignments.at(assignment).vehicle);
}

MetresPerSecond Scenario::trueSpeed(VehicleId vehicle) const {
  const auto state = made_->world->truth(vehicle);
  EXPECT_TRUE(state.has_value());
  return state ? state->speed : MetresPerSecond{};
}

std::size_t Scenario::eventCount(supervisor::EventKind kind, bool over) const {
  std::size_t count = 0;
  for (const auto& e : recorder_->events()) count += e.kind == kind && e.over == over ? 1U : 0U;
  return count;
}

std::string Scenario::sentences() const {
  std::string all;
  for (const auto& e : recorder_->events())
    all += std::to_string(e.time.value()) + " s: " + e.sentence.english() + "\n";
  return all;
}

std::vector<experiment::Outcome> Scenario::outcomes() const {
  std::vector<experiment::TruthTrack> tracks;
  for (const auto& t : truths_) tracks.emplace_back(t);
  return experiment::judge(*map_, *recorder_, tracks, setup_.speed);
}

void Scenario::keepTruth() {
  for (std::size_t i = 0; i < truths_.size(); ++i) {
    const auto state = made_->world->truth(setup_.assignments[i].vehicle);
    if (state && (truths_[i].empty() || truths_[i].back().at < state->time)) {
      truths_[i].push_back({state->time, state->pose, state->speed});
    }
  }
}

}  // namespace tessera::scenario
