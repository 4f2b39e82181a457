#include "ui/canvas/readout.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <vector>

#include "floor/bearing.h"

namespace tessera::ui {
namespace {

struct ReadoutWords {
  Q_DECLARE_TR_FUNCTIONS(Readout)
};

}  // namespace

QString legText(Point from, Point to, Radians northToY) {
  double bearing = std::round(degrees(floor::bearingOfHeading(direction(to - from), northToY)));
  if (bearing < 0.0) bearing += 360.0;
  return ReadoutWords::tr("%1 m, %2°", "length and bearing of a leg")
      .arg(QLocale().toString(distance(from, to).value(), 'f', 2))
      .arg(static_cast<int>(bearing) % 360, 3, 10, QLatin1Char('0'));
}

QString placeText(Point p) {
  const QLocale locale;
  return ReadoutWords::tr("x %1 m, y %2 m")
      .arg(locale.toString(p.x.value(), 'f', 2), locale.toString(p.y.value(), 'f', 2));
}

QString snapText(Snap::Kind kind) {
  switch (kind) {
    case Snap::Kind::Vertex:
      return ReadoutWords::tr("vertex");
    case Snap::Kind::Tag:
      return ReadoutWords::tr("tag");
    case Snap::Kind::TileCorner:
      return ReadoutWords::tr("tile corner");
    case Snap::Kind::TileMiddle:
      return ReadoutWords::tr("tile middle");
    case Snap::Kind::TileEdge:
      return ReadoutWords::tr("tile edge");
    case Snap::Kind::Direction:
      return ReadoutWords::tr("45° steps");
    case Snap::Kind::None:
      break;
  }
  return {};
}

void paintReadout(QPainter& painter, const View& view, const CanvasTheme& theme, QPointF at, const QStringList& lines,
                  const QStringList& wrong) {
  const QFontMetricsF metrics{painter.font()};
  double width = 0.0;
  for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
  double height = metrics.height() * static_cast<double>(lines.size());
  std::vector<QRectF> below;
  for (const QString& sentence : wrong) {
    const QRectF needed = metrics.boundingRect(QRectF{0, 0, 24 * metrics.height(), 1e4}, Qt::TextWordWrap, sentence);
    below.push_back(QRectF{0, height, needed.width() + 1, needed.height()});
    width = std::max(width, needed.width() + 1);
    height += needed.height();
  }
  const double pad = metrics.height() * 0.4;
  QRectF panel{at.x() + 18, at.y() + 18, width + 2 * pad, height + pad};
  if (panel.right() > view.size().width()) panel.moveRight(at.x() - 18);
  if (panel.bottom() > view.size().height()) panel.moveBottom(at.y() - 18);
  QColor back = theme.panel;
  back.setAlpha(235);
  painter.setPen(QPen{wrong.isEmpty() ? theme.grid : theme.fault, 1});
  painter.setBrush(back);
  painter.drawRoundedRect(panel, 4, 4);
  const QPointF corner = panel.topLeft() + QPointF{pad, pad / 2};
  for (qsizetype n = 0; n < lines.size(); ++n) {
    painter.setPen(n == 0 ? theme.text : theme.quietText);
    painter.drawText(corner + QPointF{0, metrics.ascent() + metrics.height() * static_cast<double>(n)}, lines[n]);
  }
  painter.setPen(theme.fault);
  for (qsizetype n = 0; n < wrong.size(); ++n)
    painter.drawText(below[static_cast<std::size_t>(n)].translated(corner), Qt::TextWordWrap, wrong[n]);
}

void paintHandle(QPainter& painter, QPointF at, double radius, QColor fill, QColor edge) {
  painter.setPen(QPen{edge, 2.0});
  painter.setBrush(fill);
  painter.drawEllipse(at, radius, radius);
}

void paintSnap(QPainter& painter, const View& view, const CanvasTheme& theme, const Snap& snap) {
  const QPointF at = view.toPixel(snap.place);
  painter.setPen(QPen{theme.accent, 2.0});
  painter.setBrush(Qt::NoBrush);
  switch (snap.kind) {
    case Snap::Kind::Vertex:
    case Snap::Kind::Tag:
      painter.drawEllipse(at, 8.0, 8.0);
      break;
    case Snap::Kind::TileCorner:
    case Snap::Kind::TileMiddle:
      painter.drawRect(QRectF{at.x() - 6, at.y() - 6, 12, 12});
      break;
    case Snap::Kind::TileEdge:
      painter.drawPolygon(QPolygonF{at + QPointF{0, -8}, at + QPointF{8, 0}, at + QPointF{0, 8}, at + QPointF{-8, 0}});
      break;
    case Snap::Kind::Direction:
    case Snap::Kind::None:
      painter.drawLine(at - QPointF{6, 0}, at + QPointF{6, 0});
      painter.drawLine(at - QPointF{0, 6}, at + QPointF{0, 6});
      break;
  }
}

}  // namespace tessera::ui
