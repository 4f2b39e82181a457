#include "app/cli/port_run.h"

#include <sys/socket.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QEventLoop>
#include <QRandomGenerator>
#include <QSocketNotifier>
#include <QTimer>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <set>

#include "app/cli/output.h"
#include "base/polyline.h"
#include "drive/route_follower.h"
#include "host/supervisor_thread.h"
#include "locate/locator.h"

namespace tessera::cli {
namespace {

// Turns Ctrl-C and a polite kill into something that an event loop sees; the handler itself only writes a byte.
class Interrupt {
public:
  Interrupt() {
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends_) != 0) return;
    writeEnd = ends_[1];
    struct sigaction action {};
    action.sa_handler = [](int) {
      const char byte = 1;
      [[maybe_unused]] const auto written = ::write(writeEnd, &byte, 1);
    };
    sigaction(SIGINT, &action, &oldInt_);
    sigaction(SIGTERM, &action, &oldTerm_);
  }
  ~Interrupt() {
    sigaction(SIGINT, &oldInt_, nullptr);
    sigaction(SIGTERM, &oldTerm_, nullptr);
    writeEnd = -1;
    for (int end : ends_) ::close(end);
  }
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  [[nodiscard]] int readEnd() const { return ends_[0]; }

private:
  // A signal handler can reach nothing but a global.
  static inline volatile sig_atomic_t writeEnd = -1;
  int ends_[2] = {-1, -1};
  struct sigaction oldInt_ {};
  struct sigaction oldTerm_ {};
};

// Orders each route as soon as its vehicle is connected.
class Dispatcher {
public:
  Dispatcher(const PortRunSpec& spec, const experiment::Recorder& recorder) : spec_{spec}, recorder_{recorder} {}
  void look(const supervisor::Snapshot& snapshot, host::SupervisorThread& thread) {
    for (const auto& a : recorder_.assignments()) {
      const auto* view = snapshot.find(a.vehicle);
      if (view == nullptr || view->contact != supervisor::Contact::Connected || ordered_.contains(a.vehicle)) continue;
      if (thread.post(supervisor::RunRoute{a.vehicle, a.route, spec_.speed})) ordered_.insert(a.vehicle);
    }
  }

private:
  const PortRunSpec& spec_;
  const experiment::Recorder& recorder_;
  std::set<VehicleId> ordered_;
};

// The address in "ID=ROUTE"; nothing: the word has another form.
std::optional<VehicleId> idOf(const std::string& word) {
  const auto equals = word.find('=');
  unsigned id = 0;
  const char* end = word.data() + std::min(equals, word.size());
  const auto [at, error] = std::from_chars(word.data(), end, id);
  if (equals == std::string::npos || error != std::errc{} || at != end || id < 1 || id > 254) return std::nullopt;
  return VehicleId{static_cast<std::uint8_t>(id)};
}

std::string noAssignment(const std::string& word) {
  return "\"" + word + "\" is not a vehicle's address and a route, like 1=paper.";
}

}  // namespace

