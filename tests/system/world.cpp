#include "system/world.h"

#include <QThread>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/experiment/summary.h"
#include "host/supervisor_thread.h"

namespace tessera::system_test {
namespace {

std::vector<std::string> allWords(const QTemporaryDir& folder, const std::string& site,
                                  const std::vector<std::string>& words) {
  const std::string path = folder.path().toStdString();
  std::vector<std::string> all{site,     "--link",        path + "/radio", "--truth", path + "/truth.csv",
                               "--json", "--with-parent", "--eeprom-dir",  path};
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

// The parent of a process, as the kernel tells: the word behind the state, which follows the name in brackets.
int parentOf(const std::filesystem::path& process) {
  std::ifstream file{process / "stat"};
  std::string text;
  std::getline(file, text);
  const auto bracket = text.rfind(')');
  if (bracket == std::string::npos || bracket + 4 >= text.size()) return 0;
  int parent = 0;
  std::from_chars(text.data() + bracket + 4, text.data() + text.size(), parent);
  return parent;
}

}  // namespace

World::World(const QTemporaryDir& folder, const std::string& site, const std::vector<std::string>& words)
    : truth_{folder.path().toStdString() + "/truth.csv"}, program_{TESSERA_WORLD, allWords(folder, site, words)} {
  const auto ready = nlohmann::json::parse(program_.line(), nullptr, false);
  if (ready.is_object()) port_ = ready.value("port", std::string{});
}

bool World::order(const std::string& command) {
  program_.say(command);
  const auto said = nlohmann::json::parse(program_.line(), nullptr, false);
  if (!said.is_object()) return false;
  answer_ = said.value("done", said.value("error", std::string{}));
  return said.contains("done");
}

int World::emulatorId() const {
  for (const auto& entry : std::filesystem::directory_iterator{"/proc"}) {
    const std::string name = entry.path().filename().string();
    int id = 0;
    const auto [end, bad] = std::from_chars(name.data(), name.data() + name.size(), id);
    if (bad != std::errc{} || end != name.data() + name.size()) continue;
    if (parentOf(entry.path()) == static_cast<int>(program_.id())) return id;
  }
  return 0;
}

Seconds World::movedOnFor(Seconds since, int vehicle) const {
  constexpr double kStanding = 0.005;  // m/s
  constexpr Seconds kLongEnough{0.33};
  const Seconds giveUp = host::steadyNow() + Seconds{kPatienceMs / 1000.0};
  while (host::steadyNow() < giveUp) {
    const auto track = experiment::readTruth(truth_, vehicle);
    if (!track) break;
    Seconds moved = since;
    for (const auto& truth : track->poses()) {
      if (truth.at < since) continue;
      if (truth.at > moved + kLongEnough) return moved - since;
      if (abs(truth.speed).value() > kStanding) moved = truth.at;
    }
    QThread::msleep(50);
  }
  return Seconds{1000};
}

Point World::where(int vehicle) {
  double x = 0;
  double y = 0;
  if (!order("where " + std::to_string(vehicle)) || std::sscanf(answer_.c_str(), "x %lf m, y %lf m", &x, &y) != 2)
    return Point{Metres{-1000}, Metres{-1000}};
  return Point{Metres{x}, Metres{y}};
}

}  // namespace tessera::system_test
