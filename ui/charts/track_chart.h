// Where the vehicle went against where it should: both to scale, a metre as long upwards as sideways.
#pragma once

#include "base/pose.h"
#include "ui/charts/drive_samples.h"
#include "ui/charts/plot_look.h"

namespace tessera::ui {

class TrackChart : public QCustomPlot {
  Q_OBJECT
public:
  explicit TrackChart(QWidget* parent = nullptr);

  void setRoute(const QString& name, const std::vector<Point>& vertices);
  void setTrack(const std::vector<DriveSample>& samples);
  void dress(const QPalette& palette, const QFont& font, const QColor& vehicle);
  void retranslate();
  /// By hand: dragged and zoomed with the mouse, and not moved by new data.
  void setByHand(bool byHand);
  /// To scale in another size than the widget's, for a picture of it.
  void layOutFor(const QSize& size);

private:
  void fitToScale();
  void tip(QMouseEvent* event);

  QCPCurve* route_;
  QCPCurve* track_;
  QCPGraph* vehicle_;
  QString routeName_;
  QColor colour_;
  double heading_ = 0.0;
  QCPRange wantedX_;  ///< what shall be seen; the scale makes more of one of them
  QCPRange wantedY_;
  bool byHand_ = false;
};

}  // namespace tessera::ui