Result<RunEnd> runOnPort(const PortRunSpec& spec, experiment::Recorder& recorder, ProgressLine& progress) {
  auto config = spec.config;
  // Nonces must never come twice; a seeded run would repeat the last one's.
  config.seed = QRandomGenerator::system()->generate64();
  auto supervisor = supervisor::Supervisor::create(spec.map, config);
  if (!supervisor) return tl::unexpected{supervisor.error()};
  const auto port = host::PortChoice::parse(QString::fromStdString(spec.port), spec.map->site().radio.baud);
  if (!port) return tl::unexpected{port.error()};
  host::SupervisorThread thread{std::move(*supervisor), *port};
  Dispatcher dispatcher{spec, recorder};
  const Seconds begin = host::steadyNow();
  RunEnd end = RunEnd::TimeUp;
  bool everOpen = false;
  QEventLoop loop;

  const auto takeEvents = [&] {
    for (const auto& event : thread.takeEvents()) {
      recorder.take(event);
      if (spec.printEvents) progress.note(lineOf(event, begin));
    }
  };
  QObject::connect(&thread, &host::SupervisorThread::eventsArrived, &loop, takeEvents);
  QObject::connect(&thread, &host::SupervisorThread::snapshotChanged, &loop, [&] {
    const auto snapshot = thread.latest();
    if (!snapshot) return;
    everOpen = everOpen || snapshot->port.state == supervisor::PortState::Open;
    recorder.take(*snapshot);
    dispatcher.look(*snapshot, thread);
    progress.show(recorder.share(), recorder.progress());
    if (recorder.allFinished()) {
      end = RunEnd::Finished;
      loop.quit();
    }
  });
  Interrupt interrupt;
  QSocketNotifier notifier{interrupt.readEnd(), QSocketNotifier::Read};
  QObject::connect(&notifier, &QSocketNotifier::activated, &loop, [&] {
    end = RunEnd::Interrupted;
    loop.quit();
  });
  QTimer::singleShot(std::chrono::milliseconds{static_cast<long>(spec.limit.value() * 1000)}, &loop, &QEventLoop::quit);
  thread.start();
  loop.exec();
  if (!thread.close() && everOpen)
    progress.note("Not every vehicle could be told to stop; each stops by itself when its command runs out.");
  takeEvents();
  if (!everOpen) return failure("The port " + spec.port + " could not be opened.");
  return end;
}

Seconds generousLimit(const floor::SiteMap& map, const std::vector<experiment::Assignment>& assignments,
                      MetresPerSecond speed) {
  Metres longest;
  for (const auto& a : assignments) {
    if (const auto* route = map.route(a.route)) longest = std::max(longest, Polyline{route->vertices}.length());
  }
  return 3.0 * (longest / speed) + Seconds{60};
}

Result<experiment::Assignment> parseAssignment(const std::string& word, const floor::SiteMap& map) {
  const auto id = idOf(word);
  if (!id) return failure(noAssignment(word));
  experiment::Assignment assignment{*id, word.substr(word.find('=') + 1)};
  if (map.vehicle(assignment.vehicle) == nullptr) {
    return failure("The site " + map.site().name + " has no vehicle with the address " + std::to_string(id->value) +
                   ".");
  }
  if (map.route(assignment.route) == nullptr) {
    return failure("The site " + map.site().name + " has no route called \"" + assignment.route + "\".");
  }
  return assignment;
}

Result<std::vector<experiment::Assignment>> parseAssignments(const std::vector<std::string>& words,
                                                             const floor::SiteMap& map) {
  std::vector<experiment::Assignment> assignments;
  for (const std::string& word : words) {
    auto one = parseAssignment(word, map);
    if (!one) return tl::unexpected{std::move(one.error())};
    const auto same = [&](const experiment::Assignment& other) { return other.vehicle == one->vehicle; };
    if (std::any_of(assignments.begin(), assignments.end(), same))
      return failure("Vehicle " + std::to_string(one->vehicle.value) + " is given two routes; it can drive one.");
    assignments.push_back(std::move(*one));
  }
  return assignments;
}

CLI::Option* addDriveOption(CLI::App& command, std::vector<std::string>& words) {
  return command.add_option("--drive", words, "ID=ROUTE: a vehicle and its route; may be given several times")
      ->check([](const std::string& word) -> std::string { return idOf(word) ? "" : noAssignment(word); });
}

void addLimitOption(CLI::App& command, double& limit) {
  command.add_option("--limit", limit, "Give up after so many seconds; default: three times the drive, and 60")
      ->check(CLI::Range{0.1, 1e6})
      ->check([](const std::string& word) -> std::string {  // the range lets "nan" through
        return std::isfinite(std::strtod(word.c_str(), nullptr)) ? "" : word + " is no number of seconds.";
      });
}

void addMethods(CLI::App& command, std::string& estimator, std::string& controller) {
  const auto oneOf = [](std::span<const std::string_view> names) {
    return CLI::IsMember{std::vector<std::string>(names.begin(), names.end())};
  };
  command.add_option("--estimator", estimator, "Locator; default: the first of these")
      ->check(oneOf(locate::locatorNames()));
  command.add_option("--controller", controller, "Controller; default: the first of these")
      ->check(oneOf(drive::followerNames()));
}

}  // namespace tessera::cli
