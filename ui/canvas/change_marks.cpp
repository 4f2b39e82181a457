#include "ui/canvas/change_marks.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>
#include <QSet>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/canvas/clip.h"
#include "ui/canvas/furniture.h"

namespace tessera::ui {
namespace {

constexpr double kSignReach = 8.0;   // pixels from a sign's middle
constexpr double kArrowFrom = 12.0;  // pixels of way from which on a move has its line
constexpr std::size_t kMostDashed = 100;
constexpr std::array kLooks{ChangeLook::Added, ChangeLook::Removed, ChangeLook::Moved, ChangeLook::Changed};

QColor colourOf(const CanvasTheme& theme, ChangeLook look) {
  switch (look) {
    case ChangeLook::Added:
      return theme.zone(floor::ZoneKind::Charging);
    case ChangeLook::Removed:
      return theme.fault;
    default:
      return theme.waiting;
  }
}

Qt::PenStyle lineOf(ChangeLook look) {
  constexpr std::array styles{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  return styles.at(static_cast<std::size_t>(look));
}

Qt::BrushStyle hatchOf(ChangeLook look) {
  constexpr std::array styles{Qt::BDiagPattern, Qt::DiagCrossPattern, Qt::NoBrush, Qt::FDiagPattern};
  return styles.at(static_cast<std::size_t>(look));
}

void paintArea(QPainter& painter, const View& view, const QColor& colour, const ChangeMarks::Shape& shape) {
  const QRectF around = QRectF{QPointF{}, view.size()}.adjusted(-20, -20, 20, 20);
  QPainterPath path;
  for (const auto& line : shape.lines) {
    QPolygonF ring;
    for (const Point& p : line) ring << view.toPixel(p);
    ring = clipped(ring, around);
    if (!ring.isEmpty()) path.addPolygon(ring), path.closeSubpath();
  }
  if (path.isEmpty()) return;
  QColor fill = colour;
  fill.setAlpha(46);
  painter.fillPath(path, fill);
  fill.setAlpha(120);
  if (hatchOf(shape.look) != Qt::NoBrush) painter.fillPath(path, QBrush{fill, hatchOf(shape.look)});
  // Many small pieces would take a tenth of a second to be dashed.
  const bool many = shape.lines.size() > kMostDashed;
  painter.setRenderHint(QPainter::Antialiasing, !many);
  painter.setPen(many ? QPen{colour, 0} : QPen{colour, 2.0, lineOf(shape.look), Qt::FlatCap, Qt::MiterJoin});
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
  painter.setRenderHint(QPainter::Antialiasing);
}

void paintWay(QPainter& painter, const View& view, const CanvasTheme& theme, const ChangeMarks::Shape& shape) {
  const QRectF around = QRectF{QPointF{}, view.size()}.adjusted(-20, -20, 20, 20);
  for (const auto& line : shape.lines) {
    for (std::size_t n = 1; n < line.size(); ++n) {
      const auto leg = clipped(QLineF{view.toPixel(line[n - 1]), view.toPixel(line[n])}, around);
      if (!leg) continue;
      QColor halo = theme.halo;
      halo.setAlpha(160);
      painter.setPen(QPen{halo, 7.0, Qt::SolidLine, Qt::RoundCap});
      painter.drawLine(*leg);
      painter.setPen(QPen{colourOf(theme, shape.look), 4.0, lineOf(shape.look), Qt::FlatCap});
      painter.drawLine(*leg);
    }
  }
}

void paintMove(QPainter& painter, const View& view, const CanvasTheme& theme, const ChangeMarks::Sign& sign) {
  const QRectF around = QRectF{QPointF{}, view.size()}.adjusted(-20, -20, 20, 20);
  const QLineF way{view.toPixel(*sign.from), view.toPixel(sign.place.centre())};
  const auto seen = clipped(way, around);
  if (!seen || way.length() < kArrowFrom) return;
  painter.setPen(QPen{theme.halo, 4.0});
  painter.drawLine(*seen);
  painter.setPen(QPen{colourOf(theme, sign.look), 2.0});
  painter.drawLine(*seen);
  painter.setBrush(theme.halo);
  if (around.contains(way.p1())) painter.drawEllipse(way.p1(), 3.0, 3.0);
}

}  // namespace

QString changeLookText(ChangeLook look) {
  switch (look) {
    case ChangeLook::Added:
      return QCoreApplication::translate("ChangeMarks", "Added");
    case ChangeLook::Removed:
      return QCoreApplication::translate("ChangeMarks", "Removed");
    case ChangeLook::Moved:
      return QCoreApplication::translate("ChangeMarks", "Moved");
    case ChangeLook::Changed:
      break;
  }
  return QCoreApplication::translate("ChangeMarks", "Changed");
}

// Plus in a disc, minus in a square, an arrow's head, a point in a lozenge.
void paintChangeSign(QPainter& painter, const CanvasTheme& theme, ChangeLook look, QPointF at, double reach) {
  const double r = reach;
  painter.setPen(QPen{theme.halo, std::min(2.0, 0.25 * r)});
  painter.setBrush(colourOf(theme, look));
  if (look == ChangeLook::Added) painter.drawEllipse(at, r, r);
  if (look == ChangeLook::Removed) painter.drawRect(QRectF{at - QPointF{0.9 * r, 0.9 * r}, QSizeF{1.8 * r, 1.8 * r}});
  if (look == ChangeLook::Moved)
    painter.drawPolygon(QPolygonF{at + QPointF{1.3 * r, 0}, at + QPointF{-r, 1.15 * r}, at + QPointF{-0.4 * r, 0},
                                  at + QPointF{-r, -1.15 * r}});
  if (look == ChangeLook::Changed)
    painter.drawPolygon(QPolygonF{at + QPointF{1.15 * r, 0}, at + QPointF{0, 1.15 * r}, at + QPointF{-1.15 * r, 0},
                                  at + QPointF{0, -1.15 * r}});
  const double thick = 0.25 * r;
  painter.setPen(QPen{theme.dark ? QColor{Qt::black} : QColor{Qt::white}, thick, Qt::SolidLine, Qt::RoundCap});
  if (look == ChangeLook::Added) painter.drawLine(at + QPointF{0, -0.5 * r}, at + QPointF{0, 0.5 * r});
  if (look == ChangeLook::Added || look == ChangeLook::Removed)
    painter.drawLine(at + QPointF{-0.5 * r, 0}, at + QPointF{0.5 * r, 0});
  if (look == ChangeLook::Changed) {
    painter.setBrush(painter.pen().color());
    painter.drawEllipse(at, 0.2 * r, 0.2 * r);
  }
}

void paintChanges(QPainter& painter, const View& view, const CanvasTheme& theme, const ChangeMarks& changes) {
  painter.setRenderHint(QPainter::Antialiasing);
  // Hatching stays with the floor when it is panned.
  painter.setBrushOrigin(view.toPixel({}));
  for (const ChangeMarks::Shape& shape : changes.shapes) {
    if (shape.closed)
      paintArea(painter, view, colourOf(theme, shape.look), shape);
    else
      paintWay(painter, view, theme, shape);
  }
  const SiteBox seen = view.visible(20.0);
  QSet<QPair<int, int>> taken;
  for (const ChangeMarks::Sign& sign : changes.signs) {
    if (sign.place.empty() || !(sign.place.touches(seen) || sign.from)) continue;
    const QPointF at = view.toPixel(sign.place.centre());
    // Of signs that would cover one another one is drawn.
    const QPair<int, int> cell{static_cast<int>(std::floor(at.x() / (3 * kSignReach))),
                               static_cast<int>(std::floor(at.y() / (3 * kSignReach)))};
    if (taken.contains(cell)) continue;
    taken.insert(cell);
    if (sign.from) paintMove(painter, view, theme, sign);
    if (sign.place.touches(seen)) paintChangeSign(painter, theme, sign.look, at, kSignReach);
  }
  if (!changes.chosen || *changes.chosen >= changes.signs.size()) return;
  const ChangeMarks::Sign& chosen = changes.signs[*changes.chosen];
  if (chosen.place.empty() || !chosen.place.touches(seen)) return;
  const QPointF at = view.toPixel(chosen.place.centre());
  painter.setBrush(Qt::NoBrush);
  for (const auto& [colour, width] : {std::pair{theme.halo, 6.0}, std::pair{theme.accent, 3.0}}) {
    painter.setPen(QPen{colour, width});
    painter.drawEllipse(at, 2 * kSignReach, 2 * kSignReach);
  }
  paintChangeSign(painter, theme, chosen.look, at, kSignReach + 2);
}

void ChangeLayer::set(ChangeMarks marks) {
  marks_ = std::move(marks);
  picture_.forget();
}

void ChangeLayer::paint(QPainter& painter, const View& view, const CanvasTheme& theme) {
  picture_.paint(painter, view, theme, [&](QPainter& keeping) { paintChanges(keeping, view, theme, marks_); });
}

double paintChangeLegend(QPainter& painter, const View& view, const CanvasTheme& theme, const ChangeMarks& changes) {
  std::vector<ChangeLook> looks;
  for (const ChangeLook look : kLooks) {
    const auto has = [look](const auto& item) { return item.look == look; };
    if (std::any_of(changes.signs.begin(), changes.signs.end(), has) ||
        std::any_of(changes.shapes.begin(), changes.shapes.end(), has))
      looks.push_back(look);
  }
  const QFontMetricsF metrics{painter.font()};
  const double line = metrics.height() * 1.3;
  const double pad = metrics.height() * 0.6;
  const double sign = metrics.height() * 1.4;
  const double left = rulerBand(painter.font()).width() + pad;
  const double most = view.size().width() - left - 8 * metrics.height();  // the north arrow stands at the right
  if (looks.empty() || most < 6 * metrics.height()) return 0.0;
  double wide = metrics.horizontalAdvance(changes.title);
  for (const ChangeLook look : looks) wide = std::max(wide, sign + metrics.horizontalAdvance(changeLookText(look)));
  wide = std::min(wide, most - 2 * pad);
  const QRectF panel{left, pad, wide + 2 * pad, (static_cast<double>(looks.size()) + 1.0) * line + pad};
  QColor back = theme.panel;
  back.setAlpha(225);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(back);
  painter.drawRoundedRect(panel, 4, 4);
  QRectF row{panel.left() + pad, panel.top() + 0.5 * pad, wide, line};
  painter.setPen(theme.quietText);
  painter.drawText(row, Qt::AlignVCenter, metrics.elidedText(changes.title, Qt::ElideRight, wide));
  for (const ChangeLook look : looks) {
    row.translate(0, line);
    paintChangeSign(painter, theme, look, {row.left() + 0.5 * metrics.height(), row.center().y()},
                    0.38 * metrics.height());
    painter.setPen(theme.text);
    painter.drawText(row.adjusted(sign, 0, 0, 0), Qt::AlignVCenter, changeLookText(look));
  }
  return panel.bottom();
}

const ChangeMarks::Sign* changeAt(const ChangeMarks& changes, const View& view, QPointF pixel) {
  for (const ChangeMarks::Sign& sign : changes.signs) {
    if (sign.place.empty() || sign.sentence.isEmpty()) continue;
    const QPointF away = view.toPixel(sign.place.centre()) - pixel;
    if (std::hypot(away.x(), away.y()) <= kSignReach) return &sign;
  }
  return nullptr;
}

}  // namespace tessera::ui
