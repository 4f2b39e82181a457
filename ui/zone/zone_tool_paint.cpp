// What the zone tool shows: the unfinished zone with its rubber band, the handles of the chosen one, the numbers.
#include <QFontMetricsF>
#include <QLocale>

#include "ui/canvas/clip.h"
#include "ui/canvas/readout.h"
#include "ui/zone/zone_shape.h"
#include "ui/zone/zone_tool.h"

namespace tessera::ui {
namespace {

constexpr double kZoneHandle = 5.5;

}  // namespace

void ZoneTool::paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  const bool changing = drag_ && drag_->kind != Drag::Kind::Rectangle;
  if (const floor::Zone* chosen = zone(); chosen != nullptr && !isDrawing()) {
    const std::vector<Point>& outline = changing ? drag_->outline : chosen->outline;
    paintShape(painter, scene.view, theme, outline, chosen->kind);
    paintHandles(painter, scene, theme, outline);
  }
  if (isDrawing()) paintDraft(painter, scene, theme);
  if (!drag_ || !drag_->moved || !pointer_) return;
  paintSnap(painter, scene.view, theme, *pointer_);
  paintReadout(painter, scene.view, theme, scene.view.toPixel(pointer_->place), dragLines(scene));
}

void ZoneTool::paintShape(QPainter& painter, const View& view, const CanvasTheme& theme,
                          const std::vector<Point>& outline, floor::ZoneKind kind) const {
  QPolygonF shape;
  for (const Point& p : outline) shape << view.toPixel(p);
  shape = clipped(shape, QRectF{QPointF{}, view.size()}.adjusted(-20, -20, 20, 20));
  if (shape.isEmpty()) return;
  QColor fill = theme.zone(kind);
  fill.setAlpha(theme.dark ? 60 : 48);
  painter.setBrush(fill);
  painter.setPen(QPen{theme.halo, 5.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin});
  painter.drawPolygon(shape);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen{theme.accent, 2.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin});
  painter.drawPolygon(shape);
}

void ZoneTool::paintHandles(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme,
                            const std::vector<Point>& outline) const {
  const View& view = scene.view;
  const SiteBox seen = view.visible(20.0);
  for (std::size_t n = 0; !drag_ && n < outline.size(); ++n) {
    const Point next = outline[(n + 1) % outline.size()];
    const Point middle = outline[n] + 0.5 * (next - outline[n]);
    if (view.pixels(distance(outline[n], next)) < kMiddleFrom || !seen.contains(middle)) continue;
    const bool hot = hover_ == Hit{Hit::Kind::Middle, n};
    paintHandle(painter, view.toPixel(middle), hot ? kZoneHandle + 1 : kZoneHandle - 1, hot ? theme.accent : theme.halo,
                hot ? theme.halo : theme.accent);
  }
  const auto current = drag_ && drag_->kind != Drag::Kind::Whole ? std::optional{drag_->index} : corner_;
  for (std::size_t n = 0; n < outline.size(); ++n) {
    if (!seen.contains(outline[n])) continue;
    const bool hot = current == n || hover_ == Hit{Hit::Kind::Corner, n};
    paintHandle(painter, view.toPixel(outline[n]), hot ? kZoneHandle + 2.5 : kZoneHandle, theme.accent, theme.halo);
    if (current != n) continue;
    painter.setPen(QPen{theme.accent, 2.0});
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(view.toPixel(outline[n]), kZoneHandle + 6, kZoneHandle + 6);
  }
}

void ZoneTool::paintDraft(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) const {
  const View& view = scene.view;
  if (drag_) {
    if (drag_->moved) paintShape(painter, view, theme, drag_->outline, kind_);
    return;
  }
  std::vector<Point> outline = draft();
  if (pointer_ && !draft().empty()) outline.push_back(pointer_->place);
  if (outline.size() >= 3) {
    paintShape(painter, view, theme, outline, kind_);
  } else if (outline.size() == 2) {
    const QRectF around = QRectF{QPointF{}, view.size()}.adjusted(-20, -20, 20, 20);
    painter.setPen(QPen{theme.accent, 2.0, Qt::DashLine, Qt::RoundCap});
    if (const auto line = clipped(QLineF{view.toPixel(outline[0]), view.toPixel(outline[1])}, around))
      painter.drawLine(*line);
  }
  for (const Point& p : draft()) paintHandle(painter, view.toPixel(p), kZoneHandle, theme.accent, theme.halo);
  if (!pointer_) return;
  QStringList lines;
  if (closes(view.toPixel(pointer_->place), scene)) {
    lines << tr("Click: finish the zone");
  } else if (!draft().empty() && draft().back() != pointer_->place) {
    lines << legText(draft().back(), pointer_->place, scene.map.site().northToY);
  }
  lines << placeText(pointer_->place);
  if (outline.size() >= 3) lines << areaText(squareMetres(outline));
  if (const QString kind = snapText(pointer_->kind); !kind.isEmpty()) lines << kind;
  paintSnap(painter, view, theme, *pointer_);
  paintReadout(painter, view, theme, view.toPixel(pointer_->place), lines);
}

QStringList ZoneTool::dragLines(const CanvasScene& scene) const {
  const QLocale locale;
  const Radians north = scene.map.site().northToY;
  QStringList lines;
  if (drag_->kind == Drag::Kind::Rectangle) {
    const auto metres = [&](Metres m) { return locale.toString(abs(m).value(), 'f', 2); };
    const Offset size = pointer_->place - drag_->begin;
    lines << tr("%1 × %2 m", "width and height").arg(metres(size.x), metres(size.y));
    lines << areaText(squareMetres(drag_->outline)) << placeText(pointer_->place);
  } else if (drag_->kind == Drag::Kind::Whole) {
    const Point from = drag_->before[drag_->index];
    if (from != pointer_->place) lines << legText(from, pointer_->place, north);
    lines << placeText(pointer_->place);
  } else {
    const std::size_t count = drag_->outline.size();
    lines << placeText(pointer_->place);
    lines << legText(drag_->outline[(drag_->index + count - 1) % count], pointer_->place, north);
    lines << legText(pointer_->place, drag_->outline[(drag_->index + 1) % count], north);
    lines << areaText(squareMetres(drag_->outline));
  }
  if (const QString kind = snapText(pointer_->kind); !kind.isEmpty()) lines << kind;
  return lines;
}

}  // namespace tessera::ui
