#include "ui/canvas/draft_tool.h"

#include <QWidget>
#include <cmath>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

constexpr Metres kNudge{0.01};
constexpr Metres kLongNudge{0.10};
constexpr double kPointReach = 10.0;
constexpr double kMiddleReach = 8.0;

bool isEnterKey(const QKeyEvent& event) { return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter; }

}  // namespace

bool isDeleteKey(const QKeyEvent& event) { return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace; }

std::optional<Offset> nudgeOf(const QKeyEvent& event) {
  const Metres step = event.modifiers().testFlag(Qt::ShiftModifier) ? kLongNudge : kNudge;
  switch (event.key()) {
    case Qt::Key_Left:
      return Offset{-step, {}};
    case Qt::Key_Right:
      return Offset{step, {}};
    case Qt::Key_Up:
      return Offset{{}, step};
    case Qt::Key_Down:
      return Offset{{}, -step};
    default:
      return std::nullopt;
  }
}

double pixelsBetween(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

DraftTool::DraftTool(SiteDocument& document, Selection& selection, QWidget* window, int firstNudgeKey,
                     std::size_t mostPoints)
    : CanvasTool{window},
      document_{document},
      selection_{selection},
      window_{window},
      nudges_{firstNudgeKey},
      mostPoints_{mostPoints} {
  connect(&document_, &SiteDocument::replaced, this, [this] {
    drawing_ = false;
    forgetUnfinished();
  });
}

void DraftTool::touch() {
  Q_EMIT changed();
  Q_EMIT hintChanged(hint());
}

void DraftTool::refuse(const Error& why) { Q_EMIT refused(text(why.sentence)); }

void DraftTool::forgetUnfinished() {
  draft_.clear();
  takenBack_.clear();
  dropDrag();
  forgetHover();
  dropChoice();
  touch();
}

void DraftTool::startDrawing() {
  drawing_ = true;
  forgetUnfinished();
}

void DraftTool::endDrawing() {
  drawing_ = false;
  pointer_.reset();
  forgetUnfinished();
}

void DraftTool::addPoint(Point place) {
  if (draft_.size() >= mostPoints_) return;
  if (!draft_.empty() && draft_.back() == place) return;
  draft_.push_back(place);
  takenBack_.clear();
  touch();
}

bool DraftTool::isAtLast(QPointF pixel, const View& view) const {
  return !draft_.empty() && pixelsBetween(view.toPixel(draft_.back()), pixel) <= kPointReach;
}

std::optional<std::size_t> DraftTool::pointAt(const View& view, const std::vector<Point>& points, QPointF pixel) {
  std::optional<std::size_t> found;
  double nearest = kPointReach;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const double away = pixelsBetween(view.toPixel(points[n]), pixel);
    if (away > nearest) continue;
    nearest = away;
    found = n;
  }
  return found;
}

std::optional<std::size_t> DraftTool::middleAt(const View& view, const std::vector<Point>& points, bool closed,
                                               QPointF pixel) {
  std::optional<std::size_t> found;
  double nearest = kMiddleReach;
  for (std::size_t n = 0; n + (closed ? 0 : 1) < points.size(); ++n) {
    const QPointF a = view.toPixel(points[n]);
    const QPointF b = view.toPixel(points[(n + 1) % points.size()]);
    const double away = pixelsBetween((a + b) / 2, pixel);
    if (away > nearest || pixelsBetween(a, b) < kMiddleFrom) continue;
    nearest = away;
    found = n;
  }
  return found;
}

void DraftTool::mouseLeft() {
  if (isDragging()) return;
  pointer_.reset();
  forgetHover();
  Q_EMIT changed();
}

bool DraftTool::wantsShortcut(const QKeyEvent& event) const {
  if (event.key() == Qt::Key_Escape) return true;
  const bool steps = event.matches(QKeySequence::Undo) || event.matches(QKeySequence::Redo);
  if (isDragging()) return steps;
  if (!drawing_) return wantsToEdit(event);
  return isDeleteKey(event) || isEnterKey(event) || (steps && !(draft_.empty() && takenBack_.empty()));
}

bool DraftTool::keyPressed(QKeyEvent& event, const CanvasScene& scene) {
  modifiersChanged(event.modifiers(), scene);
  if (event.matches(QKeySequence::Undo)) return undo();
  if (event.matches(QKeySequence::Redo)) return redo();
  if (isDragging()) return false;
  return drawing_ ? drawingKey(event) : editingKey(event);
}

bool DraftTool::keyReleased(QKeyEvent& event, const CanvasScene& scene) {
  modifiersChanged(event.modifiers(), scene);
  return false;
}

// Shift and Alt take effect at once, not only when the mouse moves on.
void DraftTool::modifiersChanged(Qt::KeyboardModifiers modifiers, const CanvasScene& scene) {
  if (modifiers == mouse_.modifiers || !pointer_) return;
  mouse_.modifiers = modifiers;
  mouseMoved(ToolMouse{mouse_}, scene);
}

bool DraftTool::drawingKey(const QKeyEvent& event) {
  if (isEnterKey(event)) {
    finishDraft();
    return true;
  }
  if (!isDeleteKey(event)) return false;
  undo();
  return true;
}

bool DraftTool::cancel() {
  if (isDragging()) {
    dropDrag();
    pointer_.reset();
    touch();
    return true;
  }
  if (!drawing_) return dropChoice();
  const bool any = !draft_.empty();
  draft_.clear();
  takenBack_.clear();
  if (!any) {
    drawing_ = false;
    pointer_.reset();
  }
  touch();
  return any;
}

bool DraftTool::undo() {
  if (isDragging()) return cancel();
  if (!drawing_ || draft_.empty()) return false;
  takenBack_.push_back(draft_.back());
  draft_.pop_back();
  touch();
  return true;
}

bool DraftTool::redo() {
  if (!drawing_ || takenBack_.empty()) return drawing_ && !draft_.empty();
  draft_.push_back(takenBack_.back());
  takenBack_.pop_back();
  touch();
  return true;
}

}  // namespace tessera::ui
