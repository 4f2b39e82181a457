// The whole window while three vehicles drive, and a hundred: how many frames a second the floor gets, and how long the
// interface's thread is busy between two looks at mouse and keys. The vehicles are those of the simulated world, over
// its port. A hundred share the one radio as well: each is heard of seldom, and drives as slowly as that asks. Prints a
// table, judges nothing. bench_window [SECONDS [VEHICLES]]
#include <QAbstractEventDispatcher>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSettings>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "app/tessera/site_files.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "ui/canvas/floor_canvas.h"

namespace {

using namespace tessera;

double threadMs() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) / 1e6;
}

// Paintings of the floor, and every stretch of work between two waits of the event loop.
class Watch : public QObject {
public:
  explicit Watch(QWidget& canvas) {
    canvas.installEventFilter(this);
    connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::aboutToBlock, this, [this] {
      const double now = threadMs();
      busy.push_back(now - from_);
      from_ = now;
    });
  }
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++frames;
    return false;
  }

  int frames = 0;
  std::vector<double> busy;

private:
  double from_ = threadMs();  // waiting costs no processor time
};

double at(std::vector<double> all, double share) {
  if (all.empty()) return 0.0;
  std::sort(all.begin(), all.end());
  return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
}

bool until(const std::function<bool()>& condition, int seconds) {
  QElapsedTimer clock;
  clock.start();
  while (!condition() && clock.elapsed() < 1000 * seconds)
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 50);
  return condition();
}

int countVehicles(desktop::MainWindow& window, const std::function<bool(const supervisor::VehicleView&)>& such) {
  const auto picture = window.session().latest();
  return picture ? static_cast<int>(std::count_if(picture->vehicles.begin(), picture->vehicles.end(), such)) : 0;
}

// The floor of three vehicles again and again, side by side, until there are as many vehicles as asked for.
floor::Site floorsFor(int vehicles, const floor::Site& three) {
  constexpr int kPerRow = 6;
  floor::Site site = three;
  site.tiles.clear(), site.placements.clear(), site.zones.clear(), site.routes.clear(), site.vehicles.clear();
  for (std::uint8_t block = 0; static_cast<int>(site.vehicles.size()) < vehicles; ++block) {
    const Offset by{Metres{4.8 * (block % kPerRow)}, Metres{3.6 * (block / kPerRow)}};
    const std::string mark = "-" + std::to_string(block + 1);
    for (floor::Tile tile : three.tiles) {
      tile.serial += mark;
      for (floor::TagUid& uid : tile.uids) {
        if (uid.empty()) continue;
        std::vector<std::uint8_t> bytes{uid.bytes().begin(), uid.bytes().end()};
        bytes[1] = block;
        uid = floor::TagUid::fromBytes(bytes).value();
      }
      site.tiles.push_back(std::move(tile));
    }
    for (floor::Placement placement : three.placements) {
      placement.serial += mark, placement.origin = placement.origin + by;
      site.placements.push_back(std::move(placement));
    }
    for (std::size_t n = 0; n < three.vehicles.size() && static_cast<int>(site.vehicles.size()) < vehicles; ++n) {
      floor::Route route = three.routes[n];
      route.name += mark;
      for (Point& vertex : route.vertices) vertex = vertex + by;
      site.routes.push_back(std::move(route));
      floor::VehicleSetup vehicle = three.vehicles[n];
      vehicle.id = VehicleId{static_cast<std::uint8_t>(site.vehicles.size() + 1)};
      vehicle.name = "AGV " + std::to_string(vehicle.id.value);
      vehicle.key.back() = vehicle.id.value;
      vehicle.start->position = vehicle.start->position + by;
      site.vehicles.push_back(std::move(vehicle));
    }
  }
  return site;
}

void run(double seconds) {
  QEventLoop loop;
  QTimer::singleShot(static_cast<int>(1000 * seconds), &loop, &QEventLoop::quit);
  loop.exec();
}

