// Keys of the zone tool.
#include "ui/base/tidy.h"
#include "ui/zone/zone_tool.h"

namespace tessera::ui {

bool ZoneTool::wantsToEdit(const QKeyEvent& event) const {
  return zone() != nullptr && (isDeleteKey(event) || nudgeOf(event));
}

bool ZoneTool::editingKey(const QKeyEvent& event) {
  if (zone() == nullptr) return false;
  if (isDeleteKey(event)) {
    if (corner_) {
      removeCorner(*corner_);
    } else {
      tell(edits_.remove(selection_.zone()));
    }
    return true;
  }
  const auto by = nudgeOf(event);
  if (by) nudge(*by);
  return by.has_value();
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

QCursor ZoneTool::cursor() const {
  if (isDrawing()) return Qt::CrossCursor;
  if (drag_) return Qt::SizeAllCursor;
  if (hover_.kind == Hit::Kind::Inside) return Qt::OpenHandCursor;
  return hover_.kind == Hit::Kind::None ? Qt::ArrowCursor : Qt::PointingHandCursor;
}

QString ZoneTool::hint() const {
  if (drag_ && drag_->kind == Drag::Kind::Rectangle)
    return tr("Release where the opposite corner is to be. Alt: no snapping. Esc: drop it.");
  if (drag_) return tr("Shift: in steps of 45°. Alt: no snapping. Esc: leave it where it was.");
  if (isDrawing() && draft().empty())
    return tr("Drag a rectangle, or click the zone's corners one by one. Esc: stop drawing.");
  if (isDrawing())
    return tr(
        "Click the next corner. First corner, double-click or Enter: finish. Backspace: one back. Shift: 45°. Alt: no "
        "snapping.");
  if (corner_) return tr("Arrow keys move the corner by 1 cm, with Shift by 10 cm. Del removes it.");
  if (zone() != nullptr)
    return tr("Drag a corner, a circle on an edge, or the inside. Click again: the zone below. Del removes the zone.");
  return tr("Click a zone to change it, or draw a new one.");
}

}  // namespace tessera::ui
