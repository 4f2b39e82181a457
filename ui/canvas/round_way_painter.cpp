#include "ui/canvas/round_way_painter.h"

#include <algorithm>

#include "drive/driven_way.h"
#include "ui/canvas/clip.h"
#include "ui/canvas/strokes.h"

namespace tessera::ui {
namespace {

constexpr double kArcFrom = 3.0;            // pixels between an arc and its vertex, to draw it at all
constexpr double kStroke = 20.0;            // pixels, more than a stroke reaches beyond its line
constexpr std::size_t kMostCorners = 2000;  // of a route; more are not rounded here, as each paint rounds them anew

QPolygonF chainOf(const Polyline& line, const RoundedLine::Arc& arc, const View& view) {
  QPolygonF chain;
  for (const Point& p : verticesBetween(line, arc.from, arc.to)) chain << view.toPixel(p);
  return chain;
}

}  // namespace

void paintRoundWays(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                    const std::vector<floor::VehicleSetup>& vehicles) {
  if (route.vertices.size() > kMostCorners) return;
  SiteBox box;
  for (const Point& p : route.vertices) box.add(p);
  const QRectF window{QPointF{}, view.size()};
  const QRectF drawn = painter.hasClipping() ? painter.clipBoundingRect().intersected(window) : window;
  SiteBox seen;
  seen.add(view.toSite(drawn.topLeft()));
  seen.add(view.toSite(drawn.bottomRight()));
  seen = seen.grown(view.metres(kStroke));
  if (!box.touches(seen)) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF around = drawn.adjusted(-kStroke, -kStroke, kStroke, kStroke);
  std::vector<Metres> cuts;
  for (const floor::VehicleSetup& vehicle : vehicles) {
    if (view.pixels(vehicle.cornerCut) < kArcFrom) continue;
    if (std::find(cuts.begin(), cuts.end(), vehicle.cornerCut) != cuts.end()) continue;
    cuts.push_back(vehicle.cornerCut);
    const RoundedLine way = drive::drivenWay(route, drive::abilityOf(vehicle));
    for (const RoundedLine::Arc& arc : way.arcs()) {
      // An arc is never farther from its vertex than where it begins.
      if (!seen.grown(arc.tangent).contains(way.drawn().at(arc.vertex))) continue;
      for (const QPolygonF& run : runsWithin(chainOf(way.line(), arc, view), around)) {
        for (const auto& [colour, width] : {std::pair{theme.halo, 4.0}, std::pair{theme.selectedRoute, 2.0}}) {
          painter.setPen(QPen{colour, width, Qt::SolidLine, Qt::SquareCap, Qt::BevelJoin});
          strokePolyline(painter, run);
        }
      }
    }
  }
}

}  // namespace tessera::ui
