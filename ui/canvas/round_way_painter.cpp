#include "ui/canvas/round_way_painter.h"

#include <algorithm>

#include "drive/driven_way.h"
#include "ui/canvas/clip.h"
#include "ui/canvas/strokes.h"

namespace tessera::ui {
namespace {

constexpr double kArcFrom = 3.0;             // pixels between an arc and its vertex, to draw it at all
constexpr Metres kSameEnd{2e-6};             // of an arc and of its chain
constexpr std::size_t kMostCorners = 20000;  // of a route; more are not rounded here

QPolygonF chainOf(const Polyline& line, const RoundedLine::Arc& arc, const View& view) {
  QPolygonF chain;
  for (std::size_t v = line.legAt(arc.from); v < line.vertices().size() && line.startOf(v) <= arc.to + kSameEnd; ++v)
    if (line.startOf(v) >= arc.from - kSameEnd) chain << view.toPixel(line.vertices()[v]);
  return chain;
}

}  // namespace

void paintRoundWays(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                    const std::vector<floor::VehicleSetup>& vehicles) {
  if (route.vertices.size() > kMostCorners) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF window{QPointF{}, view.size()};
  const QRectF around =
      (painter.hasClipping() ? painter.clipBoundingRect().intersected(window) : window).adjusted(-20, -20, 20, 20);
  std::vector<Metres> drawn;
  for (const floor::VehicleSetup& vehicle : vehicles) {
    if (view.pixels(vehicle.cornerCut) < kArcFrom) continue;
    if (std::find(drawn.begin(), drawn.end(), vehicle.cornerCut) != drawn.end()) continue;
    drawn.push_back(vehicle.cornerCut);
    const RoundedLine way = drive::drivenWay(route, drive::abilityOf(vehicle));
    for (const RoundedLine::Arc& arc : way.arcs()) {
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
