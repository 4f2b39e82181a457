// The whole window while three vehicles drive: how many frames a second the floor gets, and how long the interface's
// thread is busy between two looks at mouse and keys. The vehicles are those of the simulated world, over its port.
// Prints a table, judges nothing. bench_window [SECONDS]
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

bool allDrive(desktop::MainWindow& window) {
  const auto picture = window.session().latest();
  return picture && std::all_of(picture->vehicles.begin(), picture->vehicles.end(),
                                [](const auto& v) { return v.progress > Metres{0.05}; });
}

int measure(double seconds) {
  desktop::MainWindow window;
  window.restore();
  window.resize(1600, 900);
  window.show();
  if (!window.files().open(QStringLiteral(TESSERA_SITES "/three.tessera.json"))) return 1;
  window.connectTo({});
  if (!until(
          [&] {
            const auto picture = window.session().latest();
            return picture && !picture->vehicles.empty() &&
                   std::all_of(picture->vehicles.begin(), picture->vehicles.end(),
                               [](const auto& v) { return v.contact == supervisor::Contact::Connected && v.located; });
          },
          60)) {
    std::fprintf(stderr, "bench_window: the vehicles did not answer within a minute\n");
    return 1;
  }
  const floor::Site& site = window.document().site();
  for (std::size_t n = 0; n < site.vehicles.size() && n < site.routes.size(); ++n)
    window.session().post(supervisor::RunRoute{site.vehicles[n].id, site.routes[n].name, MetresPerSecond{0.15}});
  if (!until([&] { return allDrive(window); }, 60)) {
    std::fprintf(stderr, "bench_window: not all vehicles drove within a minute\n");
    return 1;
  }
  for (const char* dock : {"chartsDock", "vehiclesDock"}) {
    if (auto* shown = window.findChild<QDockWidget*>(QString::fromLatin1(dock))) shown->raise();
    until([] { return false; }, 1);
    Watch watch{window.canvas()};
    QEventLoop loop;
    QTimer::singleShot(static_cast<int>(1000 * seconds), &loop, &QEventLoop::quit);
    loop.exec();
    std::printf("| %-12s | %8.1f | %7.2f | %7.2f | %7.2f | %7.2f |\n", dock, watch.frames / seconds,
                at(watch.busy, 0.5), at(watch.busy, 0.95), at(watch.busy, 0.99), at(watch.busy, 1.0));
    std::fflush(stdout);
  }
  window.session().close();
  window.document().markSaved();
  window.close();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir home;  // neither the settings nor the data of whoever runs it
  qputenv("XDG_DATA_HOME", home.filePath(QStringLiteral("data")).toUtf8());
  qputenv("XDG_CONFIG_HOME", home.filePath(QStringLiteral("config")).toUtf8());
  QApplication application{argc, argv};
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.filePath(QStringLiteral("config")));
  std::printf("%s, %d cores, Qt %s, 1600 x 900, three vehicles at 0.15 m/s, their trails, the panel named\n\n",
              qPrintable(QSysInfo::prettyProductName()), QThread::idealThreadCount(), qVersion());
  std::printf("Processor time of the interface's thread between two waits, ms\n\n");
  std::printf("| panel        | frames/s |     p50 |     p95 |     p99 |     max |\n");
  std::printf("| ------------ | -------: | ------: | ------: | ------: | ------: |\n");
  return measure(argc > 1 ? std::atof(argv[1]) : 8.0);
}
