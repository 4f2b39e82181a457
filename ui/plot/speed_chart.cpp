#include <qcustomplot.h>

#include <algorithm>
#include <array>

#include "ui/plot/chart_frame.h"
#include "ui/plot/run_charts.h"

namespace tessera::ui {
namespace {

constexpr int kPanelHeight = 330;
constexpr int kRoom = 110;        // title and legend
constexpr double kApart = 0.006;  // of the width of the axis: what stands at one speed is drawn side by side

QCPScatterStyle markOf(std::size_t series) {
  constexpr std::array shapes{QCPScatterStyle::ssDisc, QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
                              QCPScatterStyle::ssDiamond};
  QCPScatterStyle mark{shapes[series % shapes.size()], 9};
  mark.setPen(QPen{chartColour(series), 2});
  mark.setBrush(series % shapes.size() == 0 ? chartColour(series) : QColor{Qt::white});
  return mark;
}

void addSeries(QCPAxisRect& rect, const SpeedSeries& series, std::size_t index, double shift, bool named) {
  QCustomPlot& plot = *rect.parentPlot();
  QVector<double> at, mean, below, above;
  for (const AtSpeed& point : series.points) {
    at.push_back(point.speed + shift);
    mean.push_back(point.mean);
    below.push_back(point.mean - point.low);
    above.push_back(point.high - point.mean);
  }
  QCPAxis* x = rect.axis(QCPAxis::atBottom);
  QCPAxis* y = rect.axis(QCPAxis::atLeft);
  auto* graph = plot.addGraph(x, y);  // owned by the plot, as all that follows
  graph->setData(at, mean, true);
  graph->setPen(QPen{chartColour(index), 2});
  graph->setScatterStyle(markOf(index));
  graph->setName(QString::fromStdString(series.name));
  auto* bars = new QCPErrorBars{x, y};
  bars->setData(below, above);
  bars->setDataPlottable(graph);
  bars->setPen(QPen{chartColour(index), 1.5});
  bars->setSymbolGap(0);
  bars->removeFromLegend();
  if (!named) graph->removeFromLegend();
}

void addPanel(QCustomPlot& plot, const SpeedPanel& panel, int row, double fastest) {
  // The first panel has the axes that the plot came with, in which its legend lies until it is put below.
  QCPAxisRect* rect = row == 0 ? plot.axisRect() : new QCPAxisRect{&plot};
  if (row > 0) plot.plotLayout()->addElement(row, 0, rect);
  for (QCPAxis* axis : rect->axes()) {
    axis->setLayer(QStringLiteral("axes"));
    axis->grid()->setLayer(QStringLiteral("grid"));
  }
  double highest = 0.0;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const double shift =
        kApart * fastest * (static_cast<double>(i) - 0.5 * static_cast<double>(panel.series.size() - 1));
    addSeries(*rect, panel.series[i], i, shift, row == 0);
    for (const AtSpeed& point : panel.series[i].points) highest = std::max(highest, point.high);
  }
  rect->axis(QCPAxis::atBottom)->setLabel(QStringLiteral("Speed asked for [cm/s]"));
  rect->axis(QCPAxis::atLeft)->setLabel(QString::fromStdString(panel.label));
  rect->axis(QCPAxis::atBottom)->setRange(0.0, 1.08 * fastest);
  rect->axis(QCPAxis::atLeft)->setRange(highest > 0.0 ? -0.03 * highest : -0.1, highest > 0.0 ? 1.08 * highest : 1.0);
}

}  // namespace

Result<void> saveSpeedChart(const std::string& title, const std::vector<SpeedPanel>& panels, const QString& file) {
  QCustomPlot plot;
  plot.setAntialiasedElements(QCP::aeAll);
  double fastest = 0.0;
  for (const SpeedPanel& panel : panels)
    for (const SpeedSeries& series : panel.series)
      for (const AtSpeed& point : series.points) fastest = std::max(fastest, point.speed);
  QCPMarginGroup margins{&plot};
  for (std::size_t i = 0; i < panels.size(); ++i) addPanel(plot, panels[i], static_cast<int>(i), fastest);
  for (QCPAxisRect* rect : plot.axisRects()) rect->setMarginGroup(QCP::msLeft | QCP::msRight, &margins);
  addChartTitle(plot, title);
  putLegendBelow(plot, 3);
  return saveChart(plot, file, kRoom + kPanelHeight * static_cast<int>(panels.size()));
}

}  // namespace tessera::ui
