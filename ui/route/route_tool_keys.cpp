// Keys and menus of the route tool.
#include <QMenu>

#include "ui/route/route_tool.h"

namespace tessera::ui {

bool RouteTool::wantsToEdit(const QKeyEvent& event) const { return vertex_ && (isDeleteKey(event) || nudgeOf(event)); }

bool RouteTool::editingKey(const QKeyEvent& event) {
  if (!vertex_) return false;
  if (isDeleteKey(event)) {
    removeVertex(*vertex_);
    return true;
  }
  const auto by = nudgeOf(event);
  if (by) nudge(*by);
  return by.has_value();
}

QCursor RouteTool::cursor() const {
  if (isDrawing()) return Qt::CrossCursor;
  if (drag_) return Qt::SizeAllCursor;
  return hover_.kind == Hit::Kind::None ? Qt::ArrowCursor : Qt::PointingHandCursor;
}

QString RouteTool::hint() const {
  if (drag_) return tr("Shift: in steps of 45°. Alt: no snapping. Esc: leave it where it was.");
  if (isDrawing() && draft().empty()) return tr("Click where the route is to begin. Esc: stop drawing.");
  if (isDrawing())
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
  if (isDrawing()) {
    fillDrawingMenu(*menu);
  } else {
    fillRouteMenu(*menu, mouse, scene);
  }
  menu->popup(mouse.global);
}

void RouteTool::fillDrawingMenu(QMenu& menu) {
  menu.addAction(tr("&Finish route"), this, &RouteTool::finishDraft)->setEnabled(draft().size() >= 2);
  menu.addAction(tr("&Remove last vertex"), this, [this] { undo(); })->setEnabled(!draft().empty());
  menu.addSeparator();
  menu.addAction(tr("&Drop route"), this, [this] { cancel(); })->setEnabled(!draft().empty());
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
    menu.addAction(tr("&Split route here"), this, [this, name, n = hit.index] { tell(edits_.split(name, n)); })
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
    addPoint(place);
  });
}

}  // namespace tessera::ui
