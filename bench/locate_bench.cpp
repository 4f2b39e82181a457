// What one vehicle's locator costs for each report: a motion, the tag events that came with it, the silence of the
// other attempts, and the estimate. Growth with particles, readers and tags, and with a rival belief beside the
// picture; the Kalman filter for comparison.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "floor/new_floor.h"
#include "floor/site_map.h"
#include "locate/kalman_locator.h"
#include "locate/particle_locator.h"

namespace {

using namespace tessera;

constexpr double kReport = 0.1;  // s
constexpr double kSpeed = 0.12;  // m/s
constexpr double kAttempt = 0.1;
constexpr double kRadius = 0.06;

struct Tick {
  locate::Motion motion;
  std::vector<std::variant<locate::TagRead, locate::TagLeft>> events;
};

floor::VehicleSetup vehicleWith(int readers) {
  floor::VehicleSetup vehicle;
  vehicle.id = VehicleId{1};
  vehicle.start = Pose{{Metres{0.4}, Metres{1.0}}, Radians{}};
  for (int i = 0; i < readers; ++i) vehicle.readers.push_back({Metres{0.15}, Metres{0.05 * (0.5 * (readers - 1) - i)}});
  return vehicle;
}

// Tiles of eight tags side by side.
std::shared_ptr<const floor::SiteMap> mapOf(int tags) {
  const int side = std::max(6, static_cast<int>(std::lround(std::sqrt(tags / 8.0))));
  floor::Site site = floor::layNewFloor({"bench", floor::usualTileTypes().front(), side, side, true}).value();
  int number = 0;
  for (floor::Tile& tile : site.tiles) {
    for (floor::TagUid& uid : tile.uids) {
      ++number;
      const std::array<std::uint8_t, 4> bytes{4, static_cast<std::uint8_t>(number >> 16),
                                              static_cast<std::uint8_t>(number >> 8),
                                              static_cast<std::uint8_t>(number)};
      uid = *floor::TagUid::fromBytes(bytes);
    }
  }
  return floor::SiteMap::build(std::move(site)).value();
}

// A straight drive of 20 s over the tags, as a vehicle tells it.
std::vector<Tick> driveOver(const floor::SiteMap& map, const floor::VehicleSetup& vehicle) {
  std::vector<Tick> ticks;
  std::vector<std::optional<floor::TagUid>> held(vehicle.readers.size());
  for (int i = 0; i < 200; ++i) {
    const double at = kReport * i;
    const double x = kSpeed * at;
    Tick tick{{Seconds{at}, Metres{x}, MetresPerSecond{kSpeed}, Radians{0.02 * std::sin(0.3 * at)}}, {}};
    for (std::size_t r = 0; r < held.size(); ++r) {
      std::optional<floor::TagUid> seen;
      const Point place = placeOf(Pose{{Metres{0.4 + x}, Metres{1.0}}, Radians{}}, vehicle.readers[r]);
      map.forEachNear(place, Metres{kRadius}, [&](const floor::PlacedTag& tag) { seen = tag.uid; });
      const int reader = static_cast<int>(r);
      if (held[r] && held[r] != seen) tick.events.emplace_back(locate::TagLeft{reader, Seconds{at - kAttempt}});
      if (seen && held[r] != seen) tick.events.emplace_back(locate::TagRead{reader, *seen, Seconds{at}});
      held[r] = seen;
    }
    ticks.push_back(std::move(tick));
  }
  return ticks;
}

/// upset, where it is given, is done after each report, unmeasured.
void run(benchmark::State& state, locate::Locator& locator, const std::vector<Tick>& ticks,
         const floor::VehicleSetup& vehicle, const std::function<void(const Tick&)>& upset = {}) {
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == ticks.size()) {
      state.PauseTiming();
      locator.reset(vehicle.start);
      i = 0;
      state.ResumeTiming();
    }
    const Tick& tick = ticks[i++];
    locator.add(tick.motion);
    for (const auto& event : tick.events) std::visit([&](const auto& e) { locator.add(e); }, event);
    locator.told(tick.motion.at - Seconds{kReport}, tick.motion.at);
    benchmark::DoNotOptimize(locator.at(locator.lastMotion()));
    if (!upset) continue;
    state.PauseTiming();
    upset(tick);
    state.ResumeTiming();
  }
}

void particles(benchmark::State& state) {
  const auto vehicle = vehicleWith(static_cast<int>(state.range(1)));
  const auto map = mapOf(static_cast<int>(state.range(2)));
  locate::ParticleOptions options;
  options.count = static_cast<std::size_t>(state.range(0));
  locate::ParticleLocator locator{map, vehicle, options};
  run(state, locator, driveOver(*map, vehicle), vehicle);
}
BENCHMARK(particles)
    ->ArgNames({"particles", "readers", "tags"})
    ->Args({300, 3, 10'000})
    ->Args({600, 3, 10'000})
    ->Args({1200, 3, 10'000})
    ->Args({1200, 8, 10'000})
    ->Args({600, 1, 10'000})
    ->Args({600, 8, 10'000})
    ->Args({600, 3, 288})
    ->Args({600, 3, 1'000'000})
    ->Unit(benchmark::kMicrosecond);

// A rival goes with the next read that the picture explains: so each report with one is followed by a read of a tag far
// away, which raises the next.
void particlesWithARival(benchmark::State& state) {
  const auto vehicle = vehicleWith(static_cast<int>(state.range(1)));
  const auto map = mapOf(static_cast<int>(state.range(2)));
  locate::ParticleOptions options;
  options.count = static_cast<std::size_t>(state.range(0));
  locate::ParticleLocator locator{map, vehicle, options};
  std::optional<floor::TagUid> far;
  map->forEachNear({Metres{1.5}, Metres{2.5}}, Metres{0.2}, [&](const floor::PlacedTag& tag) { far = tag.uid; });
  if (!far) return state.SkipWithError("no tag lies there");
  std::uint32_t raised = 0;
  run(state, locator, driveOver(*map, vehicle), vehicle, [&](const Tick& tick) {
    const auto isRead = [](const auto& event) { return std::holds_alternative<locate::TagRead>(event); };
    // One that contradicts while the vehicle has not moved yet is a new start.
    if (tick.motion.travel < Metres{0.05} || std::none_of(tick.events.begin(), tick.events.end(), isRead)) return;
    ++raised;
    locator.add(locate::TagRead{0, *far, tick.motion.at});
    locator.add(locate::TagLeft{0, tick.motion.at});
  });
  if (locator.counters().reacquisitions > 0 || locator.counters().rejected < raised * 9 / 10)
    state.SkipWithError("the rival took over, or was not raised");
}
BENCHMARK(particlesWithARival)
    ->ArgNames({"particles", "readers", "tags"})
    ->Args({1200, 3, 10'000})
    ->Args({1200, 8, 10'000})
    ->Unit(benchmark::kMicrosecond);

void kalman(benchmark::State& state) {
  const auto vehicle = vehicleWith(static_cast<int>(state.range(0)));
  const auto map = mapOf(10'000);
  locate::KalmanLocator locator{map, vehicle};
  run(state, locator, driveOver(*map, vehicle), vehicle);
}
BENCHMARK(kalman)->ArgNames({"readers"})->Arg(1)->Arg(3)->Arg(8)->Unit(benchmark::kMicrosecond);

}  // namespace
