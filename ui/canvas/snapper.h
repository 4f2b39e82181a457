// Where a click is meant to be: at a vertex, a tag, a tile's corner, middle or edge, or in a straight direction.
#pragma once

#include <optional>
#include <span>

#include "ui/canvas/canvas_tool.h"

namespace tessera::ui {

struct Snap {
  enum class Kind { None, Vertex, Tag, TileCorner, TileMiddle, TileEdge, Direction };
  Point place;
  Kind kind = Kind::None;
};

struct SnapWish {
  bool off = false;                 ///< Alt: just there, to the millimetre
  std::optional<Point> from;        ///< Shift: at a multiple of 45 degrees from here
  std::span<const Point> vertices;  ///< of what is at hand, to close it or to lie over one another
};

/// What is within kReach pixels counts, vertices before tags before tiles; else a whole centimetre (or more when
/// zoomed out, so that the numbers stay round).
inline constexpr double kSnapReach = 11.0;
[[nodiscard]] Snap snapped(const CanvasScene& scene, QPointF pixel, const SnapWish& wish);

}  // namespace tessera::ui
