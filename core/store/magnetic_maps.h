// Magnetic maps of floors in the database, one for each site file and world: what was learned in a simulated one must
// not lead a vehicle on the real floor.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "locate/magnetic_map.h"
#include "store/database.h"

namespace tessera::store {

class MagneticMaps {
public:
  explicit MagneticMaps(Database& database) : database_{database} {}

  /// Takes the place of what was kept under this key (as SiteStore's). An empty map: nothing is kept from now on.
  [[nodiscard]] Result<void> save(const std::string& key, bool simulated, const locate::MagneticMap& map,
                                  std::int64_t utcMs);
  /// Null: nothing is kept. Error: the database cannot be read, or the map is damaged.
  [[nodiscard]] Result<std::shared_ptr<const locate::MagneticMap>> load(const std::string& key, bool simulated) const;

private:
  Database& database_;
};

}  // namespace tessera::store
