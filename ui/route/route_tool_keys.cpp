// Keys and menus of the route tool, and what can be taken back.
#include <QMenu>

#include "ui/route/route_tool.h"

namespace tessera::ui {
namespace {

constexpr Metres kNudge{0.01};
constexpr Metres kLongNudge{0.10};

std::optional<Offset> arrowOf(const QKeyEvent& event) {
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

bool isDelete(const QKeyEvent& event) { return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace; }

}  // namespace

bool RouteTool::wantsShortcut(const QKeyEvent& event) const {
  if (event.key() == Qt::Key_Escape) return true;
  const bool steps = event.matches(QKeySequence::Undo) || event.matches(QKeySequence::Redo);
  if (drag_) return steps;
  if (drawing_) {
    const bool ends = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    return isDelete(event) || ends || (steps && !(draft_.empty() && takenBack_.empty()));
  }
  return vertex_ && (isDelete(event) || arrowOf(event));
}

bool RouteTool::keyPressed(QKeyEvent& event, const CanvasScene& scene) {
  modifiersChanged(event.modifiers(), scene);
  if (event.matches(QKeySequence::Undo)) return undo();
  if (event.matches(QKeySequence::Redo)) return redo();
  return drawing_ ? drawingKey(event) : editingKey(event);
}

bool RouteTool::keyReleased(QKeyEvent& event, const CanvasScene& scene) {
  modifiersChanged(event.modifiers(), scene);
  return false;
}

// Shift and Alt take effect at once, not only when the mouse moves on.
void RouteTool::modifiersChanged(Qt::KeyboardModifiers modifiers, const CanvasScene& scene) {
  if (modifiers == mouse_.modifiers || !pointer_) return;
  mouse_.modifiers = modifiers;
  mouseMoved(ToolMouse{mouse_}, scene);
}

bool RouteTool::drawingKey(QKeyEvent& event) {
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    finish();
    return true;
  }
  if (!isDelete(event)) return false;
  undo();
  return true;
}

bool RouteTool::editingKey(QKeyEvent& event) {
  if (!vertex_ || drag_) return false;
  if (isDelete(event)) {
    removeVertex(*vertex_);
    return true;
  }
  const auto arrow = arrowOf(event);
  if (arrow) nudge(*arrow);
  return arrow.has_value();
}

bool RouteTool::cancel() {
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
  if (!vertex_) return false;
  setVertex(std::nullopt);
  return true;
}

bool RouteTool::undo() {
  if (drag_) return cancel();
  if (!drawing_ || draft_.empty()) return false;
  takenBack_.push_back(draft_.back());
  draft_.pop_back();
  touch();
  return true;
}

bool RouteTool::redo() {
  if (!drawing_ || takenBack_.empty()) return drawing_ && !draft_.empty();
  draft_.push_back(takenBack_.back());
  takenBack_.pop_back();
  touch();
  return true;
}

QCursor RouteTool::cursor() const {
  if (drawing_) return Qt::CrossCursor;
  if (drag_) return Qt::SizeAllCursor;
  return hover_.kind == Hit::Kind::None ? Qt::ArrowCursor : Qt::PointingHandCursor;
}

QString RouteTool::hint() const {
  if (drag_) return tr("Shift: in steps of 45°. Alt: no snapping. Esc: leave it where it was.");
  if (drawing_ && draft_.empty()) return tr("Click where the route is to begin. Esc: stop drawing.");
  if (drawing_)
    return tr(
        "Click the next vertex. Double-click or Enter: finish. Backspace: one back. Shift: in steps of 45°. Alt: "
        "no snapping.");
  if (vertex_) return tr("Arrow keys move the vertex by 1 cm, with Shift by 10 cm. Del removes it.");
  if (route() != nullptr) return tr("Drag a vertex to move it, a small circle between two to insert one.");
  return tr("Click a route to change it, or draw a new one.");
}

void RouteTool::openMenu(const ToolMouse& mouse, const CanvasScene& scene) {
  auto* menu = new QMenu{window_};
  menu->setObjectName("routeMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (drawing_) {
    fillDrawingMenu(*menu);
  } else {
    fillRouteMenu(*menu, mouse, scene);
  }
  menu->popup(mouse.global);
}

void RouteTool::fillDrawingMenu(QMenu& menu) {
  menu.addAction(tr("&Finish route"), this, &RouteTool::finish)->setEnabled(draft_.size() >= 2);
  menu.addAction(tr("&Remove last vertex"), this, [this] { undo(); })->setEnabled(!draft_.empty());
  menu.addSeparator();
  menu.addAction(tr("&Drop route"), this, [this] { cancel(); })->setEnabled(!draft_.empty());
}

void RouteTool::fillRouteMenu(QMenu& menu, const ToolMouse& mouse, const CanvasScene& scene) {
  if (const QString other = otherRouteAt(mouse.pixel, scene); !other.isEmpty() && route() == nullptr)
    selection_.setRoute(other);
  const Hit hit = hitAt(mouse.pixel, scene);
  const floor::Route* chosen = route();
  const auto leg = chosen ? legAt(*chosen, mouse.pixel, scene.view) : std::nullopt;
  const QString name = selection_.route();
  if (hit.kind == Hit::Kind::Vertex) {
    setVertex(hit.index);
    menu.addAction(tr("&Delete vertex"), this, [this, n = hit.index] { removeVertex(n); })
        ->setEnabled(chosen->vertices.size() > 2);
    menu.addAction(tr("&Split route here"), this,
                   [this, name, n = hit.index] {
                     const auto rest = edits_.split(name, n);
                     if (!rest) tell(tl::unexpected{rest.error()});
                   })
        ->setEnabled(hit.index > 0 && hit.index + 1 < chosen->vertices.size());
  } else if (leg) {
    menu.addAction(tr("&Insert vertex here"), this, [this, name, n = *leg + 1, place = snapAt(mouse, scene).place] {
      const auto done = edits_.insertVertex(name, n, place);
      tell(done);
      if (done) setVertex(n);
    });
  }
  if (hit.kind != Hit::Kind::None || leg) {
    menu.addAction(tr("&Reverse route"), this, [this, name] { tell(edits_.reverse(name)); });
    for (const QString& other : edits_.touching(name))
      menu.addAction(tr("&Join with “%1”").arg(QString{other}.replace(QLatin1Char('&'), QLatin1String("&&"))), this,
                     [this, name, other] { tell(edits_.join(name, other)); });
    menu.addAction(tr("D&uplicate route"), this, [this, name] {
      if (const auto copy = edits_.duplicate(name)) selection_.setRoute(*copy);
    });
    menu.addAction(tr("De&lete route"), this, [this, name] { tell(edits_.remove(name)); });
    menu.addSeparator();
  }
  menu.addAction(tr("Draw &new route from here"), this, [this, place = snapAt(mouse, scene).place] {
    startDrawing();
    addVertex(place);
  });
}

}  // namespace tessera::ui
