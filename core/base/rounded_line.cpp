#include "base/rounded_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tessera {
namespace {

constexpr Metres kSame{1e-6};  // points nearer to each other are one

// A vertex with what its arc would like to have of the legs beside it, and what it gets.
struct Corner {
  double turn = 0.0;  // rad, signed
  bool rounded = false;
  Metres wanted;
  Metres tangent;
  [[nodiscard]] double radius(Metres t) const { return t.value() / std::tan(0.5 * std::abs(turn)); }
};

// Of a leg both ends may have half, and one what the other does not want.
Metres shareOf(Metres leg, Metres wanted, Metres atOtherEnd) {
  if (wanted + atOtherEnd <= leg) return wanted;
  return std::min(wanted, std::max(0.5 * leg, leg - atOtherEnd));
}

std::vector<Corner> cornersOf(const Polyline& line, Metres cut, Radians sharp) {
  std::vector<Corner> corners(line.vertices().size());
  for (std::size_t v = 1; v < line.legCount(); ++v) {
    Corner& corner = corners[v];
    corner.turn = turnBetween(line.headingOf(v - 1), line.headingOf(v)).value();
    const double size = std::abs(corner.turn);
    if (!(size >= sharp.value()) || !(size > 1e-6)) continue;
    // cut = r (1 / cos(turn / 2) - 1), tangent = r tan(turn / 2)
    corner.wanted = std::min(cut / std::tan(0.25 * size), std::tan(0.5 * size) * kWidestArc);
    corner.rounded = corner.radius(corner.wanted) >= kTightestArc.value();
  }
  return corners;
}

// What each gets; those that get too little stay corners, and leave it to their neighbours.
void share(const Polyline& line, std::vector<Corner>& corners) {
  for (bool again = true; std::exchange(again, false);) {
    const auto wish = [&](std::size_t v) { return corners[v].rounded ? corners[v].wanted : Metres{}; };
    for (std::size_t v = 1; v < line.legCount(); ++v) {
      const auto leg = [&](std::size_t n) { return line.startOf(n + 1) - line.startOf(n); };
      corners[v].tangent = std::min(shareOf(leg(v - 1), wish(v), wish(v - 1)), shareOf(leg(v), wish(v), wish(v + 1)));
    }
    for (Corner& corner : corners) {
      if (!corner.rounded || corner.radius(corner.tangent) >= kTightestArc.value() * (1.0 - 1e-9)) continue;
      corner.rounded = false;
      again = true;
    }
  }
}

}  // namespace

RoundedLine::RoundedLine(const Polyline& drawn, Metres cut, Radians sharp) : drawn_{drawn}, line_{drawn} {
  if (!(cut > Metres{}) || !std::isfinite(cut.value())) return;
  std::vector<Corner> corners = cornersOf(drawn, cut, sharp);
  share(drawn, corners);
  std::vector<Point> points;
  const auto add = [&points](Point p) {
    if (points.empty() || distance(points.back(), p) > kSame) points.push_back(p);
  };
  Metres saved;  // way, by the arcs so far
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const Point vertex = drawn.vertices()[v];
    const Corner& corner = corners[v];
    if (!corner.rounded) {
      add(vertex);
      continue;
    }
    const Offset before = turned({corner.tangent, Metres{}}, drawn.headingOf(v - 1));
    const Metres radius{corner.radius(corner.tangent)};
    const Point begin = vertex - before;
    const Offset out = turned({Metres{}, (corner.turn > 0 ? -1.0 : 1.0) * radius}, drawn.headingOf(v - 1));
    const Point centre = begin - out;
    const int steps = 2 * static_cast<int>(std::ceil(0.5 * std::abs(corner.turn) / kArcBend.value()));
    for (int i = 0; i < steps; ++i) add(centre + turned(out, Radians{corner.turn * i / steps}));
    add(vertex + turned({corner.tangent, Metres{}}, drawn.headingOf(v)));
    const Metres length = 2.0 * steps * std::sin(0.5 * std::abs(corner.turn) / steps) * radius;
    const Metres from = drawn.startOf(v) - corner.tangent - saved;
    arcs_.push_back({from, from + length, drawn.startOf(v), corner.tangent, radius});
    saved += 2.0 * corner.tangent - length;
  }
  if (arcs_.empty()) return;
  points.back() = drawn.vertices().back();  // also where the last arc ends there
  line_ = Polyline{points};
}

Metres RoundedLine::onDrawn(Metres along) const {
  const auto next =
      std::partition_point(arcs_.begin(), arcs_.end(), [along](const Arc& arc) { return arc.from <= along; });
  if (next == arcs_.begin()) return along;
  const Arc& arc = *std::prev(next);
  if (along >= arc.to) return arc.vertex + arc.tangent + (along - arc.to);
  return arc.vertex + (2.0 * ((along - arc.from) / (arc.to - arc.from)) - 1.0) * arc.tangent;
}

Metres RoundedLine::onLine(Metres along) const {
  const auto next = std::partition_point(arcs_.begin(), arcs_.end(),
                                         [along](const Arc& arc) { return arc.vertex - arc.tangent <= along; });
  if (next == arcs_.begin()) return along;
  const Arc& arc = *std::prev(next);
  const Metres past = along - (arc.vertex - arc.tangent);
  if (past >= 2.0 * arc.tangent) return arc.to + (past - 2.0 * arc.tangent);
  return arc.from + (past / (2.0 * arc.tangent)) * (arc.to - arc.from);
}

std::vector<Point> verticesBetween(const Polyline& line, Metres from, Metres to) {
  constexpr Metres kSameEnd{2e-6};  // of an arc and of its chain
  std::vector<Point> points;
  for (std::size_t v = line.legAt(from); v < line.vertices().size() && line.startOf(v) <= to + kSameEnd; ++v)
    if (line.startOf(v) >= from - kSameEnd) points.push_back(line.vertices()[v]);
  return points;
}

}  // namespace tessera
