// Makes a world from a site and options: vehicles as an integrator would hand them over, set up, keyed and with their
// compass calibrated, standing at their places with their batteries not yet connected.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/world/world_options.h"
#include "base/result.h"
#include "sim/native_host.h"
#include "sim/world.h"

namespace tessera::world {

/// A folder that is gone when its holder is.
class TemporaryFolder {
public:
  TemporaryFolder() = default;
  [[nodiscard]] static Result<TemporaryFolder> make();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept;
  ~TemporaryFolder();
  [[nodiscard]] const std::string& path() const { return path_; }

private:
  std::string path_;
};

struct MadeWorld {
  struct Member {
    VehicleId id;
    std::string name;
  };
  TemporaryFolder folder;  ///< for EEPROMs that nobody wants to keep; declared first, as it must go last
  std::unique_ptr<sim::World> world;
  std::vector<Member> vehicles;

  struct Keeper {
    std::string path;
    const sim::NativeHost* host;  ///< owned by the world
  };
  std::vector<Keeper> keepers;
  /// Writes native vehicles' EEPROMs to --eeprom-dir, where one was given; emulated ones write theirs themselves.
  Result<void> saveEeproms() const;
};

/// The site as the options have it: radio, readers and their discs' radius. World and supervisor must be told the same.
void applyTo(floor::Site& site, const WorldOptions& options);
/// How well a vehicle's parts work under these options.
[[nodiscard]] sim::BodyParameters bodyFor(const floor::VehicleSetup& setup, const WorldOptions& options);

/// The world's clock begins at `start`. Vehicles are not yet switched on: World::startAll(). A vehicle without a file
/// in the EEPROM folder is set up anew, which takes a moment for each (its compass is calibrated on a bench in virtual
/// time). Error: a sentence that names the file, vehicle or option concerned.
[[nodiscard]] Result<MadeWorld> makeWorld(const WorldOptions& options, Seconds start);
/// The same for a site that is already read; options.site is not looked at.
[[nodiscard]] Result<MadeWorld> makeWorld(const WorldOptions& options, floor::Site site, Seconds start);

}  // namespace tessera::world
