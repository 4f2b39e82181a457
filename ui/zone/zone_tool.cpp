#include "ui/zone/zone_tool.h"

#include <QApplication>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/tidy.h"
#include "ui/base/wording.h"
#include "ui/zone/zone_shape.h"

namespace tessera::ui {
namespace {

constexpr double kCornerReach = 10.0;
constexpr double kMiddleReach = 8.0;
constexpr double kMiddleFrom = 44.0;            // pixels of an edge that has room for a handle in its middle
constexpr int kFirstZoneNudgeKey = 31'000'000;  // apart from those of other tools

double pixelsBetween(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

}  // namespace

ZoneTool::ZoneTool(SiteDocument& document, Selection& selection, QWidget* window)
    : CanvasTool{window},
      document_{document},
      selection_{selection},
      edits_{document},
      window_{window},
      nudges_{kFirstZoneNudgeKey} {
  connect(&document_, &SiteDocument::changed, this, &ZoneTool::documentChanged);
  connect(&document_, &SiteDocument::replaced, this, [this] {
    drawing_ = false;
    forgetUnfinished();
  });
  connect(&selection_, &Selection::zoneChanged, this, [this] {
    if (drag_ && drag_->kind != Drag::Kind::Rectangle) drag_.reset();
    ++nudges_;
    setCorner(std::nullopt);
    touch();
  });
}

void ZoneTool::touch() {
  Q_EMIT changed();
  Q_EMIT hintChanged(hint());
}

void ZoneTool::refuse(const Error& why) { Q_EMIT refused(text(why.sentence)); }

void ZoneTool::forgetUnfinished() {
  draft_.clear();
  takenBack_.clear();
  drag_.reset();
  hover_ = {};
  setCorner(std::nullopt);
  touch();
}

void ZoneTool::documentChanged() {
  if (editing_) return;
  if (drag_ && drag_->kind != Drag::Kind::Rectangle) drag_.reset();  // of a zone that is another now
  hover_ = {};
  if (const floor::Zone* z = zone(); corner_ && (z == nullptr || *corner_ >= z->outline.size()))
    setCorner(std::nullopt);
  touch();
}

void ZoneTool::startDrawing() {
  drawing_ = true;
  forgetUnfinished();
}

void ZoneTool::setCorner(std::optional<std::size_t> corner) {
  if (const floor::Zone* z = zone(); corner && (z == nullptr || *corner >= z->outline.size())) corner.reset();
  if (corner == corner_) return;
  corner_ = corner;
  ++nudges_;
  Q_EMIT cornerChanged(corner_);
  touch();
}

ZoneTool::Hit ZoneTool::hitAt(QPointF pixel, const CanvasScene& scene) const {
  const floor::Zone* z = zone();
  if (z == nullptr) return {};
  const std::size_t count = z->outline.size();
  Hit hit;
  double nearest = kCornerReach;
  for (std::size_t n = 0; n < count; ++n) {
    const double away = pixelsBetween(scene.view.toPixel(z->outline[n]), pixel);
    if (away > nearest) continue;
    nearest = away;
    hit = {Hit::Kind::Corner, n};
  }
  if (hit.kind != Hit::Kind::None) return hit;
  nearest = kMiddleReach;
  for (std::size_t n = 0; n < count; ++n) {
    const QPointF a = scene.view.toPixel(z->outline[n]);
    const QPointF b = scene.view.toPixel(z->outline[(n + 1) % count]);
    const double away = pixelsBetween((a + b) / 2, pixel);
    if (away > nearest || pixelsBetween(a, b) < kMiddleFrom) continue;
    nearest = away;
    hit = {Hit::Kind::Middle, n};
  }
  if (hit.kind != Hit::Kind::None) return hit;
  // Where a smaller zone lies on top, that one is meant.
  const auto under = zonesAt(scene.map.site().zones, scene.view, pixel);
  const bool inside = !under.empty() && scene.map.site().zones[under.front()].name == z->name;
  return inside ? Hit{Hit::Kind::Inside, 0} : Hit{};
}

Snap ZoneTool::snapAt(const ToolMouse& mouse, const CanvasScene& scene) const {
  SnapWish wish;
  wish.off = mouse.modifiers.testFlag(Qt::AltModifier);
  const bool straight = mouse.modifiers.testFlag(Qt::ShiftModifier);
  QPointF pixel = mouse.pixel;
  if (drag_ && drag_->kind == Drag::Kind::Whole) {
    const Point corner = drag_->before[drag_->index];
    pixel = scene.view.toPixel(corner + (mouse.place - drag_->begin));
    if (straight) wish.from = corner;
  } else if (drag_ && drag_->kind != Drag::Kind::Rectangle) {
    const std::size_t count = drag_->outline.size();
    if (straight) wish.from = drag_->outline[(drag_->index + count - 1) % count];
  } else if (!drag_ && drawing_) {
    wish.vertices = draft_;
    if (straight && !draft_.empty()) wish.from = draft_.back();
  }
  return snapped(scene, pixel, wish);
}

bool ZoneTool::closes(QPointF pixel, const CanvasScene& scene) const {
  return draft_.size() >= 3 && pixelsBetween(scene.view.toPixel(draft_.front()), pixel) <= kCornerReach;
}

bool ZoneTool::pressWhileDrawing(const ToolMouse& mouse, const CanvasScene& scene) {
  const Point place = snapAt(mouse, scene).place;
  if (closes(mouse.pixel, scene)) {
    finish(draft_);
  } else if (draft_.empty()) {
    // A click sets the first corner, a drag makes a rectangle: that shows at the release.
    drag_ = Drag{Drag::Kind::Rectangle, {}, {}, 0, place, mouse.pixel, false};
  } else {
    addCorner(place);
  }
  return true;
}

bool ZoneTool::mousePressed(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  if (mouse.button == Qt::RightButton) {
    if (!drag_) openMenu(mouse, scene);
    return true;
  }
  if (mouse.button != Qt::LeftButton) return false;
  if (drawing_) return pressWhileDrawing(mouse, scene);
  const Hit hit = hitAt(mouse.pixel, scene);
  if (hit.kind != Hit::Kind::None) {
    beginDrag(hit, mouse);
    return true;
  }
  setCorner(std::nullopt);
  const auto under = zonesAt(scene.map.site().zones, scene.view, mouse.pixel);
  if (!under.empty()) selection_.setZone(QString::fromStdString(scene.map.site().zones[under.front()].name));
  return false;  // a drag from here pans
}

bool ZoneTool::mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  if (drag_) {
    lead(mouse, scene);
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

bool ZoneTool::mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  if (mouse.button == Qt::LeftButton && drag_) endDrag(scene);
  return true;
}

bool ZoneTool::mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.button != Qt::LeftButton) return false;
  if (!drawing_) return hitAt(mouse.pixel, scene).kind != Hit::Kind::None;
  // The first of the two clicks has set the corner here; a hand that trembled in between shall not set another.
  const bool here = !draft_.empty() && pixelsBetween(scene.view.toPixel(draft_.back()), mouse.pixel) <= kCornerReach;
  if (!here) addCorner(snapAt(mouse, scene).place);
  finish(draft_);
  return true;
}

