// tessera-world: a simulated floor with vehicles, behind a pseudo terminal that stands for the host's radio module.
#include <sys/signalfd.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/world/commands.h"
#include "app/world/line_reader.h"
#include "app/world/make_world.h"
#include "app/world/world_options.h"
#include "sim/pty/runner.h"

namespace tessera::world {
namespace {

enum ExitCode : int { kDone = 0, kUsage = 2, kBadInput = 3, kNoPort = 4, kNoVehicle = 5, kCannotWrite = 6 };

constexpr const char* kFooter =
    "\nWhen the port stands and the vehicles are switched on, one line of JSON tells so on standard output:\n"
    "  {\"port\": \"/dev/pts/3\", \"vehicles\": [{\"id\": 1, \"name\": \"V1\", \"kind\": \"native\"}]}\n"
    "Troubles that the world survives are told on standard error.\n\n"
    "Exit codes: 0 ended as told; 2 wrong call; 3 a file cannot be read or kept or contradicts itself, or a vehicle "
    "cannot be\n"
    "set up from it; 4 no pseudo terminal; 5 a vehicle cannot be started; 6 an EEPROM cannot be kept.";

struct ProcessOptions {
  std::string link;
  std::optional<double> duration;
  bool json = false;
  bool withParent = false;
};

/// The running program: joins port, world, standard input and signals.
class Program : public Surroundings {
public:
  Program(MadeWorld& made, const WorldOptions& options, const ProcessOptions& process)
      : made_{made}, options_{options}, process_{process}, runner_{*made.world}, input_{STDIN_FILENO} {}

  Result<void> pull() override {
    if (!runner_.port()) return failure("The port is closed already.");
    runner_.setPort(std::nullopt);
    return {};
  }

  Result<std::string> plug() override {
    if (runner_.port()) return failure("The port is open already: " + runner_.port()->path() + ".");
    auto port = sim::Pty::open(process_.link);
    if (!port) return tl::unexpected{port.error()};
    const std::string path = port->path();
    runner_.setPort(std::move(*port));
    return path;
  }

  void quit() override { runner_.stop(); }

  int run() {
    if (auto port = plug(); !port) return complain(port.error(), kNoPort);
    if (auto started = made_.world->startAll(); !started) return complain(started.error(), kNoVehicle);
    announce();
    watchSignals();
    watchInput();
    runner_.onTrouble([](const std::string& sentence) { std::cerr << "tessera-world: " << sentence << std::endl; });
    made_.world->skipTo(sim::monotonicNow());  // emulators took their time to start
    std::optional<Seconds> end;
    if (process_.duration) end = made_.world->time() + Seconds{*process_.duration};
    const auto ran = runner_.run(end);
    if (auto saved = made_.saveEeproms(); !saved) return complain(saved.error(), kCannotWrite);
    return ran ? kDone : complain(ran.error(), kNoPort);
  }

private:
  static int complain(const Error& error, int code) {
    std::cerr << "tessera-world: " << error.sentence << std::endl;
    return code;
  }

  void announce() const {
    nlohmann::json vehicles = nlohmann::json::array();
    for (const auto& v : made_.vehicles)
      vehicles.push_back(
          {{"id", v.id.value}, {"name", v.name}, {"kind", options_.kind == Kind::Qemu ? "qemu" : "native"}});
    std::cout << nlohmann::json{{"port", runner_.port()->path()}, {"vehicles", vehicles}}.dump() << std::endl;
  }

  void watchSignals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    runner_.watch(signalfd(-1, &set, SFD_CLOEXEC), [this] { runner_.stop(); });
  }

  void watchInput() {
    runner_.watch(STDIN_FILENO, [this] {
      for (const std::string& line : input_.read()) answer(obey(line, *made_.world, *this));
      if (!input_.ended()) return;
      runner_.unwatch(STDIN_FILENO);
      if (process_.withParent) runner_.stop();
    });
  }

  void answer(const Result<std::string>& result) const {
    if (process_.json) {
      std::cout
          << (result ? nlohmann::json{{"done", *result}} : nlohmann::json{{"error", result.error().sentence}}).dump()
          << std::endl;
    } else if (!result || !result->empty()) {
      std::cout << (result ? *result : "error: " + result.error().sentence.english()) << std::endl;
    }
  }

  MadeWorld& made_;
  const WorldOptions& options_;
  const ProcessOptions& process_;
  sim::RealTimeRunner runner_;
  LineReader input_;
};

int runWorld(int argc, char** argv) {
  CLI::App app{"A simulated floor with vehicles, behind a pseudo terminal that stands for the host's radio module.",
               "tessera-world"};
  WorldOptions options;
  ProcessOptions process;
  addWorldCast(app, options);
  addWorldConditions(app, options);
  app.add_option("--link", process.link, "Symbolic link to make to the port; goes with it");
  app.add_option("--duration", process.duration, "End by itself after this many seconds")->check(CLI::Range{0.01, 1e9});
  app.add_flag("--json", process.json, "Answer commands in JSON: {\"done\": ...} or {\"error\": ...}");
  app.add_flag("--with-parent", process.withParent, "End when standard input ends");
  app.set_version_flag("--version", TESSERA_VERSION);
  app.footer(std::string{kCommandHelp} + "\n" + kFooter);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kUsage;
  }
  auto made = makeWorld(options, Seconds{});
  if (!made) {
    std::cerr << "tessera-world: " << made.error().sentence << std::endl;
    return kBadInput;
  }
  // Setting vehicles up took time: the world's clock begins only now.
  made->world->skipTo(sim::monotonicNow());
  return Program{*made, options, process}.run();
}

}  // namespace
}  // namespace tessera::world

int main(int argc, char** argv) {
  // Blocked before any thread is made, so that they reach the loop as bytes on a descriptor wherever they arrive.
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return tessera::world::runWorld(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "tessera-world: " << e.what() << std::endl;
    return tessera::world::kBadInput;
  }
}
