#include "ui/charts/track_chart.h"

#include <QLocale>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

// A dart that points along the heading; screen y grows downwards.
QCPScatterStyle dart(double heading, const QColor& colour, const QColor& edge, double size) {
  QPainterPath path;
  path.moveTo(size, 0);
  path.lineTo(-0.7 * size, 0.65 * size);
  path.lineTo(-0.35 * size, 0);
  path.lineTo(-0.7 * size, -0.65 * size);
  path.closeSubpath();
  QTransform turn;
  turn.rotateRadians(-heading);
  return {turn.map(path), QPen{edge, 1}, colour, size};
}

}  // namespace

TrackChart::TrackChart(QWidget* parent)
    : QCustomPlot{parent},
      route_{new QCPCurve{xAxis, yAxis}},
      track_{new QCPCurve{xAxis, yAxis}},
      vehicle_{addGraph()} {
  setObjectName(QStringLiteral("trackChart"));
  setNoAntialiasingOnDrag(true);
  route_->setScatterSkip(0);
  vehicle_->setLineStyle(QCPGraph::lsNone);
  vehicle_->removeFromLegend();
  layLegendAbove(*this);
  connect(this, &QCustomPlot::afterLayout, this, &TrackChart::fitToScale);
  connect(this, &QCustomPlot::mouseMove, this, &TrackChart::tip);
}

void TrackChart::setRoute(const QString& name, const std::vector<Point>& vertices) {
  QVector<double> xs;
  QVector<double> ys;
  for (const Point& p : vertices) {
    xs.append(p.x.value());
    ys.append(p.y.value());
  }
  route_->setData(xs, ys);
  routeName_ = name;
  retranslate();
}

void TrackChart::setTrack(const std::vector<DriveSample>& samples) {
  QVector<double> xs;
  QVector<double> ys;
  const DriveSample* newest = nullptr;
  for (const DriveSample& s : samples) {
    xs.append(static_cast<double>(s.x));  // NaN makes a gap
    ys.append(static_cast<double>(s.y));
    if (!std::isnan(s.x)) newest = &s;
  }
  track_->setData(xs, ys);
  vehicle_->data()->clear();
  if (newest != nullptr) {
    vehicle_->addData(static_cast<double>(newest->x), static_cast<double>(newest->y));
    heading_ = static_cast<double>(newest->heading);
    vehicle_->setScatterStyle(dart(heading_, colour_, xAxis->tickLabelColor(), fontMetrics().height() * 0.6));
  }
  bool some = false;
  QCPRange x;
  QCPRange y;
  for (QCPAbstractPlottable* plottable :
       {static_cast<QCPAbstractPlottable*>(route_), static_cast<QCPAbstractPlottable*>(track_)}) {
    bool foundX = false;
    bool foundY = false;
    const QCPRange ofX = plottable->getKeyRange(foundX);
    const QCPRange ofY = plottable->getValueRange(foundY);
    if (!foundX || !foundY) continue;
    x = some ? x.expanded(ofX) : ofX;
    y = some ? y.expanded(ofY) : ofY;
    some = true;
  }
  const double margin = 0.1 + 0.06 * std::max(x.size(), y.size());  // m
  wantedX_ = {x.lower - margin, x.upper + margin};
  wantedY_ = {y.lower - margin, y.upper + margin};
}

// Between layout and drawing, when the room is known.
void TrackChart::fitToScale() {
  if (byHand_) return yAxis->setScaleRatio(xAxis, 1.0);
  const QSize room = axisRect()->size();
  if (room.width() <= 0 || room.height() <= 0) return;
  const double before = xAxis->range().size();
  const double beforeUp = yAxis->range().size();
  const double scale = std::max(wantedX_.size() / room.width(), wantedY_.size() / room.height());
  xAxis->setRange(wantedX_.center() - scale * room.width() / 2, wantedX_.center() + scale * room.width() / 2);
  yAxis->setRange(wantedY_.center() - scale * room.height() / 2, wantedY_.center() + scale * room.height() / 2);
  // The ticks of this drawing were chosen before; with quite another range they are drawn once more.
  const bool other = std::abs(before - xAxis->range().size()) > 0.01 * before ||
                     std::abs(beforeUp - yAxis->range().size()) > 0.01 * beforeUp;
  if (other) replot(QCustomPlot::rpQueuedReplot);
}

void TrackChart::layOutFor(const QSize& size) {
  setViewport(QRect{QPoint{}, size});
  for (int i = 0; i < 2; ++i)
    replot(QCustomPlot::rpImmediateRefresh);  // the second with the ticks of the first's range
}

void TrackChart::setByHand(bool byHand) {
  byHand_ = byHand;
  setInteractions(byHand ? QCP::iRangeDrag | QCP::iRangeZoom : QCP::Interactions{});
}

void TrackChart::dress(const QPalette& palette, const QFont& plotFont, const QColor& vehicle) {
  const PlotColours colours{palette};
  colour_ = vehicle;
  setFont(plotFont);
  setBackground(colours.back);
  dressAxes(*axisRect(), colours, plotFont);
  dressLegend(*legend, colours, plotFont);
  route_->setPen(QPen{colours.route, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
  track_->setPen(QPen{vehicle, 1.8});
  vehicle_->setScatterStyle(dart(heading_, vehicle, colours.ink, fontMetrics().height() * 0.6));
}

void TrackChart::retranslate() {
  setAccessibleName(tr("Track against route"));
  xAxis->setLabel(tr("x (m)"));
  yAxis->setLabel(tr("y (m)"));
  track_->setName(tr("Track"));
  route_->setName(routeName_.isEmpty() ? tr("No route") : tr("Route %1").arg(routeName_));
}

void TrackChart::tip(QMouseEvent* event) {
  if (!axisRect()->rect().contains(event->pos())) return QToolTip::hideText();
  const QLocale locale;
  QToolTip::showText(event->globalPosition().toPoint(),
                     tr("x %1 m, y %2 m")
                         .arg(locale.toString(xAxis->pixelToCoord(event->pos().x()), 'f', 2),
                              locale.toString(yAxis->pixelToCoord(event->pos().y()), 'f', 2)),
                     this);
}

}  // namespace tessera::ui
