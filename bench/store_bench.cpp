// What keeping costs: sites of some sizes, saved anew, with one route changed, and loaded; the journal, with the log
// (WAL) and with a rollback journal. The figures of docs/decisions/0009-storage.md come from here.
#include <benchmark/benchmark.h>

#include <QCoreApplication>
#include <QTemporaryDir>
#include <cstdlib>
#include <filesystem>

#include "floor/new_floor.h"
#include "store/journal.h"
#include "store/site_store.h"
#include "store/transaction.h"

namespace {

using namespace tessera;

// Tiles of eight tags in rows, as on the publication's floor.
floor::Site siteOf(std::size_t tags) {
  floor::Site site;
  site.name = "bench";
  site.tileTypes = {floor::usualTileTypes()[0]};
  for (std::size_t i = 0; i < tags / 8; ++i) {
    floor::Tile tile{"T-" + std::to_string(i), site.tileTypes.front().name, {}};
    for (std::size_t n = 0; n < 8; ++n) {
      std::array<std::uint8_t, 7> bytes{};
      std::uint64_t number = (8 * i + n) * 0x9E3779B97F4A7C15ULL;
      for (auto& b : bytes) {
        b = static_cast<std::uint8_t>(number >> 56);
        number <<= 8;
      }
      tile.uids.push_back(*floor::TagUid::fromBytes(bytes));
    }
    site.tiles.push_back(std::move(tile));
    site.placements.push_back({site.tiles.back().serial,
                               {Metres{0.6 * static_cast<double>(i % 300)}, Metres{0.6 * static_cast<double>(i / 300)}},
                               0});
  }
  site.routes.push_back({"route", {{}, {Metres{1}, Metres{1}}}, Metres{0.2}});
  return site;
}

// On the disk that holds the temporary files; TMPDIR chooses another.
struct Place {
  QTemporaryDir folder;
  std::unique_ptr<store::Database> database;
  explicit Place(bool log) {
    auto opened = store::Database::open(file(), {.writeAheadLog = log});
    if (!opened) std::abort();
    database = std::move(*opened);
  }
  [[nodiscard]] std::filesystem::path file() const { return (folder.path() + "/bench.db").toStdString(); }
};

void must(const Result<void>& result) {
  if (!result) std::abort();
}

void saveNewSite(benchmark::State& state) {
  const floor::Site site = siteOf(static_cast<std::size_t>(state.range(0)));
  Place place{state.range(1) != 0};
  int key = 0;
  for (auto _ : state) must(store::SiteStore{*place.database}.save(std::to_string(key++), site, 1, true));
  place.database.reset();  // brings the log into the file
  state.counters["MB"] = static_cast<double>(std::filesystem::file_size(place.file())) / 1e6 / key;
}
BENCHMARK(saveNewSite)
    ->ArgsProduct({{2'500, 40'000, 1'000'000}, {1, 0}})
    ->ArgNames({"tags", "log"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// A row for each tag, or one for each tile with the tags' UIDs in a row of bytes: what was weighed.
void insertTags(benchmark::State& state) {
  const floor::Site site = siteOf(1'000'000);
  const bool packed = state.range(0) != 0;
  Place place{true};
  {
    store::Transaction making{*place.database, store::Transaction::Kind::Write};
    making.run(
        QStringLiteral("CREATE TABLE t(site INTEGER, tile INTEGER, nr INTEGER, uid BLOB,"
                       " PRIMARY KEY(site, tile, nr)) WITHOUT ROWID"));
    must(making.commit());
  }
  const auto bytesOf = [](const floor::TagUid& uid) {
    return QByteArray{reinterpret_cast<const char*>(uid.bytes().data()), static_cast<qsizetype>(uid.bytes().size())};
  };
  qint64 key = 0;
  for (auto _ : state) {
    store::Transaction writing{*place.database, store::Transaction::Kind::Write};
    {
      store::Statement insert{writing, QStringLiteral("INSERT INTO t VALUES(?,?,?,?)")};
      for (std::size_t tile = 0; tile < site.tiles.size(); ++tile) {
        QByteArray all;
        for (std::size_t n = 0; n < site.tiles[tile].uids.size(); ++n) {
          if (packed)
            all += bytesOf(site.tiles[tile].uids[n]);
          else
            insert.run({key, static_cast<qint64>(tile), static_cast<qint64>(n), bytesOf(site.tiles[tile].uids[n])});
        }
        if (packed) insert.run({key, static_cast<qint64>(tile), 0, all});
      }
    }
    must(writing.commit());
    ++key;
  }
}
BENCHMARK(insertTags)->Arg(0)->Arg(1)->ArgName("packed")->Unit(benchmark::kMillisecond)->UseRealTime();

void saveOneRouteChanged(benchmark::State& state) {
  floor::Site site = siteOf(static_cast<std::size_t>(state.range(0)));
  Place place{state.range(1) != 0};
  double x = 0.0;
  must(store::SiteStore{*place.database}.save("k", site, 1, true));
  for (auto _ : state) {
    site.routes[0].vertices[1].x = Metres{x += 1.0};
    must(store::SiteStore{*place.database}.save("k", site, 1, true));
  }
}
BENCHMARK(saveOneRouteChanged)
    ->ArgsProduct({{2'500, 40'000, 1'000'000}, {1, 0}})
    ->ArgNames({"tags", "log"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// A tag is registered after the other, and each is on the disk before the next one.
void saveOneTagMore(benchmark::State& state) {
  floor::Site site = siteOf(static_cast<std::size_t>(state.range(0)));
  Place place{true};
  store::LastWritten last;
  store::SiteStore sites{*place.database};
  std::uint8_t number = 0;
  const auto keep = [&] {
    must(sites.save("k", floor::SiteMap::build(site, floor::Ambiguity::Carried).value(), 1, true, last));
  };
  keep();
  for (auto _ : state) {
    state.PauseTiming();
    std::swap(site.tiles[number].uids[0], site.tiles[number + std::size_t{1}].uids[0]);
    ++number;
    const auto map = floor::SiteMap::build(site, floor::Ambiguity::Carried).value();
    state.ResumeTiming();
    must(sites.save("k", map, 1, true, last));
  }
}
BENCHMARK(saveOneTagMore)->Arg(2'500)->Arg(40'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

void loadSite(benchmark::State& state) {
  Place place{true};
  must(store::SiteStore{*place.database}.save("k", siteOf(static_cast<std::size_t>(state.range(0))), 1, true));
  for (auto _ : state) benchmark::DoNotOptimize(store::SiteStore{*place.database}.load("k").value());
}
BENCHMARK(loadSite)->Arg(2'500)->Arg(40'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

// Opening checks the pages of the whole file.
void openFile(benchmark::State& state) {
  Place place{true};
  must(store::SiteStore{*place.database}.save("k", siteOf(static_cast<std::size_t>(state.range(0))), 1, true));
  place.database.reset();
  for (auto _ : state) benchmark::DoNotOptimize(store::Database::open(place.file()).value());
}
BENCHMARK(openFile)->Arg(2'500)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

std::vector<store::Note> notesOf(std::size_t count) {
  std::vector<store::Note> notes(count);
  for (store::Note& note : notes) {
    note.site = "bench";
    note.event.sentence = "Vehicle 3 (cart) drives along the route \"paper\" at 0.12 m/s.";
  }
  return notes;
}

void appendToJournal(benchmark::State& state) {
  Place place{state.range(1) != 0};
  const auto notes = notesOf(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) must(store::Journal{*place.database}.append(notes));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(appendToJournal)
    ->ArgsProduct({{1, 100, 10'000}, {1, 0}})
    ->ArgNames({"notes", "log"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// The worst question to a journal of a million lines: a text that nowhere stands.
void searchJournal(benchmark::State& state) {
  Place place{true};
  for (int i = 0; i < 20; ++i) must(store::Journal{*place.database}.append(notesOf(50'000)));
  store::JournalFilter filter;
  filter.text = state.range(0) != 0 ? "nowhere" : "";
  for (auto _ : state) benchmark::DoNotOptimize(store::Journal{*place.database}.query(filter).value());
}
BENCHMARK(searchJournal)->Arg(0)->Arg(1)->ArgName("text")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application{argc, argv};
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
