#include <qcustomplot.h>

#include <algorithm>
#include <numeric>

#include "ui/plot/chart_frame.h"
#include "ui/plot/error_bins.h"
#include "ui/plot/run_charts.h"

namespace tessera::ui {
namespace {

constexpr int kErrorChartHeight = 520;
constexpr int kBins = 50;
constexpr std::size_t kMostFilled = 2;  // series; more of them upon each other hide their own colours
constexpr double kShown = 0.995;        // of all errors; the few largest would leave no room for the rest

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

QString nameOf(const ErrorSeries& series) {
  const double mean =
      std::accumulate(series.errors.begin(), series.errors.end(), 0.0) / static_cast<double>(series.errors.size());
  return QStringLiteral("%1: mean %2 cm, 95 % below %3 cm, largest %4 cm")
      .arg(QString::fromStdString(series.name))
      .arg(mean, 0, 'f', 2)
      .arg(quantile(series.errors, 0.95), 0, 'f', 2)
      .arg(*std::max_element(series.errors.begin(), series.errors.end()), 0, 'f', 1);
}

}  // namespace

Result<void> saveErrorChart(const std::string& title, const std::vector<ErrorSeries>& series, const QString& file) {
  QCustomPlot plot;
  plot.setAntialiasedElements(QCP::aeAll);
  double shown = 0.1;  // cm
  for (const ErrorSeries& one : series) shown = std::max(shown, quantile(one.errors, kShown));
  const double width = shown / kBins;
  for (std::size_t i = 0; i < series.size(); ++i) {
    QVector<double> left(kBins + 1);
    for (int bin = 0; bin <= kBins; ++bin) left[bin] = bin * width;
    const std::vector<double> inBins = sharesInBins(series[i].errors, width, kBins);
    QVector<double> shares(inBins.begin(), inBins.end());
    shares.push_back(0.0);
    auto* graph = plot.addGraph();  // owned by the plot
    graph->setData(left, shares, true);
    graph->setLineStyle(QCPGraph::lsStepLeft);
    QColor colour = chartColour(i);
    graph->setPen(QPen{colour, 2});
    colour.setAlphaF(0.15F);
    if (series.size() <= kMostFilled) graph->setBrush(colour);
    graph->setName(nameOf(series[i]));
  }
  plot.xAxis->setLabel(QStringLiteral("Position error [cm]"));
  plot.yAxis->setLabel(QStringLiteral("Share of ticks [% in %1 mm]").arg(width * 10.0, 0, 'f', 1));
  plot.rescaleAxes();
  plot.xAxis->setRange(0.0, shown);
  plot.yAxis->setRange(0.0, plot.yAxis->range().upper * 1.05);
  addChartTitle(plot, title);
  putLegendBelow(plot, 1);
  return saveChart(plot, file, kErrorChartHeight + 20 * static_cast<int>(series.size()));
}

}  // namespace tessera::ui
