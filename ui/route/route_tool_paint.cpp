// What the route tool shows: the unfinished route with its rubber band, the handles of the chosen one, the numbers, and
// what is wrong with it.
#include <QFontMetricsF>
#include <QLineF>
#include <algorithm>

#include "ui/canvas/clip.h"
#include "ui/canvas/readout.h"
#include "ui/canvas/round_way_painter.h"
#include "ui/canvas/route_painter.h"
#include "ui/route/route_tool.h"

namespace tessera::ui {
namespace {

constexpr double kHandle = 5.5;

}  // namespace

void RouteTool::paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (const floor::Route* chosen = route()) {
    const floor::Route& shown = drag_ ? drag_->route : *chosen;
    if (!isDrawing()) paintRoundWays(painter, scene.view, theme, shown, scene.map.site().vehicles);
    paintRoute(painter, scene.view, theme, shown, isDrawing() ? RouteLook::Quiet : RouteLook::Chosen);
    if (!isDrawing()) paintHandles(painter, scene, theme, shown);
  }
  paintMarks(painter, scene.view, theme, trialFaults_, std::nullopt,
             [&](QPointF pixel) { return hasHandleAt(pixel, scene); });
  if (isDrawing()) paintDraft(painter, scene, theme);
}

// Of what is drawn, and of what is being drawn: a sign upon the vertex in the hand would hide where that goes.
bool RouteTool::hasHandleAt(QPointF pixel, const CanvasScene& scene) const {
  const auto at = [&](const std::vector<Point>& vertices) {
    return std::any_of(vertices.begin(), vertices.end(), [&](Point p) {
      return QLineF{scene.view.toPixel(p), pixel}.length() <= kMarkReach + kHandle;
    });
  };
  if (isDrawing()) return at(draft());
  const floor::Route* chosen = route();
  return chosen != nullptr && at(drag_ ? drag_->route.vertices : chosen->vertices);
}

std::optional<floor::Route> RouteTool::trial() const {
  if (drag_ && route() != nullptr) return drag_->route;
  if (!isDrawing()) return std::nullopt;
  floor::Route drawn{edits_.freeName().toStdString(), draft(), floor::Route{}.controlSpacing};
  if (pointer_ && !draft().empty() && draft().back() != pointer_->place) drawn.vertices.push_back(pointer_->place);
  return drawn.vertices.size() < 2 ? std::nullopt : std::optional{drawn};
}

void RouteTool::setTrialFaults(std::vector<FloorMark> faults) {
  if (faults == trialFaults_) return;
  trialFaults_ = std::move(faults);
  Q_EMIT changed();
}

// The worst two: more would hide the floor that is drawn on.
QStringList RouteTool::wrong() const {
  QStringList sentences;
  for (const bool severe : {true, false}) {
    for (const FloorMark& fault : trialFaults_)
      if (fault.severe == severe && sentences.size() < 2) sentences << fault.sentence;
  }
  return sentences;
}

void RouteTool::paintHandles(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme,
                             const floor::Route& shown) {
  const View& view = scene.view;
  const SiteBox seen = view.visible(20.0);
  for (std::size_t n = 0; !drag_ && n + 1 < shown.vertices.size(); ++n) {
    const Point middle = shown.vertices[n] + 0.5 * (shown.vertices[n + 1] - shown.vertices[n]);
    if (view.pixels(distance(shown.vertices[n], shown.vertices[n + 1])) < kMiddleFrom || !seen.contains(middle))
      continue;
    const bool hot = hover_ == Hit{Hit::Kind::Middle, n};
    paintHandle(painter, view.toPixel(middle), hot ? kHandle + 1 : kHandle - 1, hot ? theme.accent : theme.halo,
                hot ? theme.halo : theme.selectedRoute);
  }
  const QFontMetricsF metrics{painter.font()};
  const auto ring = [&](std::size_t n, double width) {
    painter.setPen(QPen{theme.accent, width});
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(view.toPixel(shown.vertices[n]), metrics.height() * 0.72, metrics.height() * 0.72);
  };
  if (hover_.kind == Hit::Kind::Vertex && hover_.index < shown.vertices.size()) ring(hover_.index, 2.0);
  const auto current = drag_ ? std::optional{drag_->index} : vertex_;
  if (!current || *current >= shown.vertices.size()) return;
  ring(*current, 3.0);
  if (!drag_ || !drag_->moved) return;
  if (pointer_) paintSnap(painter, view, theme, *pointer_);
  const Point at = shown.vertices[*current];
  const Radians north = scene.map.site().northToY;
  QStringList lines{placeText(at)};
  if (*current > 0) lines << legText(shown.vertices[*current - 1], at, north);
  if (*current + 1 < shown.vertices.size()) lines << legText(at, shown.vertices[*current + 1], north);
  if (const QString kind = pointer_ ? snapText(pointer_->kind) : QString{}; !kind.isEmpty()) lines << kind;
  paintReadout(painter, view, theme, view.toPixel(at), lines, wrong());
}

void RouteTool::paintDraft(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  const View& view = scene.view;
  const QRectF around = QRectF{QPointF{}, view.size()}.adjusted(-20, -20, 20, 20);
  if (draft().size() >= 2) {
    paintRoute(painter, view, theme, floor::Route{{}, draft(), Metres{1e9}}, RouteLook::Chosen);
  } else if (draft().size() == 1) {
    paintHandle(painter, view.toPixel(draft().front()), kHandle, theme.selectedRoute, theme.halo);
  }
  if (!pointer_) return;
  QStringList lines;
  if (!draft().empty()) {
    const QLineF band{view.toPixel(draft().back()), view.toPixel(pointer_->place)};
    if (const auto seen = clipped(band, around)) {
      painter.setPen(QPen{theme.accent, 2.0, Qt::DashLine, Qt::RoundCap});
      painter.drawLine(*seen);
    }
    if (draft().back() != pointer_->place) lines << legText(draft().back(), pointer_->place, scene.map.site().northToY);
  }
  lines << placeText(pointer_->place);
  if (const QString kind = snapText(pointer_->kind); !kind.isEmpty()) lines << kind;
  paintSnap(painter, view, theme, *pointer_);
  paintReadout(painter, view, theme, view.toPixel(pointer_->place), lines, wrong());
}

}  // namespace tessera::ui
