#include "ui/locating/innovation_chart.h"

#include <algorithm>

#include "ui/charts/ago_ticker.h"

namespace tessera::ui {
namespace {

constexpr double kLeastTop = 8.0;   // of the scale
constexpr double kMostTop = 20.0;   // a read far off is drawn at the edge
constexpr double kPointSize = 5.0;  // pixels

}  // namespace

InnovationChart::InnovationChart(QWidget* parent)
    : QCustomPlot{parent},
      reads_{addGraph()},
      mean_{addGraph()},
      band_{new QCPItemRect{this}},
      ticker_{QSharedPointer<AgoTicker>::create()} {
  setObjectName(QStringLiteral("innovationChart"));
  reads_->setLineStyle(QCPGraph::lsNone);
  mean_->setLineStyle(QCPGraph::lsStepLeft);
  xAxis->setTicker(ticker_);
  yAxis->ticker()->setTickCount(4);
  band_->setLayer(QStringLiteral("grid"));
  band_->setPen(Qt::NoPen);
  for (QCPItemPosition* at : {band_->topLeft, band_->bottomRight}) {
    at->setTypeX(QCPItemPosition::ptAxisRectRatio);
    at->setTypeY(QCPItemPosition::ptPlotCoords);
  }
  layLegendAbove(*this);
  const int line = fontMetrics().height();
  setMinimumSize(12 * line, 7 * line);
}

void InnovationChart::show(const LocatingRecord& record) {
  QVector<double> times;
  QVector<double> values;
  QVector<double> means;
  const double now = record.now().value();
  double top = kLeastTop;
  for (const LocatingRecord::Read& read : record.reads()) {
    if (read.at.value() < now - 1.5 * kSpan) continue;
    times.append(read.at.value());
    values.append(std::min(read.nis, kMostTop));
    means.append(std::min(read.mean, kMostTop));
    if (read.at.value() >= now - kSpan) top = std::max({top, 1.1 * values.back(), 1.1 * means.back()});
  }
  // The mean stays until the next read.
  QVector<double> meanTimes = times;
  if (!means.empty()) {
    meanTimes.append(now);
    means.append(means.back());
  }
  reads_->setData(times, values, true);
  mean_->setData(meanTimes, means, true);
  const locate::MeanBounds bounds = record.verdict().bounds;
  band_->topLeft->setCoords(0.0, std::min(bounds.high, kMostTop));
  band_->bottomRight->setCoords(1.0, bounds.low);
  ticker_->setNow(now, false);
  xAxis->setRange(now - kSpan, now);
  yAxis->setRange(0.0, std::min(top, kMostTop));
  replot(QCustomPlot::rpQueuedReplot);
}

void InnovationChart::dress(const QPalette& palette, const QFont& plotFont, const QColor& vehicle) {
  const PlotColours colours{palette};
  setFont(plotFont);
  setBackground(colours.back);
  dressAxes(*axisRect(), colours, plotFont);
  dressLegend(*legend, colours, plotFont);
  reads_->setScatterStyle(QCPScatterStyle{QCPScatterStyle::ssCircle, QPen{vehicle, 1.4}, QBrush{}, kPointSize});
  mean_->setPen(QPen{colours.commanded, 2.0});
  QColor veil = colours.band;
  veil.setAlphaF(0.22F);
  band_->setBrush(veil);
  replot(QCustomPlot::rpQueuedReplot);
}

void InnovationChart::retranslate() {
  setAccessibleName(tr("Innovations of the reads"));
  setToolTip(tr("Each point is a read: how far its tag lay from where it was expected, measured by what was doubted "
                "(NIS). The "
                "line is the mean of the last %1; it lies in the green band when the doubt is honest.")
                 .arg(LocatingRecord::kWindow));
  reads_->setName(tr("Read"));
  mean_->setName(tr("Mean of %1").arg(LocatingRecord::kWindow));
  xAxis->setLabel(tr("Time (s), 0 is the newest"));
  yAxis->setLabel(tr("NIS", "normalised innovation squared"));
  replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace tessera::ui
