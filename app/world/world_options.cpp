#include "app/world/world_options.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <map>

namespace tessera::world {

namespace {

const std::map<std::string, Kind> kKinds{{"native", Kind::Native}, {"qemu", Kind::Qemu}};

std::string text(double v) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17g", v);
  return buffer.data();
}

}  // namespace

void addWorldConditions(CLI::App& app, WorldOptions& o) {
  const CLI::Range probability{0.0, 1.0};
  app.add_option("--seed", o.seed,
                 "Chance of the whole world: with the same seed all errors are drawn alike. In virtual time runs "
                 "repeat exactly, in real time nearly")
      ->group("World")
      ->capture_default_str();
  app.add_option("--air-rate,--air", o.airRate, "Air rate of all radios in bit/s (default: the site's)")
      ->group("World")
      ->check(CLI::IsMember{std::vector<double>{300, 1200, 2400, 4800, 9600, 19200}});
  app.add_option("--air-factor", o.airFactor, "Time on air over the formula's; 1 to 3.2 were seen in the field")
      ->group("World")
      ->check(CLI::Range{0.1, 20.0})
      ->capture_default_str();
  app.add_option("--loss", o.loss, "Probability that a receiver misses a packet")
      ->group("World")
      ->check(probability)
      ->capture_default_str();
  app.add_option("--delay", o.delay, "Further delay of each packet in seconds")
      ->group("World")
      ->check(CLI::Range{0.0, 10.0})
      ->capture_default_str();
  app.add_option("--readers", o.readers,
                 "Every vehicle has so many RFID readers in a row across its nose (default: as the site says)")
      ->group("World")
      ->check(CLI::Range{1U, 8U});
  app.add_option("--poll", o.poll, "Seconds between two attempts of an RFID reader (default 0.1)")
      ->group("World")
      ->check(CLI::Range{0.005, 10.0});
  app.add_option("--read-time", o.readTime, "Seconds from a reader's asking the floor to its result (default 0.02)")
      ->group("World")
      ->check(CLI::Range{0.0, 0.2});
  app.add_option("--detection", o.detection, "Share of attempts that succeed over a tag (default 0.9)")
      ->group("World")
      ->check(probability);
  app.add_option("--radius", o.radius, "Radius of every reader's disc in metres (default: as the site says)")
      ->group("World")
      ->check(CLI::Range{0.005, 0.5});
  app.add_option("--true-radius", o.trueRadius,
                 "True radius of those discs, where it is not what the site is told (default: the same)")
      ->group("World")
      ->check(CLI::Range{0.005, 0.5});
  app.add_option("--dead-tags", o.deadTags, "Share of the site's tags that no reader sees (default 0)")
      ->group("World")
      ->check(probability);
  app.add_option("--slip", o.slip, "Mean share of the way that wheels turn without driving it (default 0)")
      ->group("World")
      ->check(CLI::Range{0.0, 0.5});
  app.add_option("--tyre-difference", o.tyreDifference,
                 "The right tyre is larger than the left one by this share, and encoders do not see it (default 0)")
      ->group("World")
      ->check(CLI::Range{-0.2, 0.2});
  app.add_option("--heading-learning", o.headingLearning,
                 "Vehicles learn their tyres' difference over so many metres; 0: they do not (default: the firmware's)")
      ->group("World")
      ->check(CLI::Range{0.0, 100.0});
  app.add_option("--speed-noise", o.speedNoise,
                 "Standard deviation of a wandering slip of both wheels, a share (default 0)")
      ->group("World")
      ->check(CLI::Range{0.0, 0.5});
  app.add_option("--speed-noise-time", o.speedNoiseTime,
                 "Seconds over which that slip is forgotten (default 0.5); 0.05 is as good as white at 10 Hz")
      ->group("World")
      ->check(CLI::Range{0.01, 60.0});
  app.add_option("--compass-noise", o.compassNoise, "Standard deviation of one sample in degrees (default 0.6)")
      ->group("World")
      ->check(CLI::Range{0.0, 45.0});
  app.add_option("--compass-bias", o.compassBias, "Error of the compass' mounting in degrees (default 2)")
      ->group("World")
      ->check(CLI::Range{0.0, 45.0});
  app.add_option("--compass-spots", o.compassSpots, "Deviation over iron in the floor in degrees (default 10)")
      ->group("World")
      ->check(CLI::Range{0.0, 45.0});
  app.add_option("--floor-seed", o.floorSeed,
                 "Seed of where the iron lies, so that other vehicles or another day meet the same floor (default: the "
                 "seed)")
      ->group("World");
  app.add_option("--corrupt", o.corrupt, "Probability that a byte of a packet is changed on the air")
      ->group("World")
      ->check(probability)
      ->capture_default_str();
  app.add_option("--drop", o.drop, "Probability that a packet is suppressed for every receiver")
      ->group("World")
      ->check(probability)
      ->capture_default_str();
  app.add_option("--replay", o.replay, "Probability, for each packet, that an older one is sent once more")
      ->group("World")
      ->check(probability)
      ->capture_default_str();
  app.add_option("--eeprom-dir", o.eepromDir,
                 "Folder that keeps each vehicle's EEPROM as vehicle-ID.eeprom (default: a fresh one each run, "
                 "set up and calibrated as by an integrator)")
      ->group("World");
}

