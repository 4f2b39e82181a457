// What a site of some sizes costs: reading its file, making its map, looking tags up, checking it, and checking it
// again after an edit. The figures of docs/decisions/0012-site-check.md come from here.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "floor/site_map.h"
#include "sitecheck/site_checker.h"

namespace {

using namespace tessera;

// Tiles of eight tags side by side, as on the publication's floor; some routes across.
floor::Site siteOf(std::size_t tags) {
  const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(tags) / 8.0)));
  floor::Site site = floor::layNewFloor({"bench", floor::usualTileTypes().front(), side, side, true}).value();
  const double far = 0.6 * side - 0.5;
  for (int i = 0; i < 20; ++i) {
    const double y = 0.5 + (far - 0.5) * i / 20;
    site.routes.push_back({"R" + std::to_string(i),
                           {{Metres{0.5}, Metres{y}}, {Metres{far}, Metres{y}}, {Metres{far}, Metres{far}}},
                           Metres{0.2}});
  }
  return site;
}

std::shared_ptr<const floor::Site> kept(floor::Site site) {
  return std::make_shared<const floor::Site>(std::move(site));
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int tags : {2'500, 40'000, 1'000'000}) b->Arg(tags);
}

void parse(benchmark::State& state) {
  const std::string text = writeSite(siteOf(static_cast<std::size_t>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(floor::parseSite(text, "bench"));
  state.counters["MB"] = static_cast<double>(text.size()) / 1e6;
}
BENCHMARK(parse)->Apply(sizes)->Unit(benchmark::kMillisecond);

void build(benchmark::State& state) {
  const floor::Site site = siteOf(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(floor::SiteMap::build(site));
}
BENCHMARK(build)->Apply(sizes)->Unit(benchmark::kMillisecond);

void find(benchmark::State& state) {
  const auto map = floor::SiteMap::build(siteOf(static_cast<std::size_t>(state.range(0)))).value();
  std::mt19937_64 random{1};
  std::vector<floor::TagUid> asked;
  for (int i = 0; i < 4096; ++i) asked.push_back(map->tags()[random() % map->tags().size()].uid);
  std::size_t at = 0;
  for (auto _ : state) benchmark::DoNotOptimize(map->find(asked[at++ % asked.size()]));
}
BENCHMARK(find)->Apply(sizes);

void near(benchmark::State& state) {
  const auto map = floor::SiteMap::build(siteOf(static_cast<std::size_t>(state.range(0)))).value();
  std::mt19937_64 random{1};
  std::vector<Point> asked;
  for (int i = 0; i < 4096; ++i) asked.push_back(map->tags()[random() % map->tags().size()].place);
  std::size_t at = 0;
  std::size_t seen = 0;
  for (auto _ : state)
    map->forEachNear(asked[at++ % asked.size()], Metres{0.2}, [&seen](const floor::PlacedTag&) { ++seen; });
  benchmark::DoNotOptimize(seen);
}
BENCHMARK(near)->Apply(sizes);

void check(benchmark::State& state) {
  const floor::Site site = siteOf(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(sitecheck::checkSite(site));
}
BENCHMARK(check)->Apply(sizes)->Unit(benchmark::kMillisecond);

void disorder(floor::Site& site) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> off{-0.02, 0.02};
  for (auto& tile : site.tiles) tile.uids.clear();
  for (auto& p : site.placements) p.origin = p.origin + Offset{Metres{off(random)}, Metres{off(random)}};
}

// The same where no tile has a UID and each lies a little off the next: faults without end.
void checkBad(benchmark::State& state) {
  floor::Site site = siteOf(static_cast<std::size_t>(state.range(0)));
  disorder(site);
  for (auto _ : state) benchmark::DoNotOptimize(sitecheck::checkSite(site));
}
BENCHMARK(checkBad)->Apply(sizes)->Unit(benchmark::kMillisecond);

template <class Edit>
void again(benchmark::State& state, Edit edit, bool bad = false) {
  floor::Site site = siteOf(static_cast<std::size_t>(state.range(0)));
  if (bad) disorder(site);
  floor::Site edited = site;
  edit(edited);
  const auto one = kept(site);
  const auto other = kept(edited);
  sitecheck::SiteChecker checker;
  checker.check(one);
  bool second = true;
  for (auto _ : state) {
    benchmark::DoNotOptimize(checker.check(second ? other : one).size());
    second = !second;
  }
}
void againRoute(benchmark::State& state) {
  again(state, [](floor::Site& s) { s.routes[3].vertices[1].y += Metres{0.1}; });
}
void againUid(benchmark::State& state) {
  again(state, [](floor::Site& s) { s.tiles[3].uids[1] = {}; });
}
void againTile(benchmark::State& state) {
  again(state, [](floor::Site& s) { s.placements[3].origin.x += Metres{0.01}; });
}
void againTileBad(benchmark::State& state) {
  again(
      state, [](floor::Site& s) { s.placements[3].origin.x += Metres{0.01}; }, true);
}
// Ten tiles more, as they are laid: known and not registered yet.
void againLaid(benchmark::State& state) {
  again(state, [](floor::Site& s) {
    for (int n = 0; n < 10; ++n) {
      s.tiles.push_back({"new " + std::to_string(n), s.tiles.front().type, {}});
      s.placements.push_back({s.tiles.back().serial, {Metres{0.6 * n}, Metres{-0.6}}, 0});
    }
  });
}
BENCHMARK(againRoute)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(againUid)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(againTile)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(againTileBad)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(againLaid)->Apply(sizes)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
