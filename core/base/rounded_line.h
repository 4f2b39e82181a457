// A line whose corners are rounded by arcs, for who may leave its vertices by a little, and how distances along the
// two go together.
#pragma once

#include <vector>

#include "base/angle.h"
#include "base/polyline.h"

namespace tessera {

/// By this, at most, the chain of legs bends that stands for an arc.
inline constexpr Radians kArcBend{5.0 * kPi / 180.0};
/// No arc is tighter than this: it would have to be crept through, which takes longer than a turn on the spot.
inline constexpr Metres kTightestArc{0.05};
/// And none wider: nobody need leave the line for so long.
inline constexpr Metres kWidestArc{2.0};

class RoundedLine {
public:
  /// An arc in the place of a vertex: a chain of legs whose ends lie on the arc. It touches the legs beside it, and its
  /// middle lies nearest to the vertex.
  struct Arc {
    Metres from;     ///< on line()
    Metres to;       ///< on line()
    Metres vertex;   ///< on drawn()
    Metres tangent;  ///< from the vertex to where the arc begins, and from where it ends
    Metres radius;
  };

  RoundedLine() = default;
  /// Rounds the vertices at which `drawn` turns by `sharp` or more, leaving each by `cut` at most; by less where its
  /// legs are too short, of which each vertex may have half, and what the vertex at the other end leaves. What turns
  /// nearly back, and what has no room for an arc, stays a corner; with a cut of 0, or of no number, everything does.
  RoundedLine(const Polyline& drawn, Metres cut, Radians sharp);

  [[nodiscard]] const Polyline& line() const { return line_; }
  [[nodiscard]] const Polyline& drawn() const { return drawn_; }
  [[nodiscard]] const std::vector<Arc>& arcs() const { return arcs_; }  ///< in the order of the line
  /// The distance along drawn() that belongs to one along line(). Grows with it; an arc's middle is its vertex's.
  [[nodiscard]] Metres onDrawn(Metres along) const;
  /// The same the other way round.
  [[nodiscard]] Metres onLine(Metres along) const;

private:
  Polyline drawn_;
  Polyline line_;
  std::vector<Arc> arcs_;
};

/// The vertices of a line from one distance along it to another, both ends included where a vertex lies there.
[[nodiscard]] std::vector<Point> verticesBetween(const Polyline& line, Metres from, Metres to);

}  // namespace tessera