void addWorldCast(CLI::App& app, WorldOptions& o) {
  app.add_option("SITE", o.site, "Site file, *.tessera.json")->required();
  app.add_option("--vehicle", o.vehicles,
                 "Address of a vehicle to put there; may be repeated (default: all of the site)")
      ->allow_extra_args(false)
      ->check(CLI::Range{1U, 254U});
  app.add_option(
         "--fresh", o.fresh,
         "Address of a vehicle that nobody has set up: its EEPROM is empty, it answers at the address 254 under "
         "the factory key; may be repeated")
      ->allow_extra_args(false)
      ->check(CLI::Range{1U, 254U});
  app.add_option("--kind", o.kind, "native: firmware compiled for this machine; qemu: in an emulated LM3S6965")
      ->transform(CLI::CheckedTransformer{kKinds, CLI::ignore_case}.description("{native,qemu}"))
      ->default_str("native");
  app.add_option("--firmware", o.firmware,
                 "Firmware for --kind qemu (default: tessera-vehicle.elf beside this program)");
  app.add_option("--truth", o.truth, "File for the true poses, 50 rows a second for each vehicle (CSV)");
}

std::vector<std::string> worldArguments(const WorldOptions& o) {
  std::vector<std::string> words{o.site};
  const auto add = [&](const char* name, const std::string& value) {
    words.emplace_back(name);
    words.push_back(value);
  };
  const auto number = [&](const char* name, double value) { add(name, text(value)); };
  const auto maybe = [&](const char* name, const std::optional<double>& value) {
    if (value) number(name, *value);
  };
  const auto path = [&](const char* name, const std::string& value) {
    if (!value.empty()) add(name, value);
  };
  for (const unsigned id : o.vehicles) add("--vehicle", std::to_string(id));
  for (const unsigned id : o.fresh) add("--fresh", std::to_string(id));
  add("--kind", o.kind == Kind::Qemu ? "qemu" : "native");
  path("--firmware", o.firmware);
  path("--eeprom-dir", o.eepromDir);
  path("--truth", o.truth);
  add("--seed", std::to_string(o.seed));
  if (o.floorSeed) add("--floor-seed", std::to_string(*o.floorSeed));
  maybe("--air-rate", o.airRate);
  number("--air-factor", o.airFactor);
  number("--loss", o.loss);
  number("--delay", o.delay);
  if (o.readers) add("--readers", std::to_string(*o.readers));
  maybe("--poll", o.poll);
  maybe("--read-time", o.readTime);
  maybe("--detection", o.detection);
  maybe("--radius", o.radius);
  maybe("--true-radius", o.trueRadius);
  maybe("--dead-tags", o.deadTags);
  maybe("--slip", o.slip);
  maybe("--tyre-difference", o.tyreDifference);
  maybe("--heading-learning", o.headingLearning);
  maybe("--speed-noise", o.speedNoise);
  maybe("--speed-noise-time", o.speedNoiseTime);
  maybe("--compass-noise", o.compassNoise);
  maybe("--compass-bias", o.compassBias);
  maybe("--compass-spots", o.compassSpots);
  number("--corrupt", o.corrupt);
  number("--drop", o.drop);
  number("--replay", o.replay);
  return words;
}

}  // namespace tessera::world
