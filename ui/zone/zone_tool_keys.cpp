// Keys of the zone tool, and what can be taken back.
#include "ui/base/tidy.h"
#include "ui/zone/zone_tool.h"

namespace tessera::ui {
namespace {

constexpr Metres kZoneNudge{0.01};
constexpr Metres kLongZoneNudge{0.10};

std::optional<Offset> arrowOf(const QKeyEvent& event) {
  const Metres step = event.modifiers().testFlag(Qt::ShiftModifier) ? kLongZoneNudge : kZoneNudge;
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

bool isDelete(const QKeyEvent& event) { return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace; }
bool isEnter(const QKeyEvent& event) { return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter; }

}  // namespace

bool ZoneTool::wantsShortcut(const QKeyEvent& event) const {
  if (event.key() == Qt::Key_Escape) return true;
  const bool steps = event.matches(QKeySequence::Undo) || event.matches(QKeySequence::Redo);
  if (drag_) return steps;
  if (drawing_) return isDelete(event) || isEnter(event) || (steps && !(draft_.empty() && takenBack_.empty()));
  return zone() != nullptr && (isDelete(event) || arrowOf(event));
}

bool ZoneTool::keyPressed(QKeyEvent& event, const CanvasScene& scene) {
  modifiersChanged(event.modifiers(), scene);
  if (event.matches(QKeySequence::Undo)) return undo();
  if (event.matches(QKeySequence::Redo)) return redo();
  return drawing_ ? drawingKey(event) : editingKey(event);
}

bool ZoneTool::keyReleased(QKeyEvent& event, const CanvasScene& scene) {
  modifiersChanged(event.modifiers(), scene);
  return false;
}

// Shift and Alt take effect at once, not only when the mouse moves on.
void ZoneTool::modifiersChanged(Qt::KeyboardModifiers modifiers, const CanvasScene& scene) {
  if (modifiers == mouse_.modifiers || !pointer_) return;
  mouse_.modifiers = modifiers;
  mouseMoved(ToolMouse{mouse_}, scene);
}

bool ZoneTool::drawingKey(const QKeyEvent& event) {
  if (drag_) return false;
  if (isEnter(event)) {
    finish(draft_);
    return true;
  }
  if (!isDelete(event)) return false;
  undo();
  return true;
}

bool ZoneTool::editingKey(const QKeyEvent& event) {
  if (drag_ || zone() == nullptr) return false;
  if (isDelete(event)) {
    if (corner_) {
      removeCorner(*corner_);
    } else {
      tell(edits_.remove(selection_.zone()));
    }
    return true;
  }
  const auto arrow = arrowOf(event);
  if (arrow) nudge(*arrow);
  return arrow.has_value();
}

void ZoneTool::removeCorner(std::size_t index) {
  ++nudges_;
  tell(edits_.removeCorner(selection_.zone(), index));
}

void ZoneTool::nudge(Offset by) {
  const floor::Zone* z = zone();
  if (z == nullptr) return;
  if (!corner_) {
    tell(edits_.move(selection_.zone(), by, nudges_));
  } else if (*corner_ < z->outline.size()) {
    tell(edits_.moveCorner(selection_.zone(), *corner_, tidy(z->outline[*corner_] + by), nudges_));
  }
}

bool ZoneTool::cancel() {
  if (drag_) {
    drag_.reset();
    pointer_.reset();
    touch();
    return true;
  }
  if (drawing_ && !draft_.empty()) {
    draft_.clear();
    takenBack_.clear();
    touch();
    return true;
  }
  if (drawing_) {
    drawing_ = false;
    pointer_.reset();
    takenBack_.clear();
    touch();
    return false;
  }
  if (!corner_) return false;
  setCorner(std::nullopt);
  return true;
}

bool ZoneTool::undo() {
  if (drag_) return cancel();
  if (!drawing_ || draft_.empty()) return false;
  takenBack_.push_back(draft_.back());
  draft_.pop_back();
  touch();
  return true;
}

bool ZoneTool::redo() {
  if (!drawing_ || takenBack_.empty()) return drawing_ && !draft_.empty();
  draft_.push_back(takenBack_.back());
  takenBack_.pop_back();
  touch();
  return true;
}

QCursor ZoneTool::cursor() const {
  if (drawing_) return Qt::CrossCursor;
  if (drag_) return Qt::SizeAllCursor;
  if (hover_.kind == Hit::Kind::Inside) return Qt::OpenHandCursor;
  return hover_.kind == Hit::Kind::None ? Qt::ArrowCursor : Qt::PointingHandCursor;
}

QString ZoneTool::hint() const {
  if (drag_ && drag_->kind == Drag::Kind::Rectangle)
    return tr("Release where the opposite corner is to be. Alt: no snapping. Esc: drop it.");
  if (drag_) return tr("Shift: in steps of 45°. Alt: no snapping. Esc: leave it where it was.");
  if (drawing_ && draft_.empty())
    return tr("Drag a rectangle, or click the zone's corners one by one. Esc: stop drawing.");
  if (drawing_)
    return tr(
        "Click the next corner. First corner, double-click or Enter: finish. Backspace: one back. Shift: 45°. Alt: no "
        "snapping.");
  if (corner_) return tr("Arrow keys move the corner by 1 cm, with Shift by 10 cm. Del removes it.");
  if (zone() != nullptr)
    return tr("Drag a corner, a circle on an edge, or the inside. Click again: the zone below. Del removes the zone.");
  return tr("Click a zone to change it, or draw a new one.");
}

}  // namespace tessera::ui
