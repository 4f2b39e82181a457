#include "sitecheck/round_ways.h"

#include <algorithm>

#include "base/rounded_line.h"
#include "sitecheck/body.h"

namespace tessera::sitecheck {
namespace {

using floor::VehicleSetup;

Polyline between(const Polyline& line, Metres from, Metres to) { return Polyline{verticesBetween(line, from, to)}; }

}  // namespace

std::vector<RoundWay> roundWaysOf(const Context& context, const Polyline& line) {
  std::vector<RoundWay> ways;
  std::vector<Metres> cuts{Metres{}};
  for (const VehicleSetup* v : bodiesOf(context.site)) {
    if (std::find(cuts.begin(), cuts.end(), v->cornerCut) != cuts.end()) continue;
    cuts.push_back(v->cornerCut);
    const RoundedLine round{line, v->cornerCut, context.options.sharpCorner};
    if (round.arcs().empty()) continue;
    RoundWay way{v, round.line(), {}};
    std::size_t vertex = 0;
    for (const RoundedLine::Arc& arc : round.arcs()) {
      while (line.startOf(vertex) < arc.vertex) ++vertex;
      const Metres middle = 0.5 * (arc.from + arc.to);
      RoundCorner corner{vertex, between(way.whole, arc.from, middle), between(way.whole, middle, arc.to), {}};
      corner.box = boxAround(boxAround(corner.before.vertices()), boxAround(corner.behind.vertices()));
      way.corners.push_back(std::move(corner));
    }
    ways.push_back(std::move(way));
  }
  return ways;
}

}  // namespace tessera::sitecheck
