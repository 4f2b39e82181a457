// A magnetic map in a file, from one experiment to the next.
#pragma once

#include <string>

#include "base/result.h"
#include "supervisor/snapshot.h"
#include "supervisor/supervisor.h"

namespace tessera::cli {

/// The floor's iron, as drives before have learned it: vehicles are located by it. A file that is not there yet begins
/// an empty map; an empty name: none. Error: a file that holds no such map.
[[nodiscard]] Result<void> takeMagneticMap(const std::string& file, supervisor::Config& config);
/// What the last picture of the fleet knows. Null, or an empty name: nothing is written.
[[nodiscard]] Result<void> keepMagneticMap(const std::string& file, const supervisor::Snapshot* last);

}  // namespace tessera::cli
