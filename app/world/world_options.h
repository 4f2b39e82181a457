// What the simulated world can be told, as command-line options with their ranges and defaults; the same for
// tessera-world and for programs that make a world of their own.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tessera::world {

enum class Kind { Native, Qemu };

struct WorldOptions {
  // Who is there.
  std::string site;                ///< path of the *.tessera.json file
  std::vector<unsigned> vehicles;  ///< addresses; empty: all of the site
  std::vector<unsigned> fresh;     ///< of these: as from the factory, with an empty EEPROM
  Kind kind = Kind::Native;
  std::string firmware;   ///< ELF for Kind::Qemu; empty: tessera-vehicle.elf beside the program
  std::string eepromDir;  ///< keeps vehicle-ID.eeprom; empty: nothing outlives the run
  std::string truth;      ///< CSV of true poses; empty: none
  // How the world is.
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> floorSeed;  ///< of the iron in the floor; the seed where not given
  std::optional<double> airRate;           ///< bit/s; the site's where not given
  double airFactor = 1.8;
  double loss = 0.02;
  double delay = 0.0;                     ///< s
  std::optional<unsigned> readers;        ///< 1 to 8; the vehicle's setup where not given
  std::optional<double> poll;             ///< s
  std::optional<double> readTime;         ///< s, 0 to 0.2
  std::optional<double> detection;        ///< 0 to 1
  std::optional<double> radius;           ///< m, of the vehicles' setup; as the site says where not given
  std::optional<double> trueRadius;       ///< m; the setup's where not given
  std::optional<double> deadTags;         ///< share of the site's tags that nobody reads, 0 to 1
  std::optional<double> slip;             ///< 0 to 0.5
  std::optional<double> tyreDifference;   ///< -0.2 to 0.2
  std::optional<double> headingLearning;  ///< m, 0 to 100
  std::optional<double> speedNoise;       ///< 0 to 0.5
  std::optional<double> speedNoiseTime;   ///< s, 0.01 to 60
  std::optional<double> compassNoise;     ///< degrees
  std::optional<double> compassBias;      ///< degrees
  std::optional<double> compassSpots;     ///< degrees
  // Adversity on the air, probabilities for each packet.
  double corrupt = 0.0;
  double drop = 0.0;
  double replay = 0.0;
};

/// How the world is: --seed, --air-rate and so on, --eeprom-dir included.
void addWorldConditions(CLI::App& app, WorldOptions& options);
/// Who is there: SITE, --vehicle, --kind, --firmware, --truth.
void addWorldCast(CLI::App& app, WorldOptions& options);
/// The words with which tessera-world gets the same options.
[[nodiscard]] std::vector<std::string> worldArguments(const WorldOptions& options);

}  // namespace tessera::world
