// What of the floor is shown; the operator switches each on and off.
#pragma once

namespace tessera::ui {

struct CanvasLayers {
  bool backdrop = true;
  bool tags = true;
  bool zones = true;
  bool routes = true;
  bool trails = true;
  bool uncertainty = true;
  bool grid = true;
  bool faults = true;
  bool iron = false;  ///< MagneticLayer
  bool operator==(const CanvasLayers&) const = default;
};

}  // namespace tessera::ui
