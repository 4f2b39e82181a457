#include "ui/charts/time_chart.h"

#include <QLocale>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/charts/ago_ticker.h"

namespace tessera::ui {
namespace {

constexpr double kCmPerM = 100.0;
constexpr double kMinutesFrom = 180.0;  // s: longer spans are labelled in minutes

}  // namespace

TimeChart::TimeChart(QWidget* parent)
    : QCustomPlot{parent},
      error_{new QCPAxisRect{this}},
      pace_{new QCPAxisRect{this}},
      paceLegend_{new QCPLegend},
      errorTitle_{new QCPTextElement{this}},
      paceTitle_{new QCPTextElement{this}},
      ticker_{new AgoTicker} {
  setObjectName(QStringLiteral("timeChart"));
  setNoAntialiasingOnDrag(true);
  setAutoAddPlottableToLegend(false);
  plotLayout()->clear();
  // Titles lie above the axes: beside them they would be cut off where the panel is low.
  heading_ = new QCPLayoutGrid;
  plotLayout()->addElement(0, 0, errorTitle_);
  plotLayout()->addElement(1, 0, error_);
  plotLayout()->addElement(2, 0, heading_);
  plotLayout()->addElement(3, 0, pace_);
  plotLayout()->setRowSpacing(0);
  heading_->addElement(0, 0, paceTitle_);
  heading_->addElement(0, 1, paceLegend_);
  heading_->setColumnStretchFactor(1, 0.001);
  heading_->setMargins(QMargins{0, 0, 12, 0});
  for (const int row : {0, 2}) plotLayout()->setRowStretchFactor(row, 0.001);
  for (QCPTextElement* title : {errorTitle_, paceTitle_}) {
    title->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    title->setMargins(QMargins{6, 2, 2, 2});
  }
  auto* margins = new QCPMarginGroup{this};
  for (QCPAxisRect* axes : {error_, pace_}) {
    axes->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    axes->axis(QCPAxis::atBottom)->setTicker(ticker_);
    axes->setRangeZoom(Qt::Horizontal);
    axes->setRangeDrag(Qt::Horizontal);
    for (QCPAxis* axis : axes->axes()) {
      axis->setLayer(QStringLiteral("axes"));
      axis->grid()->setLayer(QStringLiteral("grid"));
    }
  }
  QCPAxis* above = error_->axis(QCPAxis::atBottom);
  QCPAxis* below = pace_->axis(QCPAxis::atBottom);
  above->setTickLabels(false);
  const auto follow = [](QCPAxis* other) { return [other](const QCPRange& range) { other->setRange(range); }; };
  connect(above, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), below, follow(below));
  connect(below, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), above, follow(above));

  crossTrack_ = addGraph(above, error_->axis(QCPAxis::atLeft));
  commanded_ = addGraph(below, pace_->axis(QCPAxis::atLeft));
  reported_ = addGraph(below, pace_->axis(QCPAxis::atLeft));
  commanded_->setLineStyle(QCPGraph::lsStepLeft);
  paceLegend_->setLayer(QStringLiteral("legend"));
  layFlat(*paceLegend_);
  commanded_->addToLegend(paceLegend_);
  reported_->addToLegend(paceLegend_);
  buildBand();
  buildCrosshair();
}

// One above the other where there is height for both, else side by side.
void TimeChart::arrange() {
  const int line = fontMetrics().height();
  const bool low = height() < 18 * line && width() > 30 * line;
  if (low == low_) return;
  low_ = low;
  plotLayout()->take(heading_);
  plotLayout()->take(pace_);
  plotLayout()->simplify();
  plotLayout()->addElement(low ? 0 : 2, low ? 1 : 0, heading_);
  plotLayout()->addElement(low ? 1 : 3, low ? 1 : 0, pace_);
  for (int row = 0; row < plotLayout()->rowCount(); ++row)
    plotLayout()->setRowStretchFactor(row, row % 2 == 0 ? 0.001 : 1.0);
  error_->axis(QCPAxis::atBottom)->setTickLabels(low);
  retranslate();
}