void ZoneTool::mouseLeft() {
  if (drag_) return;
  pointer_.reset();
  hover_ = {};
  Q_EMIT changed();
}

void ZoneTool::addCorner(Point place) {
  if (draft_.size() >= ZoneEdits::kMostCorners) return;
  if (!draft_.empty() && draft_.back() == place) return;
  draft_.push_back(place);
  takenBack_.clear();
  touch();
}

void ZoneTool::finish(const std::vector<Point>& outline) {
  editing_ = true;
  const auto name = edits_.add(kind_, outline);
  editing_ = false;
  if (!tell(name)) return;
  drawing_ = false;
  pointer_.reset();
  forgetUnfinished();
  selection_.setZone(*name);
  Q_EMIT finished(*name);
}

void ZoneTool::beginDrag(Hit hit, const ToolMouse& mouse) {
  const std::vector<Point> outline = zone()->outline;
  drag_ = Drag{Drag::Kind::Corner, outline, outline, hit.index, mouse.place, mouse.pixel, false};
  if (hit.kind == Hit::Kind::Middle) {
    const Point a = outline[hit.index];
    const Point b = outline[(hit.index + 1) % outline.size()];
    drag_->kind = Drag::Kind::NewCorner;
    drag_->index = hit.index + 1;
    drag_->outline.insert(drag_->outline.begin() + static_cast<std::ptrdiff_t>(drag_->index), tidy(a + 0.5 * (b - a)));
  } else if (hit.kind == Hit::Kind::Inside) {
    drag_->kind = Drag::Kind::Whole;
    const auto nearest = std::min_element(outline.begin(), outline.end(), [&](Point a, Point b) {
      return distance(a, mouse.place) < distance(b, mouse.place);
    });
    drag_->index = static_cast<std::size_t>(nearest - outline.begin());
    setCorner(std::nullopt);
  } else {
    setCorner(hit.index);
  }
  pointer_.reset();
  touch();
}

void ZoneTool::lead(const ToolMouse& mouse, const CanvasScene& scene) {
  if (!drag_->moved && pixelsBetween(mouse.pixel, drag_->pressed) < QApplication::startDragDistance() / 2.0) return;
  drag_->moved = true;
  pointer_ = snapAt(mouse, scene);
  switch (drag_->kind) {
    case Drag::Kind::Rectangle:
      drag_->outline = rectangle(drag_->begin, pointer_->place);
      break;
    case Drag::Kind::Whole:
      drag_->outline = moved(drag_->before, pointer_->place - drag_->before[drag_->index]);
      break;
    default:
      drag_->outline[drag_->index] = pointer_->place;
  }
  Q_EMIT changed();
}

void ZoneTool::endDrag(const CanvasScene& scene) {
  const Drag drag = *std::exchange(drag_, std::nullopt);
  const auto to = std::exchange(pointer_, std::nullopt);
  if (drag.kind == Drag::Kind::Rectangle) return drag.moved ? finish(drag.outline) : addCorner(drag.begin);
  if (drag.kind == Drag::Kind::Whole && !drag.moved) return clickedInside(drag.pressed, scene);
  const QString name = selection_.zone();
  ++nudges_;
  editing_ = true;
  Result<void> result;
  if (drag.kind == Drag::Kind::NewCorner) {
    result = edits_.insertCorner(name, drag.index, drag.outline[drag.index]);
  } else if (drag.kind == Drag::Kind::Whole) {
    result = edits_.move(name, to->place - drag.before[drag.index]);
  } else if (drag.moved) {
    result = edits_.moveCorner(name, drag.index, drag.outline[drag.index]);
  }
  editing_ = false;
  hover_ = {};
  if (tell(result) && drag.kind != Drag::Kind::Whole) setCorner(drag.index);
  touch();
}

// Again on the chosen zone: the one below is meant.
void ZoneTool::clickedInside(QPointF pixel, const CanvasScene& scene) {
  const auto under = zonesAt(scene.map.site().zones, scene.view, pixel);
  if (under.size() > 1) selection_.setZone(QString::fromStdString(scene.map.site().zones[under[1]].name));
  touch();
}

}  // namespace tessera::ui
