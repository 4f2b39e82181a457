// The menus of the zone tool.
#include <QMenu>

#include "ui/zone/zone_shape.h"
#include "ui/zone/zone_tool.h"
#include "ui/zone/zone_words.h"

namespace tessera::ui {
namespace {

constexpr double kEdgeReach = 7.0;

}  // namespace

void ZoneTool::openMenu(const ToolMouse& mouse, const CanvasScene& scene) {
  auto* menu = new QMenu{window_};
  menu->setObjectName("zoneMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (isDrawing()) {
    fillDrawingMenu(*menu);
  } else {
    fillZoneMenu(*menu, mouse, scene);
  }
  menu->popup(mouse.global);
}

void ZoneTool::fillDrawingMenu(QMenu& menu) {
  menu.addAction(tr("&Finish zone"), this, [this] { finishDraft(); })->setEnabled(draft().size() >= 3);
  menu.addAction(tr("&Remove last corner"), this, [this] { undo(); })->setEnabled(!draft().empty());
  menu.addSeparator();
  menu.addAction(tr("&Drop zone"), this, [this] { cancel(); })->setEnabled(!draft().empty());
}

void ZoneTool::fillKindMenu(QMenu& menu) {
  QMenu* kinds = menu.addMenu(tr("&Kind"));
  for (const floor::ZoneKind kind : kZoneKinds) {
    QAction* action = kinds->addAction(zoneKindName(kind), this,
                                       [this, name = selection_.zone(), kind] { tell(edits_.setKind(name, kind)); });
    action->setCheckable(true);
    action->setChecked(zone()->kind == kind);
  }
}

void ZoneTool::fillZoneMenu(QMenu& menu, const ToolMouse& mouse, const CanvasScene& scene) {
  Hit hit = hitAt(mouse.pixel, scene);
  if (hit.kind == Hit::Kind::None) {
    const auto under = zonesAt(scene.map.site().zones, scene.view, mouse.pixel);
    if (!under.empty()) selection_.setZone(QString::fromStdString(scene.map.site().zones[under.front()].name));
    hit = hitAt(mouse.pixel, scene);
  }
  const floor::Zone* chosen = zone();
  const auto edge = chosen != nullptr ? edgeAt(chosen->outline, scene.view, mouse.pixel, kEdgeReach) : std::nullopt;
  const QString name = selection_.zone();
  const Point place = snapAt(mouse, scene).place;
  if (hit.kind == Hit::Kind::Corner) {
    setCorner(hit.index);
    menu.addAction(tr("&Delete corner"), this, [this, n = hit.index] { removeCorner(n); })
        ->setEnabled(chosen->outline.size() > 3);
  } else if (edge) {
    menu.addAction(tr("&Insert corner here"), this, [this, name, n = *edge + 1, place] {
      if (tell(edits_.insertCorner(name, n, place))) setCorner(n);
    });
  }
  if (hit.kind != Hit::Kind::None || edge) {
    fillKindMenu(menu);
    menu.addAction(tr("D&uplicate zone"), this, [this, name] {
      const auto copy = edits_.duplicate(name);
      if (tell(copy)) selection_.setZone(*copy);
    });
    menu.addAction(tr("De&lete zone"), this, [this, name] { tell(edits_.remove(name)); });
    menu.addSeparator();
  }
  menu.addAction(tr("Draw &new zone from here"), this, [this, place] {
    startDrawing();
    addPoint(place);
  });
}

}  // namespace tessera::ui
