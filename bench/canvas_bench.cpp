// How long a frame of the floor takes, and how long an edit: 1600 x 900 pixels drawn by the processor alone, floors of
// 2,500 to a million tags, 3 and 100 vehicles with a minute's trail each. Prints a table, judges nothing.
#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

#include "floor/new_floor.h"
#include "floor/site_map.h"
#include "ui/base/site_document.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/route/route_edits.h"

namespace {

using namespace tessera;

constexpr unsigned kSeed = 20260101;
constexpr int kTagsPerTile = 8;

floor::Site siteOf(int tags, int vehicles) {
  floor::Site site;
  site.tileTypes = {floor::usualTileTypes()[0]};
  const int tiles = tags / kTagsPerTile;
  const int columns = static_cast<int>(std::ceil(std::sqrt(tiles * 16.0 / 9.0)));
  for (int n = 0; n < tiles; ++n) {
    floor::Tile tile{"T" + std::to_string(n), site.tileTypes.front().name, {}};
    for (std::uint8_t k = 0; k < kTagsPerTile; ++k) {
      const std::array<std::uint8_t, 7> uid{
          4, k, static_cast<std::uint8_t>(n >> 16), static_cast<std::uint8_t>(n >> 8), static_cast<std::uint8_t>(n),
          0, 1};
      tile.uids.push_back(floor::TagUid::fromBytes(uid).value());
    }
    site.placements.push_back({tile.serial, {Metres{0.6 * (n % columns)}, Metres{0.6 * (n / columns)}}, n % 4});
    site.tiles.push_back(std::move(tile));
  }
  std::mt19937 random{kSeed};
  const double width = 0.6 * columns;
  const double height = 0.6 * tiles / columns;
  const auto place = [&] {
    return Point{Metres{std::uniform_real_distribution<double>{0, width}(random)},
                 Metres{std::uniform_real_distribution<double>{0, height}(random)}};
  };
  for (int n = 0; n < 20; ++n) {
    floor::Route route{"Route " + std::to_string(n + 1), {}, Metres{0.2}};
    for (int k = 0; k < 8; ++k) route.vertices.push_back(place());
    site.routes.push_back(route);
  }
  for (int n = 1; n <= vehicles; ++n) {
    floor::VehicleSetup vehicle;
    vehicle.id = VehicleId{static_cast<std::uint8_t>(n)};
    vehicle.name = "AGV " + std::to_string(n);
    vehicle.footprint = {{Metres{-0.2}, Metres{-0.18}},
                         {Metres{0.2}, Metres{-0.18}},
                         {Metres{0.2}, Metres{0.18}},
                         {Metres{-0.2}, Metres{0.18}}};
    vehicle.start = Pose{place(), {}};
    site.vehicles.push_back(vehicle);
  }
  return site;
}

// Every vehicle on a circle of its own at 0.5 m/s.
std::shared_ptr<const supervisor::Snapshot> snapshotAt(const floor::Site& site, double time) {
  auto snapshot = std::make_shared<supervisor::Snapshot>();
  snapshot->time = Seconds{time};
  for (const floor::VehicleSetup& setup : site.vehicles) {
    supervisor::VehicleView v;
    v.id = setup.id;
    v.name = setup.name;
    v.contact = supervisor::Contact::Connected;
    v.task = supervisor::Task::Running;
    v.located = true;
    const double turn = time * 0.5 / 2.0 + setup.id.value;
    v.pose = {setup.start->position + turned({Metres{2.0}, {}}, Radians{turn}), Radians{turn + kPi / 2}};
    v.predicted = {placeOf(v.pose, {Metres{0.1}, {}}), v.pose.heading};
    v.speed = MetresPerSecond{0.5};
    v.covariance = {4e-4, 0, 0, 0, 2e-4, 0, 0, 0, 1e-3};
    // Ten tags a second: a tag every five centimetres at this speed.
    v.recentReads = {{{}, 0, Seconds{std::floor(time * 10.0) / 10.0}, v.pose.position}};
    snapshot->vehicles.push_back(std::move(v));
  }
  return snapshot;
}

// On a machine that has other things to do the clock says more of them than of the drawing: both are told.
struct Times {
  std::vector<double> wall;
  std::vector<double> processor;  ///< of all threads
};

double at(std::vector<double> ms, double share) {
  std::sort(ms.begin(), ms.end());
  return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
}

template <class Work>
Times timed(int count, Work work) {
  Times times;
  for (int n = 0; n < count; ++n) {
    const std::clock_t processor = std::clock();
    QElapsedTimer clock;
    clock.start();
    work(n);
    times.wall.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    times.processor.push_back(1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
  }
  return times;
}

void row(int tags, int vehicles, const char* what, const Times& times) {
  std::printf("| %9d | %3d | %-30s | %7.2f | %7.2f | %7.2f | %7.2f |\n", tags, vehicles, what, at(times.processor, 0.5),
              at(times.processor, 0.95), at(times.wall, 0.5), at(times.wall, 0.95));
  std::fflush(stdout);
}

// A drawing of 24 million pixels, a little larger than the floor and askew.
floor::Backdrop planUnder(const floor::Site& site) {
  QImage image{6000, 4000, QImage::Format_RGB32};
  image.fill(Qt::white);
  QPainter painter{&image};
  for (int n = 0; n < 300; ++n) painter.drawRect(n * 20, n * 13, 400, 300);
  painter.end();
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  image.save(&bytes, "PNG");
  const double width = site.placements.back().origin.y.value() * 16.0 / 9.0 + 5.0;
  return {"plan.png",
          std::make_shared<const std::string>(bytes.data().toStdString()),
          {},
          Metres{width / 6000},
          fromDegrees(5),
          0.5};
}

void measure(int tags, int vehicles, bool plan = false) {
  ui::SiteDocument document;
  floor::Site whole = siteOf(tags, vehicles);
  if (plan) whole.backdrop = planUnder(whole);
  document.replace(floor::SiteMap::build(std::move(whole)).value(), {});
  const floor::Site& site = document.site();
  ui::FloorCanvas canvas;
  canvas.resize(1600, 900);
  canvas.setAttribute(Qt::WA_DontShowOnScreen);
  canvas.show();
  canvas.openMap(document.map());
  canvas.setSelectedRoute("Route 1");
  double time = 0.0;
  for (; time < 60.0; time += 0.1) canvas.setSnapshot(snapshotAt(site, time));
  QImage frame{1600, 900, QImage::Format_ARGB32_Premultiplied};
  const auto draw = [&] { canvas.render(&frame, {}, {}, QWidget::RenderFlags{}); };
  draw();
  const auto live = [&](int) {
    time += 0.02;
    canvas.setSnapshot(snapshotAt(site, time));
    draw();
  };
  const auto pan = [&](int n) {
    const double right = (n / 40) % 2 == 0 ? 17.0 : -17.0;
    const double down = (n / 20) % 2 == 0 ? 9.0 : -9.0;
    canvas.centreOn(canvas.view().toSite({800 + right, 450 + down}));
    draw();
  };
  // What is left to draw comes between frames: each turn of the event loop counts as one, and all of them are told too.
  Times frames;
  const auto zoom = [&](int n) {
    const auto count = [&frames](auto work) {
      const Times one = timed(1, [&](int) { work(); });
      frames.wall.push_back(one.wall.front());
      frames.processor.push_back(one.processor.front());
    };
    count([&] {
      if ((n / 10) % 2 == 0) {
        canvas.zoomIn();
      } else {
        canvas.zoomOut();
      }
      draw();
    });
    while (!canvas.isDrawn()) count([] { QCoreApplication::processEvents(); });
  };
  row(tags, vehicles, "live, whole floor", timed(200, live));
  const Times zooms = timed(60, zoom);
  row(tags, vehicles, "zoom, whole floor to 58x", frames);
  row(tags, vehicles, "  until all is drawn", zooms);
  canvas.fit();
  for (int n = 0; n < 2; ++n) canvas.zoomIn();
  draw();
  row(tags, vehicles, "pan, floor at 2.3x", timed(200, pan));
  canvas.fit();
  while (canvas.view().scale() < 100.0) canvas.zoomIn();
  draw();
  row(tags, vehicles, "pan, tiles and tags near", timed(200, pan));
  row(tags, vehicles, "live, tiles and tags near", timed(200, live));
  ui::RouteEdits edits{document};
  row(tags, vehicles, "edit: move a vertex", timed(10, [&](int n) {
        static_cast<void>(edits.moveVertex("Route 1", 1, {Metres{1.0 + 0.01 * n}, Metres{1.0}}));
      }));
  const QMetaObject::Connection shown =
      QObject::connect(&document, &ui::SiteDocument::changed, &canvas, [&] { canvas.setMap(document.map()); });
  row(tags, vehicles, "edit: turn a tile, and draw it", timed(6, [&](int n) {
        static_cast<void>(document.edit("Turn", [&](floor::Site& edited) {
          auto& placement = edited.placements.at(static_cast<std::size_t>(n));
          placement.quarterTurns = 1 - placement.quarterTurns;
        }));
        draw();
      }));
  QObject::disconnect(shown);
  row(tags, vehicles, "until an edit is all drawn", timed(2, [&](int n) {
        if (n % 2 == 0) document.undoStack().undo();
        if (n % 2 == 1) document.undoStack().redo();
        canvas.setMap(document.map());
        canvas.finishDrawing();
        draw();
      }));
}

QString processor() {
  QFile file{"/proc/cpuinfo"};
  if (!file.open(QIODevice::ReadOnly)) return QSysInfo::currentCpuArchitecture();
  for (const QByteArray& line : file.readAll().split('\n')) {
    if (line.startsWith("model name")) return QString::fromUtf8(line.mid(line.indexOf(':') + 1)).trimmed();
  }
  return QSysInfo::currentCpuArchitecture();
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application{argc, argv};
  QApplication::setStyle("Fusion");
  std::printf("%s, %s, Qt %s, seed %u, 1600 x 900, device pixel ratio %.2f\n\n", qPrintable(processor()),
              qPrintable(QSysInfo::prettyProductName()), qVersion(), kSeed, application.devicePixelRatio());
  std::printf("|      tags | veh | frame, ms                      | CPU p50 | CPU p95 |     p50 |     p95 |\n");
  std::printf("| --------: | --: | ------------------------------ | ------: | ------: | ------: | ------: |\n");
  // Of all sizes, or of the one that is asked for: bench_canvas TAGS VEHICLES [plan]
  if (argc == 3 || argc == 4) {
    measure(std::atoi(argv[1]), std::atoi(argv[2]), argc == 4);
    return 0;
  }
  for (const int tags : {2'500, 40'000, 1'000'000}) {
    for (const int vehicles : {3, 100}) measure(tags, vehicles);
  }
  return 0;
}
