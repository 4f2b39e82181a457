// Cross-track error and speed over the last minutes, one above the other on the same time.
#pragma once

#include <QSharedPointer>

#include "ui/charts/drive_samples.h"
#include "ui/charts/plot_look.h"

namespace tessera::ui {

class AgoTicker;

class TimeChart : public QCustomPlot {
  Q_OBJECT
public:
  static constexpr double kBand = 5.0;  ///< cm: the accuracy that the publication promises

  explicit TimeChart(QWidget* parent = nullptr);

  /// The last `span` seconds before `until`.
  void setSamples(const std::vector<DriveSample>& samples, double until, double span);
  void dress(const QPalette& palette, const QFont& font, const QColor& vehicle);
  void retranslate();
  void setByHand(bool byHand);

private:
  void resizeEvent(QResizeEvent* event) override;
  void arrange();
  void buildBand();
  void buildCrosshair();
  void fitTicks();
  void tip(QMouseEvent* event);
  void hideTip();
  [[nodiscard]] QString valuesAt(const DriveSample& sample) const;

  QCPAxisRect* error_;
  QCPAxisRect* pace_;
  QCPGraph* crossTrack_;
  QCPGraph* commanded_;
  QCPGraph* reported_;
  QCPLegend* paceLegend_;
  QCPLayoutGrid* heading_ = nullptr;  ///< of the speeds: title and legend
  bool low_ = false;                  ///< the two lie side by side
  QCPTextElement* errorTitle_;
  QCPTextElement* paceTitle_;
  QCPItemRect* band_ = nullptr;
  QCPItemText* bandName_ = nullptr;
  QCPItemLine* errorHair_ = nullptr;
  QCPItemLine* paceHair_ = nullptr;
  QSharedPointer<AgoTicker> ticker_;
  std::vector<DriveSample> samples_;
  double until_ = 0.0;
};

}  // namespace tessera::ui
