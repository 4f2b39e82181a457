#include "ui/route/route_tool.h"

#include <QApplication>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/wording.h"
#include "ui/canvas/route_painter.h"

namespace tessera::ui {
namespace {

constexpr double kVertexReach = 10.0;
constexpr double kMiddleReach = 8.0;
constexpr double kLegReach = 7.0;
constexpr double kMiddleFrom = 44.0;  // pixels of a leg that has room for a handle in its middle
constexpr int kFirstNudgeKey = 1'000'000;

double pixelsBetween(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

}  // namespace

RouteTool::RouteTool(SiteDocument& document, Selection& selection, QWidget* window)
    : CanvasTool{window},
      document_{document},
      selection_{selection},
      edits_{document},
      window_{window},
      nudges_{kFirstNudgeKey} {
  connect(&document_, &SiteDocument::changed, this, &RouteTool::documentChanged);
  connect(&document_, &SiteDocument::replaced, this, [this] {
    drawing_ = false;
    forgetUnfinished();
  });
  connect(&selection_, &Selection::routeChanged, this, [this] {
    drag_.reset();
    setVertex(std::nullopt);
    touch();
  });
}

void RouteTool::touch() {
  Q_EMIT changed();
  Q_EMIT hintChanged(hint());
}

void RouteTool::tell(const Result<void>& result) {
  if (!result) Q_EMIT refused(text(result.error().sentence));
}

void RouteTool::forgetUnfinished() {
  draft_.clear();
  takenBack_.clear();
  drag_.reset();
  hover_ = {};
  setVertex(std::nullopt);
  touch();
}

void RouteTool::documentChanged() {
  if (editing_) return;
  drag_.reset();  // of a route that is another now
  hover_ = {};
  if (const floor::Route* r = route(); vertex_ && (r == nullptr || *vertex_ >= r->vertices.size()))
    setVertex(std::nullopt);
  touch();
}

void RouteTool::startDrawing() {
  drawing_ = true;
  forgetUnfinished();
}

void RouteTool::setVertex(std::optional<std::size_t> vertex) {
  if (const floor::Route* r = route(); vertex && (r == nullptr || *vertex >= r->vertices.size())) vertex.reset();
  if (vertex == vertex_) return;
  vertex_ = vertex;
  ++nudges_;
  Q_EMIT vertexChanged(vertex_);
  touch();
}

RouteTool::Hit RouteTool::hitAt(QPointF pixel, const CanvasScene& scene) const {
  const floor::Route* r = route();
  if (r == nullptr) return {};
  Hit hit;
  double nearest = kVertexReach;
  for (std::size_t n = 0; n < r->vertices.size(); ++n) {
    const double away = pixelsBetween(scene.view.toPixel(r->vertices[n]), pixel);
    if (away > nearest) continue;
    nearest = away;
    hit = {Hit::Kind::Vertex, n};
  }
  if (hit.kind != Hit::Kind::None) return hit;
  nearest = kMiddleReach;
  for (std::size_t n = 0; n + 1 < r->vertices.size(); ++n) {
    const QPointF a = scene.view.toPixel(r->vertices[n]);
    const QPointF b = scene.view.toPixel(r->vertices[n + 1]);
    const double away = pixelsBetween((a + b) / 2, pixel);
    if (away > nearest || pixelsBetween(a, b) < kMiddleFrom) continue;
    nearest = away;
    hit = {Hit::Kind::Middle, n};
  }
  return hit;
}

std::optional<std::size_t> RouteTool::legAt(const floor::Route& route, QPointF pixel, const View& view) const {
  std::optional<std::size_t> leg;
  double nearest = kLegReach;
  for (std::size_t n = 0; n + 1 < route.vertices.size(); ++n) {
    const double away = pixelsFromRoute(view, {route.vertices[n], route.vertices[n + 1]}, pixel);
    if (away > nearest) continue;
    nearest = away;
    leg = n;
  }
  return leg;
}

QString RouteTool::otherRouteAt(QPointF pixel, const CanvasScene& scene) const {
  QString nearest;
  double least = kLegReach;
  for (const floor::Route& r : scene.map.site().routes) {
    const double away = pixelsFromRoute(scene.view, r.vertices, pixel);
    if (away > least) continue;
    least = away;
    nearest = QString::fromStdString(r.name);
  }
  return nearest;
}

Snap RouteTool::snapAt(const ToolMouse& mouse, const CanvasScene& scene) const {
  SnapWish wish;
  wish.off = mouse.modifiers.testFlag(Qt::AltModifier);
  const bool straight = mouse.modifiers.testFlag(Qt::ShiftModifier);
  if (drawing_) {
    wish.vertices = draft_;
    if (straight && !draft_.empty()) wish.from = draft_.back();
  } else if (drag_ && straight) {
    // From the vertex before; the first one from the one after.
    wish.from = drag_->route.vertices[drag_->index > 0 ? drag_->index - 1 : 1];
  }
  return snapped(scene, mouse.pixel, wish);
}

bool RouteTool::mousePressed(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  if (mouse.button == Qt::RightButton) {
    if (!drag_) openMenu(mouse, scene);
    return true;
  }
  if (mouse.button != Qt::LeftButton) return false;
  if (drawing_) {
    addVertex(snapAt(mouse, scene).place);
    return true;
  }
  const Hit hit = hitAt(mouse.pixel, scene);
  if (hit.kind != Hit::Kind::None) {
    beginDrag(hit, mouse.pixel);
    return true;
  }
  setVertex(std::nullopt);
  const QString other = otherRouteAt(mouse.pixel, scene);
  if (other.isEmpty() || other == selection_.route()) return false;
  selection_.setRoute(other);
  return true;
}

bool RouteTool::mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  if (drag_) {
    if (!drag_->moved && pixelsBetween(mouse.pixel, drag_->pressed) < QApplication::startDragDistance() / 2.0)
      return true;
    drag_->moved = true;
    pointer_ = snapAt(mouse, scene);
    drag_->route.vertices[drag_->index] = pointer_->place;
    Q_EMIT changed();
    return true;
  }
  if (drawing_) {
    pointer_ = snapAt(mouse, scene);
    Q_EMIT changed();
    return true;
  }
  if (const Hit hit = hitAt(mouse.pixel, scene); hit != hover_) {
    hover_ = hit;
    Q_EMIT changed();
  }
  return hover_.kind != Hit::Kind::None;
}

bool RouteTool::mouseReleased(const ToolMouse& mouse, const CanvasScene& /*scene*/) {
  mouse_ = mouse;
  if (mouse.button == Qt::LeftButton && drag_) endDrag();
  return true;
}

bool RouteTool::mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.button != Qt::LeftButton) return false;
  if (!drawing_) return hitAt(mouse.pixel, scene).kind != Hit::Kind::None;
  // The first of the two clicks has set the vertex here; a hand that trembled in between shall not set another.
  const bool here = !draft_.empty() && pixelsBetween(scene.view.toPixel(draft_.back()), mouse.pixel) <= kVertexReach;
  if (!here) addVertex(snapAt(mouse, scene).place);
  finish();
  return true;
}

