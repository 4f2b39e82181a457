// What the panels beside the floor cost: processor time per picture of the fleet, 50 pictures a second as the
// supervision makes them, every vehicle moving, panels shown and painted. Prints a table; judges nothing.
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QSysInfo>
#include <QThread>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "tests/ui/fleet/fake_fleet.h"
#include "ui/charts/live_charts.h"
#include "ui/fleet/run_panel.h"
#include "ui/fleet/vehicle_table.h"

namespace {

using namespace tessera;

constexpr int kPictures = 150;
constexpr int kPeriodMs = 20;

double threadMs() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) / 1e6;
}

QString machine() {
  QString model = QStringLiteral("unknown processor");
  QFile info{QStringLiteral("/proc/cpuinfo")};
  if (info.open(QIODevice::ReadOnly)) {
    const auto lines = QString::fromUtf8(info.readAll()).split(QLatin1Char('\n'));
    for (const QString& line : lines)
      if (line.startsWith(QLatin1String("model name"))) model = line.section(QLatin1Char(':'), 1).trimmed();
  }
  return QStringLiteral("%1, %2 cores, %3, Qt %4")
      .arg(model)
      .arg(QThread::idealThreadCount())
      .arg(QSysInfo::prettyProductName(), QString::fromLatin1(qVersion()));
}

supervisor::Snapshot pictureOf(int vehicles, double time) {
  auto snapshot = ui::fakeSnapshot(vehicles, time);
  for (auto& v : snapshot.vehicles) {
    const double along = std::fmod(0.3 * time + 0.03 * v.id.value, 4.0);
    ui::setRunning(v, "one", along, 4.0);
    v.pose = {{Metres{std::min(along, 3.0)}, Metres{std::max(0.0, along - 3.0)}}, Radians{along < 3.0 ? 0.0 : 1.57}};
    v.speed = MetresPerSecond{0.3 + 0.02 * std::sin(3.0 * time + v.id.value)};
    v.crossTrack = Metres{0.02 * std::sin(2.0 * time)};
    v.link.age = Seconds{std::fmod(time + 0.01 * v.id.value, 0.3)};
  }
  return snapshot;
}

// Processor time of the window's thread for each picture, milliseconds, sorted.
std::vector<double> costs(ui::FakeFleet& link, int vehicles) {
  std::vector<double> all;
  double time = 10.0;
  for (int i = 0; i < kPictures; ++i, time += kPeriodMs / 1000.0) {
    const auto snapshot = pictureOf(vehicles, time);
    QElapsedTimer period;
    period.start();
    const double before = threadMs();
    link.show(snapshot);
    while (period.elapsed() < kPeriodMs) {
      QApplication::processEvents(QEventLoop::AllEvents, kPeriodMs);
      QThread::usleep(500);
    }
    all.push_back(threadMs() - before);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void measure(const char* what, int vehicles, bool table, bool run, bool charts) {
  ui::FakeFleet link;
  ui::Selection selection;
  ui::SiteDocument document;
  ui::openFakeSite(document, vehicles, {"one"});
  selection.setVehicle(VehicleId{1});
  ui::VehicleTable list{link, selection, document};
  ui::RunPanel panel{link, selection, document};
  ui::LiveCharts live{link, selection, document};
  list.resize(1000, 700);
  panel.resize(320, 500);
  live.resize(1100, 600);
  list.setVisible(table);
  panel.setVisible(run);
  live.setVisible(charts);
  const auto all = costs(link, vehicles);
  double sum = 0.0;
  for (const double cost : all) sum += cost;
  std::printf("| %-32s | %8d | %8.2f | %8.2f | %8.2f |\n", what, vehicles, sum / static_cast<double>(all.size()),
              all[all.size() * 99 / 100], all.back());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application{argc, argv};
  QApplication::setStyle(QStringLiteral("Fusion"));
  std::printf("%s\n\n", qPrintable(machine()));
  std::printf("Processor time per picture of the fleet, 50 pictures a second, milliseconds\n\n");
  std::printf("| %-32s | %8s | %8s | %8s | %8s |\n", "shown", "vehicles", "mean", "99 %", "worst");
  std::printf("| -------------------------------- | -------: | -------: | -------: | -------: |\n");
  for (const int vehicles : {3, 100}) {
    measure("nothing", vehicles, false, false, false);
    measure("list of vehicles", vehicles, true, false, false);
    measure("run panel", vehicles, false, true, false);
    measure("live charts", vehicles, false, false, true);
    measure("list, run panel and live charts", vehicles, true, true, true);
  }
  return 0;
}
