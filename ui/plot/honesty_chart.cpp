#include <qcustomplot.h>

#include <algorithm>

#include "ui/plot/chart_frame.h"
#include "ui/plot/run_charts.h"

namespace tessera::ui {
namespace {

constexpr int kHonestyChartHeight = 560;
constexpr double kHonest = 2.0;  // a place has two coordinates

bool within(const RunHonesty& run) { return run.low <= run.mean && run.mean <= run.high; }

// Marks of the runs that lie within their bounds, or of those that do not.
void addMarks(QCustomPlot& plot, const std::vector<RunHonesty>& runs, bool inside) {
  QVector<double> at, mean;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (within(runs[i]) != inside) continue;
    at.push_back(static_cast<double>(i + 1));
    mean.push_back(runs[i].mean);
  }
  auto* graph = plot.addGraph();  // owned by the plot
  graph->setData(at, mean, true);
  graph->setLineStyle(QCPGraph::lsNone);
  const QColor colour = chartColour(inside ? 0 : 1);
  QCPScatterStyle mark{inside ? QCPScatterStyle::ssDisc : QCPScatterStyle::ssCross, colour, inside ? 6.0 : 9.0};
  mark.setPen(QPen{colour, 2});
  graph->setScatterStyle(mark);
  graph->setPen(QPen{colour, 2});
  graph->setName(
      QStringLiteral("Run %1 them: %2 of %3").arg(inside ? "within" : "outside").arg(at.size()).arg(runs.size()));
}

void addBounds(QCustomPlot& plot, const std::vector<RunHonesty>& runs) {
  QVector<double> at, middle, half;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    at.push_back(static_cast<double>(i + 1));
    middle.push_back((runs[i].low + runs[i].high) / 2);
    half.push_back((runs[i].high - runs[i].low) / 2);
  }
  auto* graph = plot.addGraph();
  graph->setData(at, middle, true);
  graph->setLineStyle(QCPGraph::lsNone);
  graph->removeFromLegend();
  auto* bars = new QCPErrorBars{plot.xAxis, plot.yAxis};
  bars->setData(half);
  bars->setDataPlottable(graph);
  bars->setSymbolGap(0);
  bars->setPen(QPen{QColor{170, 170, 170}, 2});
  bars->setName(QStringLiteral("Bounds that hold 95 of 100 runs of an honest locator"));
}

void addLine(QCustomPlot& plot, double x0, double y0, double x1, double y1, const QPen& pen) {
  auto* line = new QCPItemLine{&plot};
  line->start->setCoords(x0, y0);
  line->end->setCoords(x1, y1);
  line->setPen(pen);
}

}  // namespace

Result<void> saveHonestyChart(const std::string& title, const std::vector<HonestySeries>& series, const QString& file) {
  QCustomPlot plot;
  plot.setAntialiasedElements(QCP::aeAll);
  std::vector<RunHonesty> runs;
  for (const HonestySeries& one : series) runs.insert(runs.end(), one.runs.begin(), one.runs.end());
  double top = 2 * kHonest;
  for (const RunHonesty& run : runs) top = std::max({top, run.mean, run.high});
  top *= 1.15;
  const double end = static_cast<double>(runs.size()) + 0.5;
  plot.xAxis->setRange(0.5, end);
  plot.yAxis->setRange(0.0, top);
  addBounds(plot, runs);
  addMarks(plot, runs, true);
  addMarks(plot, runs, false);
  addLine(plot, 0.5, kHonest, end, kHonest, QPen{Qt::black, 1, Qt::DashLine});
  double from = 0.5;
  for (const HonestySeries& one : series) {
    const double to = from + static_cast<double>(one.runs.size());
    if (to < end) addLine(plot, to, 0.0, to, top, QPen{QColor{120, 120, 120}, 1});
    auto* text = new QCPItemText{&plot};
    text->setPositionAlignment(Qt::AlignHCenter | Qt::AlignTop);
    text->position->setCoords((from + to) / 2, 0.99 * top);
    text->setText(QString::fromStdString(one.name));
    from = to;
  }
  plot.xAxis->setLabel(QStringLiteral("Run"));
  plot.yAxis->setLabel(QStringLiteral("Mean NEES of the run (2 is honest)"));
  addChartTitle(plot, title);
  putLegendBelow(plot, 3);
  return saveChart(plot, file, kHonestyChartHeight);
}

}  // namespace tessera::ui
