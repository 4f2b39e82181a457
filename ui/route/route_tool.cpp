#include "ui/route/route_tool.h"

#include <QApplication>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "ui/canvas/route_painter.h"

namespace tessera::ui {
namespace {

constexpr double kLegReach = 7.0;
constexpr int kFirstNudgeKey = 1'000'000;

}  // namespace

RouteTool::RouteTool(SiteDocument& document, Selection& selection, QWidget* window)
    : DraftTool{document, selection, window, kFirstNudgeKey, RouteEdits::kMostVertices}, edits_{document} {
  connect(&document_, &SiteDocument::changed, this, &RouteTool::documentChanged);
  connect(&selection_, &Selection::routeChanged, this, [this] {
    drag_.reset();
    setVertex(std::nullopt);
    touch();
  });
}

void RouteTool::documentChanged() {
  if (editing_) return;
  drag_.reset();  // of a route that is another now
  hover_ = {};
  if (const floor::Route* r = route(); vertex_ && (r == nullptr || *vertex_ >= r->vertices.size()))
    setVertex(std::nullopt);
  touch();
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
  if (const auto vertex = pointAt(scene.view, r->vertices, pixel)) return {Hit::Kind::Vertex, *vertex};
  if (const auto leg = middleAt(scene.view, r->vertices, false, pixel)) return {Hit::Kind::Middle, *leg};
  return {};
}

bool RouteTool::dropChoice() {
  const bool any = vertex_.has_value();
  setVertex(std::nullopt);
  return any;
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
  if (isDrawing()) {
    wish.vertices = draft();
    if (straight && !draft().empty()) wish.from = draft().back();
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
  if (isDrawing()) {
    addPoint(snapAt(mouse, scene).place);
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
  if (isDrawing()) {
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
  if (!isDrawing()) return hitAt(mouse.pixel, scene).kind != Hit::Kind::None;
  // The first of the two clicks has set the vertex here; a hand that trembled in between shall not set another.
  if (!isAtLast(mouse.pixel, scene.view)) addPoint(snapAt(mouse, scene).place);
  finishDraft();
  return true;
}

void RouteTool::finishDraft() {
  if (draft().size() < 2) {
    Q_EMIT refused(tr("A route needs at least two vertices."));
    return;
  }
  editing_ = true;
  const auto name = edits_.add(draft());
  editing_ = false;
  if (!tell(name)) return;
  endDrawing();
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
