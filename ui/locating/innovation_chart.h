// How well reads fit what was believed: each read's normalised innovation squared (NIS), its running mean, and the
// bounds in which that mean lies when the locator's doubt is honest.
#pragma once

#include <QSharedPointer>

#include "ui/charts/plot_look.h"
#include "ui/locating/locating_record.h"

namespace tessera::ui {

class AgoTicker;

class InnovationChart : public QCustomPlot {
  Q_OBJECT
public:
  static constexpr double kSpan = 60.0;  ///< s

  explicit InnovationChart(QWidget* parent = nullptr);

  void show(const LocatingRecord& record);
  void dress(const QPalette& palette, const QFont& font, const QColor& vehicle);
  void retranslate();
  /// Points and values on show, for tests and other readers of the screen.
  [[nodiscard]] int readCount() const { return reads_->dataCount(); }

private:
  QCPGraph* reads_;
  QCPGraph* mean_;
  QCPItemRect* band_;
  QSharedPointer<AgoTicker> ticker_;
};

}  // namespace tessera::ui
