// What the loop's parts cost: looking tags up, sealing and reading frames, and a second of the whole loop.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <unordered_map>

#include "app/experiment/lockstep.h"
#include "app/world/make_world.h"
#include "floor/site_json.h"
#include "wire/messages.h"
#ifdef TESSERA_ROBIN_MAP
#include <tsl/robin_map.h>
#endif

namespace {

using namespace tessera;

// A square of loose tags, 15 cm apart, with 7-byte UIDs in random order of numbers.
std::shared_ptr<const floor::SiteMap> floorOf(std::size_t tags, std::vector<floor::TagUid>& uids) {
  std::mt19937_64 random{1};
  floor::Site site;
  site.name = "bench";
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(tags)));
  for (std::size_t i = 0; i < side * side; ++i) {
    std::array<std::uint8_t, 7> bytes{};
    std::uint64_t number = (random() << 20) | i;  // the low bits keep them apart
    for (auto& b : bytes) {
      b = static_cast<std::uint8_t>(number);
      number >>= 8;
    }
    uids.push_back(*floor::TagUid::fromBytes(bytes));
    const std::size_t row = i / side;
    const std::size_t column = i % side;
    site.looseTags.push_back(
        {uids.back(), {Metres{0.15 * static_cast<double>(column)}, Metres{0.15 * static_cast<double>(row)}}});
  }
  std::shuffle(uids.begin(), uids.end(), random);
  return *floor::SiteMap::build(std::move(site));
}

void lookUpTag(benchmark::State& state) {
  std::vector<floor::TagUid> uids;
  const auto map = floorOf(static_cast<std::size_t>(state.range(0)), uids);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(map->find(uids[i]));
    i = i + 1 == uids.size() ? 0 : i + 1;
  }
}
BENCHMARK(lookUpTag)->Arg(10'000)->Arg(100'000)->Arg(1'000'000);

// Other tables with the same tags, for comparison. They are asked for the same: the tag's place, where it is known.
template <class Table>
void lookUpTagIn(benchmark::State& state) {
  std::vector<floor::TagUid> uids;
  const auto map = floorOf(static_cast<std::size_t>(state.range(0)), uids);
  Table table;
  for (const auto& tag : map->tags()) table.emplace(tag.uid, tag.place);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto found = table.find(uids[i]);
    benchmark::DoNotOptimize(found == table.end() ? std::nullopt : std::optional{found->second});
    i = i + 1 == uids.size() ? 0 : i + 1;
  }
}
BENCHMARK(lookUpTagIn<std::unordered_map<floor::TagUid, Point>>)->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
#ifdef TESSERA_ROBIN_MAP
BENCHMARK(lookUpTagIn<tsl::robin_map<floor::TagUid, Point>>)->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
#endif

void sealCycleForFourVehicles(benchmark::State& state) {
  const wire::Key key{1, 2, 3};
  std::array<std::uint8_t, wire::kMaxFrame> out{};
  std::uint32_t counter = 0;
  for (auto _ : state) {
    wire::CycleWriter writer{10, ++counter};
    for (std::uint8_t v = 1; v <= 4; ++v) writer.add({v, wire::CommandMode::Drive, 120, 0, 25, 0}, key);
    benchmark::DoNotOptimize(writer.finish(out));
  }
}
BENCHMARK(sealCycleForFourVehicles);

void readAndCheckReport(benchmark::State& state) {
  const wire::Key key{1, 2, 3};
  std::array<std::uint8_t, wire::kMaxPayload> body{};
  std::array<std::uint8_t, wire::kMaxFrame> frame{};
  const std::size_t n = wire::encode(wire::Report{}, body);
  const wire::FrameHeader header{0, 1, static_cast<std::uint8_t>(wire::MessageType::Report), 0};
  const std::size_t size = wire::sealFrame(key, 7, header, wire::Bytes{body}.first(n), frame);
  wire::FrameDecoder decoder;
  for (auto _ : state) {
    decoder.feed(wire::Bytes{frame}.first(size), [&](const wire::Frame& f) {
      wire::ReplayGuard guard{6};
      const auto parts = wire::splitMac(f.payload);
      benchmark::DoNotOptimize(guard.accept(key, f.header, parts->body, parts->mac));
      benchmark::DoNotOptimize(wire::decodeReport(parts->body));
    });
  }
}
BENCHMARK(readAndCheckReport);

// One second of the whole loop: world, air, firmware and supervisor; the argument is the number of vehicles driving.
void secondOfTheLoop(benchmark::State& state) {
  floor::Site site = *floor::loadSite(TESSERA_SITES "/three.tessera.json");
  site.vehicles.resize(static_cast<std::size_t>(state.range(0)));
  auto made = world::makeWorld(world::WorldOptions{}, site, Seconds{});
  const auto map = *floor::SiteMap::build(site);
  auto supervisor = supervisor::Supervisor::create(map, {});
  if (!made || !supervisor || !made->world->startAll()) return state.SkipWithError("the world could not be made");
  std::vector<experiment::Assignment> assignments;
  for (std::size_t i = 0; i < site.vehicles.size(); ++i)
    assignments.push_back({site.vehicles[i].id, site.routes[i].name});
  experiment::Recorder recorder{assignments};
  experiment::Lockstep lockstep{*made->world, *supervisor, recorder};
  (void)lockstep.run(Seconds{60}, [&] { return recorder.allConnected(); });
  const auto order = [&] {
    for (const auto& a : assignments) supervisor->post(supervisor::RunRoute{a.vehicle, a.route, MetresPerSecond{0.1}});
  };
  order();
  for (auto _ : state) {
    (void)lockstep.run(lockstep.now() + Seconds{1}, [] { return false; });
    if (recorder.allFinished()) order();
  }
}
BENCHMARK(secondOfTheLoop)->DenseRange(1, 3)->Unit(benchmark::kMillisecond)->Iterations(30);

}  // namespace
