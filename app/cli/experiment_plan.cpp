#include "app/cli/experiment_plan.h"

#include "app/cli/magnetic_map_file.h"
#include "app/cli/port_run.h"
#include "app/world/make_world.h"
#include "drive/route_follower.h"
#include "floor/site_json.h"
#include "locate/locator.h"

namespace tessera::cli {
namespace {

// The method that was asked for; by default the first there is.
std::string nameOr(const std::string& asked, std::span<const std::string_view> names) {
  return asked.empty() ? std::string{names.front()} : asked;
}

}  // namespace

Result<ExperimentPlan> planOf(const ExperimentWords& words) {
  auto site = floor::loadSite(words.world.site);
  if (!site) return tl::unexpected{site.error()};
  // The world's vehicles and radios and what the supervisor is told of them are alike, as an integrator would.
  world::applyTo(*site, words.world);
  if (words.cornerCut)
    for (floor::VehicleSetup& vehicle : site->vehicles) vehicle.cornerCut = Metres{*words.cornerCut};
  auto map = floor::SiteMap::build(std::move(*site));
  if (!map) return failure(words.world.site + ": " + map.error().sentence.english());
  ExperimentPlan plan;
  plan.map = *map;
  plan.speed = MetresPerSecond{words.speed};
  std::vector<std::string> drives = words.drives;
  if (!words.route.empty()) {
    if (plan.map->site().vehicles.empty()) return failure(words.world.site + " has no vehicle.");
    drives.push_back(std::to_string(plan.map->site().vehicles.front().id.value) + "=" + words.route);
  }
  auto assignments = parseAssignments(drives, *plan.map);
  if (!assignments) return tl::unexpected{assignments.error()};
  plan.assignments = std::move(*assignments);
  for (const experiment::Assignment& one : plan.assignments) plan.config.vehicles.push_back(one.vehicle);
  plan.config.locator = words.estimator;
  plan.config.controller = words.controller;
  plan.config.seed = words.world.seed;
  if (auto known = takeMagneticMap(words.magneticMap, plan.config); !known) return tl::unexpected{known.error()};
  plan.limit = words.limit > 0 ? Seconds{words.limit} : generousLimit(*plan.map, plan.assignments, plan.speed);
  return plan;
}

nlohmann::json optionsOf(const ExperimentWords& words, const ExperimentPlan& plan) {
  nlohmann::json options{{"site", words.world.site},
                         {"vehicle", words.kind},
                         {"speed_m_per_s", words.speed},
                         {"seed", words.world.seed},
                         {"floor_seed", words.world.floorSeed.value_or(words.world.seed)},
                         {"lockstep", words.lockstep},
                         {"estimator", nameOr(words.estimator, locate::locatorNames())},
                         {"controller", nameOr(words.controller, drive::followerNames())},
                         {"air_rate_bit_per_s", plan.map->site().radio.airRate},
                         {"air_factor", words.world.airFactor},
                         {"loss", words.world.loss},
                         {"delay_s", words.world.delay},
                         {"corrupt", words.world.corrupt},
                         {"drop", words.world.drop},
                         {"replay", words.world.replay},
                         {"dead_tags", words.world.deadTags.value_or(0.0)},
                         {"carry_s", words.carry},
                         {"limit_s", plan.limit.value()},
                         {"magnetic_map", words.magneticMap},
                         {"eeprom_dir", words.world.eepromDir},
                         {"firmware", words.world.firmware}};
  if (const auto* setup = plan.map->vehicle(plan.assignments.front().vehicle)) {
    const sim::BodyParameters body = world::bodyFor(*setup, words.world);
    options["corner_cut_m"] = setup->cornerCut.value();
    options["readers"] = setup->readers.size();
    options["radius_m"] = setup->readerRadius.value();
    options["true_radius_m"] = body.readers.radius.value();
    options["poll_s"] = body.readers.pollPeriod.value();
    options["read_time_s"] = body.readers.readTime.value();
    options["detection"] = body.readers.detection;
    options["compass_noise_deg"] = degrees(Radians{body.compass.noise / sim::kEarthHorizontal});
    options["compass_bias_deg"] = degrees(body.compass.bias);
    options["compass_spots_deg"] = words.world.compassSpots.value_or(degrees(sim::kSpotDeviation));
    options["slip"] = body.plant.slip;
    options["tyre_difference"] = body.plant.tyreDifference;
    // Null: as the firmware comes.
    options["heading_learning_m"] = body.headingLearning ? nlohmann::json(body.headingLearning->value()) : nullptr;
    options["speed_noise"] = body.plant.speedNoise;
    options["speed_noise_time_s"] = body.plant.speedNoiseMemory.value();
  }
  // Where the true poses were written says nothing about the run.
  world::WorldOptions world = words.world;
  world.truth.clear();
  options["world_arguments"] = world::worldArguments(world);
  return options;
}

}  // namespace tessera::cli
