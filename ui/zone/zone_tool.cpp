#include "ui/zone/zone_tool.h"

#include <QApplication>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "ui/base/tidy.h"
#include "ui/zone/zone_shape.h"

namespace tessera::ui {
namespace {

constexpr double kCornerReach = 10.0;
constexpr int kFirstZoneNudgeKey = 31'000'000;  // apart from those of other tools

}  // namespace

ZoneTool::ZoneTool(SiteDocument& document, Selection& selection, QWidget* window)
    : DraftTool{document, selection, window, kFirstZoneNudgeKey, ZoneEdits::kMostCorners}, edits_{document} {
  connect(&document_, &SiteDocument::changed, this, &ZoneTool::documentChanged);
  connect(&selection_, &Selection::zoneChanged, this, [this] {
    if (drag_ && drag_->kind != Drag::Kind::Rectangle) drag_.reset();
    ++nudges_;
    setCorner(std::nullopt);
    touch();
  });
}

void ZoneTool::documentChanged() {
  if (editing_) return;
  if (drag_ && drag_->kind != Drag::Kind::Rectangle) drag_.reset();  // of a zone that is another now
  hover_ = {};
  if (const floor::Zone* z = zone(); corner_ && (z == nullptr || *corner_ >= z->outline.size()))
    setCorner(std::nullopt);
  touch();
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
  if (const auto corner = pointAt(scene.view, z->outline, pixel)) return {Hit::Kind::Corner, *corner};
  if (const auto edge = middleAt(scene.view, z->outline, true, pixel)) return {Hit::Kind::Middle, *edge};
  // Where a smaller zone lies on top, that one is meant.
  const auto under = zonesAt(scene.map.site().zones, scene.view, pixel);
  const bool inside = !under.empty() && scene.map.site().zones[under.front()].name == z->name;
  return inside ? Hit{Hit::Kind::Inside, 0} : Hit{};
}

bool ZoneTool::dropChoice() {
  const bool any = corner_.has_value();
  setCorner(std::nullopt);
  return any;
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
  } else if (!drag_ && isDrawing()) {
    wish.vertices = draft();
    if (straight && !draft().empty()) wish.from = draft().back();
  }
  return snapped(scene, pixel, wish);
}

bool ZoneTool::closes(QPointF pixel, const CanvasScene& scene) const {
  return draft().size() >= 3 && pixelsBetween(scene.view.toPixel(draft().front()), pixel) <= kCornerReach;
}

bool ZoneTool::pressWhileDrawing(const ToolMouse& mouse, const CanvasScene& scene) {
  const Point place = snapAt(mouse, scene).place;
  if (closes(mouse.pixel, scene)) {
    finishDraft();
  } else if (draft().empty()) {
    // A click sets the first corner, a drag makes a rectangle: that shows at the release.
    drag_ = Drag{Drag::Kind::Rectangle, {}, {}, 0, place, mouse.pixel, false};
  } else {
    addPoint(place);
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
  if (isDrawing()) return pressWhileDrawing(mouse, scene);
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

bool ZoneTool::mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  if (mouse.button == Qt::LeftButton && drag_) endDrag(scene);
  return true;
}

bool ZoneTool::mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.button != Qt::LeftButton) return false;
  if (!isDrawing()) return hitAt(mouse.pixel, scene).kind != Hit::Kind::None;
  // The first of the two clicks has set the corner here; a hand that trembled in between shall not set another.
  if (!isAtLast(mouse.pixel, scene.view)) addPoint(snapAt(mouse, scene).place);
  finishDraft();
  return true;
}

void ZoneTool::finishDraft() { finish(draft()); }

void ZoneTool::finish(const std::vector<Point>& outline) {
  editing_ = true;
  const auto name = edits_.add(kind_, outline);
  editing_ = false;
  if (!tell(name)) return;
  endDrawing();
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
  if (drag.kind == Drag::Kind::Rectangle) return drag.moved ? finish(drag.outline) : addPoint(drag.begin);
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