void TimeChart::resizeEvent(QResizeEvent* event) {
  arrange();
  QCustomPlot::resizeEvent(event);
}

void TimeChart::buildBand() {
  band_ = new QCPItemRect{this};
  bandName_ = new QCPItemText{this};
  band_->setLayer(QStringLiteral("grid"));
  band_->setPen(Qt::NoPen);
  QCPAxis* time = error_->axis(QCPAxis::atBottom);
  QCPAxis* value = error_->axis(QCPAxis::atLeft);
  for (QCPItemPosition* at : {band_->topLeft, band_->bottomRight, bandName_->position}) {
    at->setTypeX(QCPItemPosition::ptAxisRectRatio);
    at->setTypeY(QCPItemPosition::ptPlotCoords);
    at->setAxisRect(error_);
    at->setAxes(time, value);
  }
  band_->setClipAxisRect(error_);
  bandName_->setClipAxisRect(error_);
  band_->topLeft->setCoords(0.0, kBand);
  band_->bottomRight->setCoords(1.0, -kBand);
  bandName_->position->setCoords(0.0, kBand);
  bandName_->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  bandName_->setPadding(QMargins{6, 1, 0, 0});
}

void TimeChart::buildCrosshair() {
  const auto hairIn = [this](QCPAxisRect* axes) {
    auto* hair = new QCPItemLine{this};
    for (QCPItemPosition* at : {hair->start, hair->end}) {
      at->setTypeX(QCPItemPosition::ptPlotCoords);
      at->setTypeY(QCPItemPosition::ptAxisRectRatio);
      at->setAxisRect(axes);
      at->setAxes(axes->axis(QCPAxis::atBottom), axes->axis(QCPAxis::atLeft));
    }
    hair->setClipAxisRect(axes);
    hair->setVisible(false);
    return hair;
  };
  errorHair_ = hairIn(error_);
  paceHair_ = hairIn(pace_);
  connect(this, &QCustomPlot::mouseMove, this, &TimeChart::tip);
}

void TimeChart::setSamples(const std::vector<DriveSample>& samples, double until, double span) {
  fitTicks();
  samples_ = samples;
  until_ = until;
  QVector<double> times;
  QVector<double> errors;
  QVector<double> ordered;
  QVector<double> driven;
  double widest = 1.6 * kBand;
  double fastest = 0.1;
  double slowest = 0.0;
  for (const DriveSample& s : samples_) {
    times.append(s.time);
    errors.append(kCmPerM * static_cast<double>(s.crossTrack));  // NaN makes a gap
    ordered.append(static_cast<double>(s.commanded));
    driven.append(static_cast<double>(s.speed));
    if (!std::isnan(s.crossTrack)) widest = std::max(widest, 1.15 * std::abs(errors.back()));
    for (const double speed : {ordered.back(), driven.back()}) {
      if (std::isnan(speed)) continue;
      fastest = std::max(fastest, 1.15 * speed);
      slowest = std::min(slowest, 1.15 * speed);
    }
  }
  crossTrack_->setData(times, errors, true);
  commanded_->setData(times, ordered, true);
  reported_->setData(times, driven, true);
  const bool minutes = span > kMinutesFrom;
  if (ticker_->minutes() != minutes) {
    ticker_->setNow(until, minutes);
    retranslate();
  }
  ticker_->setNow(until, minutes);
  error_->axis(QCPAxis::atBottom)->setRange(until - span, until);
  error_->axis(QCPAxis::atLeft)->setRange(-widest, widest);
  pace_->axis(QCPAxis::atLeft)->setRange(slowest, fastest);
}

// As many numbers as have room one above the other.
void TimeChart::fitTicks() {
  for (QCPAxisRect* axes : {error_, pace_}) {
    QCPAxis* axis = axes->axis(QCPAxis::atLeft);
    const int line = QFontMetrics{axis->tickLabelFont()}.height();
    axis->ticker()->setTickCount(std::clamp(axes->height() / (2 * line), 1, 5));
  }
}

