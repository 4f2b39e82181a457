// What revisions of a site weigh and cost: bench_revision [tiles]. The figures of the decision on revisions come from
// here. Times are the least of some runs, in milliseconds of this thread's processor.
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QSet>
#include <QTemporaryDir>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "store/revision_parts.h"
#include "store/revisions.h"
#include "ui/history/comparison.h"

namespace {

using namespace tessera;

// Tiles of eight tags with UIDs that have nothing in common: the worst for a compressor.
floor::Site hall(std::size_t tiles) {
  floor::Site site;
  site.name = "hall";
  site.tileTypes = {floor::usualTileTypes()[0]};
  for (std::size_t i = 0; i < tiles; ++i) {
    floor::Tile tile{"T-" + std::to_string(i), site.tileTypes.front().name, {}};
    for (std::size_t n = 0; n < 8; ++n) {
      std::array<std::uint8_t, 7> bytes{};
      std::uint64_t number = (8 * i + n + 1) * 0x9E3779B97F4A7C15ULL;
      for (auto& b : bytes) {
        b = static_cast<std::uint8_t>(number >> 56);
        number <<= 8;
      }
      tile.uids.push_back(*floor::TagUid::fromBytes(bytes));
    }
    site.placements.push_back(
        {tile.serial, {Metres{0.6 * static_cast<double>(i % 50)}, Metres{0.6 * static_cast<double>(i / 50)}}, 0});
    site.tiles.push_back(std::move(tile));
  }
  for (int r = 0; r < 20; ++r) {
    floor::Route route{"route " + std::to_string(r), {}, Metres{0.2}};
    for (int v = 0; v < 12; ++v) route.vertices.push_back({Metres{0.37 * (r + v)}, Metres{0.91 * (r + v % 3)}});
    site.routes.push_back(std::move(route));
  }
  return site;
}

double leastMs(const std::function<void()>& work, int runs = 7) {
  double least = 1e300;
  for (int n = 0; n < runs; ++n) {
    timespec a{};
    timespec b{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &a);
    work();
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &b);
    least = std::min(
        least, 1e3 * static_cast<double>(b.tv_sec - a.tv_sec) + 1e-6 * static_cast<double>(b.tv_nsec - a.tv_nsec));
  }
  return least;
}

double kB(const QByteArray& bytes) { return static_cast<double>(bytes.size()) / 1e3; }

// The lines of a text that another one does not have: the least that a patch of lines could be.
QByteArray newLines(const QByteArray& before, const QByteArray& after) {
  const QList<QByteArray> old = before.split('\n');
  const QSet<QByteArray> known{old.begin(), old.end()};
  QByteArray lines;
  for (const QByteArray& line : after.split('\n'))
    if (!known.contains(line)) lines += line + '\n';
  return lines;
}

void sizes(const floor::Site& site, const floor::Site& route, const floor::Site& tile) {
  const QByteArray text = store::textOf(site);
  std::printf("whole copy                      %8.1f kB\n", kB(text));
  for (const int level : {1, 6, 9}) {
    QByteArray packed;
    const double ms = leastMs([&] { packed = qCompress(text, level); });
    std::printf("compressed, level %d             %8.1f kB %8.1f ms\n", level, kB(packed), ms);
  }
  for (const auto& [name, part] : {std::pair{"part: tiles and tags", store::Part::Floor},
                                   {"part: picture", store::Part::Picture},
                                   {"part: the rest", store::Part::Rest}})
    std::printf("%-31s %8.1f kB\n", name, kB(store::compressed(store::textOf(store::partOf(site, part)))));
  std::printf("lines of one route, compressed  %8.1f kB\n", kB(qCompress(newLines(text, store::textOf(route)))));
  std::printf("lines of one tile, compressed   %8.1f kB\n", kB(qCompress(newLines(text, store::textOf(tile)))));
}

void times(const floor::Site& site, const floor::Site& route, const floor::Site& tile) {
  const QTemporaryDir folder;
  auto database = store::Database::open((folder.path() + "/bench.db").toStdString());
  if (!database) std::abort();
  store::Revisions revisions{**database};
  int key = 0;
  const auto add = [&](const floor::Site& what, int at) {
    if (!revisions.add(std::to_string(at), what, {})) std::abort();
  };
  std::printf("first revision                  %8.1f ms\n", leastMs([&] {
                floor::Site other = site;
                other.tiles[0].serial = other.placements[0].serial = "X-" + std::to_string(++key);
                add(other, key);
              }));
  add(site, 0);
  std::printf("the same again                  %8.1f ms\n", leastMs([&] { add(site, 0); }));
  int n = 0;
  std::printf("one route changed               %8.1f ms\n", leastMs([&] {
                floor::Site other = route;
                other.routes[0].name = "r" + std::to_string(++n);
                add(other, 0);
              }));
  std::printf("one tile moved                  %8.1f ms\n", leastMs([&] {
                floor::Site other = tile;
                other.placements[1].origin.x = Metres{100.0 + ++n};
                add(other, 0);
              }));
  const auto id = revisions.list("0").value().front().id;
  std::printf("load                            %8.1f ms\n", leastMs([&] {
                if (!revisions.load(id)) std::abort();
              }));
  const auto before = floor::SiteMap::build(site).value();
  for (const auto& [name, after] : {std::pair{"compare: one tile moved", &tile}, {"compare: one route", &route}})
    std::printf("%-31s %8.1f ms\n", name,
                leastMs([&, map = floor::SiteMap::build(*after).value()] { (void)ui::compare(before, map); }));
  floor::Site bare = site;
  bare.placements.clear();
  std::printf("compare: all tiles taken up     %8.1f ms\n",
              leastMs([&, map = floor::SiteMap::build(bare).value()] { (void)ui::compare(before, map); }));
}

// A frame's share while vehicles drive beneath: everything in view, nothing that could be joined.
void painting(const floor::Site& site) {
  floor::Site chequered = site;
  std::size_t n = 0;
  std::erase_if(chequered.placements, [&n](const floor::Placement&) {
    ++n;
    return (n + n / 50) % 2 == 0;
  });
  const auto comparison = ui::compare(floor::SiteMap::build(site).value(), floor::SiteMap::build(chequered).value());
  QImage picture{1600, 1000, QImage::Format_ARGB32_Premultiplied};
  picture.fill(Qt::white);
  ui::View view{picture.size(), 1.0};
  view.fit({{}, {Metres{30.0}, Metres{0.6 * std::ceil(static_cast<double>(site.placements.size()) / 50)}}}, 40.0);
  const ui::CanvasTheme theme{QPalette{}};
  QPainter painter{&picture};
  std::printf("paint: every other tile gone    %8.1f ms\n",
              leastMs([&] { ui::paintChanges(painter, view, theme, comparison.marks); }));
  ui::ChangeLayer layer;
  layer.set(comparison.marks);
  layer.paint(painter, view, theme);
  std::printf("paint: the same, view unchanged %8.1f ms\n", leastMs([&] { layer.paint(painter, view, theme); }));
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication application{argc, argv};
  const floor::Site site = hall(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2000);
  floor::Site route = site;
  route.routes[0].vertices[1] = {Metres{1.0}, Metres{1.0}};
  floor::Site tile = site;
  tile.placements[1].origin = {Metres{100.0}, Metres{}};
  sizes(site, route, tile);
  times(site, route, tile);
  painting(site);
  return 0;
}