int measure(double seconds, int vehicles, const QString& folder) {
  desktop::MainWindow window;
  window.restore();
  window.resize(1600, 900);
  window.show();
  const auto three = floor::loadSite(TESSERA_SITES "/three.tessera.json");
  const QString file = folder + QStringLiteral("/floors.tessera.json");
  if (!three || !floor::saveSite(floorsFor(vehicles, *three), file.toStdString()) || !window.files().open(file))
    return 1;
  window.connectTo({});
  // A round of the radio takes as long as there are vehicles, and brings one more in: the last ones wait for minutes.
  const auto located = [](const supervisor::VehicleView& v) { return v.located; };
  if (!until([&] { return countVehicles(window, located) == vehicles; }, 60 + vehicles) &&
      countVehicles(window, located) == 0) {
    std::fprintf(stderr, "bench_window: no vehicle answered\n");
    return 1;
  }
  const floor::Site& site = window.document().site();
  for (std::size_t n = 0; n < site.vehicles.size() && n < site.routes.size(); ++n)
    window.session().post(supervisor::RunRoute{site.vehicles[n].id, site.routes[n].name, MetresPerSecond{0.15}});
  const auto drives = [](const supervisor::VehicleView& v) { return v.progress > Metres{0.05}; };
  until([&] { return countVehicles(window, drives) == vehicles; }, 30 + vehicles / 2);
  for (const char* dock : {"chartsDock", "vehiclesDock"}) {
    if (auto* shown = window.findChild<QDockWidget*>(QString::fromLatin1(dock))) shown->raise();
    until([] { return false; }, 1);
    Watch watch{window.canvas()};
    run(seconds);
    std::printf("| %-12s | %8d | %7d | %5d | %8.1f | %7.2f | %7.2f | %7.2f | %7.2f |\n", dock, vehicles,
                countVehicles(window, located), countVehicles(window, drives), watch.frames / seconds,
                at(watch.busy, 0.5), at(watch.busy, 0.95), at(watch.busy, 0.99), at(watch.busy, 1.0));
    std::fflush(stdout);
  }
  window.session().close();
  window.document().markSaved();
  window.close();
  return 0;
}

// From the choice of the file to the floor that is drawn, all of it.
int measureOpening(int side, const QString& folder) {
  const QString file = folder + QStringLiteral("/large.tessera.json");
  const auto site = floor::layNewFloor({"Large", floor::usualTileTypes()[0], side, side, true});
  if (!site || !floor::saveSite(*site, file.toStdString())) return 1;
  desktop::MainWindow window;
  window.restore();
  window.resize(1600, 900);
  window.show();
  until([] { return false; }, 1);
  const double processor = threadMs();
  QElapsedTimer clock;
  clock.start();
  if (!window.files().open(file)) return 1;
  bool painted = false;
  window.canvas().repaint();
  until([&] { return painted = window.canvas().isDrawn(); }, 60);
  const double opened = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  const double busy = threadMs() - processor;
  run(5);  // what is begun after opening ends
  Watch watch{window.canvas()};
  static_cast<void>(window.document().edit("Turn", [](floor::Site& edited) {
    edited.placements.front().quarterTurns = 1 - edited.placements.front().quarterTurns;
  }));
  run(5);
  const double longest = at(watch.busy, 1.0);
  window.document().undoStack().undo();  // or it would be offered as not saved
  run(5);
  std::printf("| %9d | %8.0f | %10.0f | %23.0f |\n", side * side * 8, opened, busy, longest);
  std::fflush(stdout);
  window.document().markSaved();
  window.close();
  return painted ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir home;  // neither the settings nor the data of whoever runs it
  qputenv("XDG_DATA_HOME", home.filePath(QStringLiteral("data")).toUtf8());
  qputenv("XDG_CONFIG_HOME", home.filePath(QStringLiteral("config")).toUtf8());
  QApplication application{argc, argv};
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.filePath(QStringLiteral("config")));
  std::printf("%s, %d cores, Qt %s, 1600 x 900\n\n", qPrintable(QSysInfo::prettyProductName()),
              QThread::idealThreadCount(), qVersion());
  const double seconds = argc > 1 ? std::atof(argv[1]) : 8.0;
  int failures = 0;
  if (argc <= 2) {
    std::printf("A file opened until the frame that shows it\n\n");
    std::printf(
        "|      tags | time, ms | thread, ms | edit: longest pause, ms |\n| --------: | -------: | ---------: | "
        "----------------------: |\n");
    for (const int side : {12, 71, 354}) failures += measureOpening(side, home.path());
    if (seconds <= 0.0) return failures > 0 ? 1 : 0;
  }
  std::printf(
      "\nVehicles asked for 0.15 m/s, their trails, the panel named: processor time of the interface's thread\n"
      "between two waits, ms\n\n");
  std::printf("| panel        | vehicles | located | drove | frames/s |     p50 |     p95 |     p99 |     max |\n");
  std::printf("| ------------ | -------: | ------: | ----: | -------: | ------: | ------: | ------: | ------: |\n");
  if (argc > 2) return measure(seconds, std::atoi(argv[2]), home.path());
  for (const int vehicles : {3, 100}) failures += measure(seconds, vehicles, home.path());
  return failures > 0 ? 1 : 0;
}