void TimeChart::setByHand(bool byHand) {
  setInteractions(byHand ? QCP::iRangeDrag | QCP::iRangeZoom : QCP::Interactions{});
}

void TimeChart::dress(const QPalette& palette, const QFont& plotFont, const QColor& vehicle) {
  const PlotColours colours{palette};
  setFont(plotFont);
  setBackground(colours.back);
  dressAxes(*error_, colours, plotFont);
  dressAxes(*pace_, colours, plotFont);
  dressLegend(*paceLegend_, colours, plotFont);
  // Characters of another script may be taller than the font's own.
  const int row = QFontMetrics{plotFont}.height() * 8 / 5;
  heading_->setMinimumSize(0, row);
  errorTitle_->setMinimumSize(0, row);
  for (QCPTextElement* title : {errorTitle_, paceTitle_}) {
    title->setFont(plotFont);
    title->setTextColor(colours.ink);
  }
  crossTrack_->setPen(QPen{vehicle, 1.6});
  commanded_->setPen(QPen{colours.commanded, 1.4, Qt::DashLine});
  reported_->setPen(QPen{vehicle, 1.6});
  QColor veil = colours.band;
  veil.setAlphaF(0.13F);
  band_->setBrush(veil);
  bandName_->setColor(colours.band);
  bandName_->setFont(plotFont);
  for (QCPItemLine* hair : {errorHair_, paceHair_}) hair->setPen(QPen{colours.ink, 1, Qt::DotLine});
}

void TimeChart::retranslate() {
  setAccessibleName(tr("Cross-track error and speed"));
  errorTitle_->setText(tr("Cross-track error (cm)"));
  paceTitle_->setText(tr("Speed (m/s)"));
  const QString time = ticker_->minutes() ? tr("Time (min), 0 is the newest") : tr("Time (s), 0 is the newest");
  pace_->axis(QCPAxis::atBottom)->setLabel(time);
  error_->axis(QCPAxis::atBottom)->setLabel(low_ ? time : QString{});
  commanded_->setName(tr("Commanded"));
  reported_->setName(tr("Reported"));
  bandName_->setText(tr("± %1 cm").arg(QLocale{}.toString(kBand, 'f', 0)));
}

QString TimeChart::valuesAt(const DriveSample& s) const {
  const QLocale locale;
  const auto number = [&](float value, double factor, int decimals) {
    return std::isnan(value) ? QStringLiteral("–")
                             : locale.toString(factor * static_cast<double>(value), 'f', decimals);
  };
  return tr("%1 s before the newest\nCross-track error %2 cm\nSpeed %3 m/s, commanded %4 m/s")
      .arg(locale.toString(until_ - s.time, 'f', 1), number(s.crossTrack, kCmPerM, 1), number(s.speed, 1.0, 2),
           number(s.commanded, 1.0, 2));
}

void TimeChart::tip(QMouseEvent* event) {
  const bool inside = error_->rect().contains(event->pos()) || pace_->rect().contains(event->pos());
  if (!inside || samples_.empty()) return hideTip();
  const double time = error_->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), time,
                                      [](const DriveSample& s, double t) { return s.time < t; });
  const auto nearest =
      after == samples_.end() || (after != samples_.begin() && time - std::prev(after)->time < after->time - time)
          ? std::prev(after)
          : after;
  for (QCPItemLine* hair : {errorHair_, paceHair_}) {
    hair->start->setCoords(nearest->time, 0.0);
    hair->end->setCoords(nearest->time, 1.0);
    hair->setVisible(true);
  }
  QToolTip::showText(event->globalPosition().toPoint(), valuesAt(*nearest), this);
  replot(QCustomPlot::rpQueuedReplot);
}

void TimeChart::hideTip() {
  QToolTip::hideText();
  if (!errorHair_->visible()) return;
  errorHair_->setVisible(false);
  paceHair_->setVisible(false);
  replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace tessera::ui
