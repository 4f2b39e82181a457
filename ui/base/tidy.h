// Places as a site file may hold them and a person reads them.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/pose.h"

namespace tessera::ui {

inline constexpr Metres kFarthest{100'000.0};  ///< coordinates that a site file may hold

/// To the millimetre within what a site file holds: what is drawn can be read in the table.
[[nodiscard]] inline Point tidy(Point p) {
  const auto millimetres = [](Metres m) {
    const double most = kFarthest.value();
    return Metres{std::clamp(std::round(m.value() * 1000.0) / 1000.0, -most, most) + 0.0};
  };
  return {millimetres(p.x), millimetres(p.y)};
}

}  // namespace tessera::ui
