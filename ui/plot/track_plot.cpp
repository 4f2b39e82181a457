#include "ui/plot/track_plot.h"

#include <qcustomplot.h>

#include <algorithm>

#include "ui/plot/chart_frame.h"

namespace tessera::ui {
namespace {

constexpr double kCmPerM = 100.0;

QCPCurve* addCurve(QCustomPlot& plot, const std::vector<Point>& points, const QString& name) {
  auto* curve = new QCPCurve{plot.xAxis, plot.yAxis};  // owned by the plot
  QVector<double> xs, ys;
  for (const Point& p : points) {
    xs.push_back(p.x.value() * kCmPerM);
    ys.push_back(p.y.value() * kCmPerM);
  }
  curve->setData(xs, ys);
  if (name.isEmpty()) {
    curve->removeFromLegend();
  } else {
    curve->setName(name);
  }
  return curve;
}

void addFloor(QCustomPlot& plot, const TrackPlot& content) {
  for (const auto& outline : content.tiles) {
    auto closed = outline;
    if (!closed.empty()) closed.push_back(closed.front());
    addCurve(plot, closed, {})->setPen(QPen{QColor{200, 200, 200}, 1});
  }
  auto* tags = addCurve(plot, content.tags, QStringLiteral("Tags"));
  tags->setLineStyle(QCPCurve::lsNone);
  tags->setScatterStyle(QCPScatterStyle{QCPScatterStyle::ssDisc, QColor{170, 170, 170}, 4});
}

void addTrack(QCustomPlot& plot, const TrackPlot::Track& track, std::size_t index, bool named) {
  const QColor colour = chartColour(index);
  const QString prefix = named ? QString::fromStdString(track.name) + QStringLiteral(": ") : QString{};
  addCurve(plot, track.route.vertices(), prefix + QStringLiteral("Route"))
      ->setPen(QPen{QColor{60, 60, 60}, 5, Qt::SolidLine, Qt::RoundCap});
  if (!track.truth.empty()) addCurve(plot, track.truth, prefix + QStringLiteral("True track"))->setPen(QPen{colour, 2});
  addCurve(plot, track.estimate, prefix + QStringLiteral("Estimated track"))
      ->setPen(QPen{track.truth.empty() ? colour : colour.lighter(150), 1, Qt::DashLine});
}

// Fits both axes to the content with a margin and returns the height that makes the picture true to scale.
int fitToScale(QCustomPlot& plot) {
  plot.rescaleAxes();
  const double margin = 0.05 * std::max(plot.xAxis->range().size(), plot.yAxis->range().size());
  plot.xAxis->setRange(plot.xAxis->range().lower - margin, plot.xAxis->range().upper + margin);
  plot.yAxis->setRange(plot.yAxis->range().lower - margin, plot.yAxis->range().upper + margin);
  constexpr int frame = 90;  // axes, labels, title
  const double height = (kChartWidth - frame) * plot.yAxis->range().size() / plot.xAxis->range().size();
  return static_cast<int>(std::clamp(height, 200.0, 2000.0)) + 2 * frame;
}

}  // namespace

Result<void> saveTrackPlot(const TrackPlot& content, const QString& file) {
  QCustomPlot plot;
  plot.setNotAntialiasedElements(QCP::aeNone);
  plot.setAntialiasedElements(QCP::aeAll);
  addFloor(plot, content);
  for (std::size_t i = 0; i < content.tracks.size(); ++i)
    addTrack(plot, content.tracks[i], i, content.tracks.size() > 1);
  plot.xAxis->setLabel(QStringLiteral("x [cm]"));
  plot.yAxis->setLabel(QStringLiteral("y [cm]"));
  addChartTitle(plot, content.title);
  putLegendBelow(plot, 4);
  const int height = fitToScale(plot);
  plot.resize(kChartWidth, height);
  plot.setViewport(QRect{0, 0, kChartWidth, height});
  plot.replot(QCustomPlot::rpImmediateRefresh);
  plot.xAxis->setScaleRatio(plot.yAxis, 1.0);
  plot.replot(QCustomPlot::rpImmediateRefresh);
  return saveChart(plot, file, height);
}

}  // namespace tessera::ui
