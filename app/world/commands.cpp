#include "app/world/commands.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "wire/frame.h"

namespace tessera::world {

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kMostReplays = 100;

std::optional<double> number(const std::string& word) {
  double value = 0;
  const auto [end, bad] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (bad != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// `count` finite numbers from the second word on.
std::optional<std::vector<double>> numbers(const Words& words, std::size_t count) {
  if (words.size() != count + 1) return std::nullopt;
  std::vector<double> values;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto value = number(words[i]);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

/// A whole number from 1 to `most` in this place of the line.
std::optional<std::size_t> wholeNumber(const Words& words, std::size_t place, std::size_t most) {
  const auto value = place < words.size() ? number(words[place]) : std::nullopt;
  if (!value || *value < 1 || *value > static_cast<double>(most) || std::floor(*value) != *value) return std::nullopt;
  return static_cast<std::size_t>(*value);
}

/// As the only word behind the command.
std::optional<std::size_t> count(const Words& words, std::size_t most) {
  return words.size() == 2 ? wholeNumber(words, 1, most) : std::nullopt;
}

std::optional<std::vector<std::uint8_t>> hexBytes(const std::string& word) {
  std::vector<std::uint8_t> bytes;
  if (word.size() % 2 != 0 || word.size() > 2000) return std::nullopt;
  for (std::size_t i = 0; i < word.size(); i += 2) {
    std::uint8_t byte = 0;
    const auto [end, bad] = std::from_chars(word.data() + i, word.data() + i + 2, byte, 16);
    if (bad != std::errc{} || end != word.data() + i + 2) return std::nullopt;
    bytes.push_back(byte);
  }
  return bytes;
}

/// The vehicle that the word at this place of the line names, if there is one.
std::optional<VehicleId> vehicle(const Words& words, std::size_t place, const sim::World& world) {
  const auto value = wholeNumber(words, place, 254);
  if (!value) return std::nullopt;
  const VehicleId id{static_cast<std::uint8_t>(*value)};
  return world.truth(id) ? std::optional{id} : std::nullopt;
}
/// As the word behind the command.
std::optional<VehicleId> vehicle(const Words& words, const sim::World& world) { return vehicle(words, 1, world); }

using Answer = Result<std::string>;

Answer misused(const char* usage) { return failure(std::string{"Expected: "} + usage + "."); }

Answer kill(const Words& w, sim::World& world) {
  const auto id = vehicle(w, world);
  if (!id || w.size() != 2) return misused("kill ID, with the address of a vehicle that is there");
  world.kill(*id);
  return "vehicle " + w[1] + " is without power";
}

Answer start(const Words& w, sim::World& world) {
  const auto id = vehicle(w, world);
  if (!id || w.size() != 2) return misused("start ID, with the address of a vehicle that is there");
  if (auto started = world.start(*id); !started) return tl::unexpected{started.error()};
  return "vehicle " + w[1] + " has started";
}

Answer push(const Words& w, sim::World& world) {
  const auto id = vehicle(w, world);
  const auto v = numbers(w, 4);
  if (!id || !v) return misused("push ID DX DY DTHETA, in metres and degrees");
  world.push(*id, {Metres{(*v)[1]}, Metres{(*v)[2]}}, fromDegrees((*v)[3]));
  return "vehicle " + w[1] + " was moved";
}

Answer obstacle(const Words& w, sim::World& world) {
  if (w.size() == 2 && w[1] == "clear") {
    world.clearObstacles();
    return "all posts are gone";
  }
  const auto v = numbers(w, 3);
  if (!v || (*v)[2] <= 0) return misused("obstacle X Y R in metres with R above 0, or obstacle clear");
  world.addObstacle({{Metres{(*v)[0]}, Metres{(*v)[1]}}, Metres{(*v)[2]}});
  return "a post stands there";
}

Answer ranger(const Words& w, sim::World& world) {
  const auto id = vehicle(w, world);
  const auto which = w.size() == 4 ? number(w[2]) : std::nullopt;
  const bool known = which && *which >= 0 && *which < firmware::kRangers && std::floor(*which) == *which;
  if (!id || !known || (w[3] != "off" && w[3] != "on"))
    return misused("ranger ID N off, or ranger ID N on, with N 0 for the left one and 1 for the right one");
  world.body(*id)->rangers().setDead(static_cast<std::size_t>(*which), w[3] == "off");
  return "ranger " + w[2] + " of vehicle " + w[1] + (w[3] == "off" ? " is dead" : " answers again");
}

Answer noise(const Words& w, sim::World& world) {
  const auto n = count(w, 100'000);
  if (!n) return misused("noise N, with N from 1 to 100000");
  world.noise(*n);
  return std::to_string(*n) + " random bytes go on the air";
}

Answer inject(const Words& w, sim::World& world) {
  const auto bytes = w.size() == 2 ? hexBytes(w[1]) : std::nullopt;
  if (!bytes || bytes->empty()) return misused("inject HEX, with at most 1000 bytes as pairs of hexadecimal digits");
  world.inject(*bytes);
  return std::to_string(bytes->size()) + " bytes go on the air";
}

Answer corrupt(const Words& w, sim::World& world) {
  const auto n = wholeNumber(w, 1, 1'000'000);
  const auto sender = w.size() == 4 && w[2] == "from" ? vehicle(w, 3, world) : std::nullopt;
  if (!n || (w.size() != 2 && !sender))
    return misused("corrupt N, or corrupt N from ID, with N from 1 to 1000000 and the address of a vehicle");
  sim::ChannelTap::Filter which;
  if (sender)
    which = [from = sender->value](std::span<const std::uint8_t> packet) {
      return packet.size() >= wire::kFrameOverhead && packet[0] == wire::kSync && packet[3] == from;
    };
  world.tap().corruptNext(*n, std::move(which), 7);  // behind the header, so that the frame still looks like one
  return "a byte will change in each of the next " + w[1] + " packets" + (sender ? " of vehicle " + w[3] : "");
}

Answer drop(const Words& w, sim::World& world) {
  const auto n = count(w, 1'000'000);
  if (!n) return misused("drop N, with N from 1 to 1000000");
  world.tap().dropNext(*n);
  return "the next " + w[1] + " packets will be suppressed";
}

Answer replay(const Words& w, sim::World& world) {
  const auto n = wholeNumber(w, 1, sim::ChannelTap::kMemory);
  const auto times = w.size() == 2 ? std::optional<std::size_t>{1} : wholeNumber(w, 2, kMostReplays);
  const auto& heard = world.tap().heard();
  if (!n || *n > heard.size() || !times || w.size() > 3)
    return misused("replay N [TIMES], with N from 1 to the number of packets heard, at most 256, and TIMES to 100");
  for (std::size_t i = 0; i < *times; ++i) world.inject(heard[heard.size() - *n]);
  return "an old packet goes on the air " + (*times == 1 ? "once" : std::to_string(*times) + " times") + " more";
}

Answer where(const Words& w, sim::World& world) {
  const auto id = vehicle(w, world);
  if (!id || w.size() != 2) return misused("where ID, with the address of a vehicle that is there");
  const auto truth = *world.truth(*id);
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "x %.4f m, y %.4f m, heading %.2f degrees", truth.pose.position.x.value(),
                truth.pose.position.y.value(), degrees(truth.pose.heading));
  return std::string{text.data()};
}

Answer truth(const Words& w, sim::World& world) {
  const auto id = vehicle(w, world);
  if (!id || w.size() != 2) return misused("truth ID, with the address of a vehicle that is there");
  const auto state = *world.truth(*id);
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "truth %u %.4f %.6f %.6f %.6f", unsigned{id->value}, state.time.value(),
                state.pose.position.x.value(), state.pose.position.y.value(), wrapped(state.pose.heading).value());
  return std::string{text.data()};
}

Answer jumpers(const Words& w, sim::World& world) {
  const auto bit = [&](std::size_t place) { return w[place] == "0" || w[place] == "1"; };
  if (w.size() != 3 || !bit(1) || !bit(2))
    return misused("jumpers M0 M1, each 0 or 1; 0 0 is normal mode, 1 1 configuration");
  const int mode = (w[1] == "1" ? 1 : 0) + (w[2] == "1" ? 2 : 0);
  world.setHostMode(static_cast<firmware::RadioMode>(mode));
  return "the host's radio module goes into mode " + std::to_string(mode);
}

using Command = Answer (*)(const Words&, sim::World&);
const std::map<std::string, Command, std::less<>> kCommands{
    {"kill", kill},     {"jumpers", jumpers}, {"start", start},   {"push", push},       {"obstacle", obstacle},
    {"ranger", ranger}, {"noise", noise},     {"inject", inject}, {"corrupt", corrupt}, {"drop", drop},
    {"replay", replay}, {"where", where},     {"truth", truth}};

}  // namespace

Result<std::string> obey(std::string_view line, sim::World& world, Surroundings& surroundings) {
  Words words;
  std::istringstream stream{std::string{line}};
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.empty()) return std::string{};
  if (const auto it = kCommands.find(words[0]); it != kCommands.end()) return it->second(words, world);
  if (words.size() != 1) return failure("There is no command \"" + words[0] + "\", or it takes nothing behind it.");
  if (words[0] == "pull") {
    if (auto done = surroundings.pull(); !done) return tl::unexpected{done.error()};
    return "the port is closed";
  }
  if (words[0] == "plug") {
    auto path = surroundings.plug();
    if (!path) return path;
    return "the port is " + *path;
  }
  if (words[0] == "quit") {
    surroundings.quit();
    return "ending";
  }
  return failure("There is no command \"" + words[0] + "\"; see --help.");
}

}  // namespace tessera::world