void RouteTool::mouseLeft() {
  if (drag_) return;
  pointer_.reset();
  hover_ = {};
  Q_EMIT changed();
}

void RouteTool::addVertex(Point place) {
  if (draft_.size() >= RouteEdits::kMostVertices) return;
  if (!draft_.empty() && draft_.back() == place) return;
  draft_.push_back(place);
  takenBack_.clear();
  touch();
}

void RouteTool::finish() {
  if (draft_.size() < 2) {
    Q_EMIT refused(tr("A route needs at least two vertices."));
    return;
  }
  editing_ = true;
  const auto name = edits_.add(draft_);
  editing_ = false;
  if (!name) return tell(tl::unexpected{name.error()});
  drawing_ = false;
  pointer_.reset();
  forgetUnfinished();
  selection_.setRoute(*name);
  Q_EMIT finished(*name);
}

void RouteTool::beginDrag(Hit hit, QPointF pixel) {
  drag_ = Drag{*route(), hit.index, false, false, pixel};
  if (hit.kind == Hit::Kind::Middle) {
    const Point a = drag_->route.vertices[hit.index];
    const Point b = drag_->route.vertices[hit.index + 1];
    drag_->index = hit.index + 1;
    drag_->inserted = true;
    floor::insertVertex(drag_->route, drag_->index, tidy(a + 0.5 * (b - a)));
  } else {
    setVertex(hit.index);
  }
  pointer_.reset();
  touch();
}

void RouteTool::endDrag() {
  const Drag drag = *std::exchange(drag_, std::nullopt);
  pointer_.reset();
  const Point place = drag.route.vertices[drag.index];
  const QString name = selection_.route();
  editing_ = true;
  Result<void> result;
  if (drag.inserted) {
    result = edits_.insertVertex(name, drag.index, place);
  } else if (drag.moved) {
    result = edits_.moveVertex(name, drag.index, place);
  }
  editing_ = false;
  tell(result);
  hover_ = {};
  if (result) setVertex(drag.index);
  touch();
}

void RouteTool::removeVertex(std::size_t index) {
  ++nudges_;
  tell(edits_.removeVertex(selection_.route(), index));
}

void RouteTool::nudge(Offset by) {
  const floor::Route* r = route();
  if (r == nullptr || !vertex_ || *vertex_ >= r->vertices.size()) return;
  tell(edits_.moveVertex(selection_.route(), *vertex_, tidy(r->vertices[*vertex_] + by), nudges_));
}

}  // namespace tessera::ui
