// What a compass measured all around and what becomes of it: the raw points on their ellipse, the corrected ones on
// their circle about zero, both to the same scale, and which directions were met.
#pragma once

#include <QColor>
#include <QWidget>
#include <optional>
#include <vector>

#include "calibrate/compass_fit.h"

namespace tessera::ui {

class FieldChart : public QWidget {
  Q_OBJECT
public:
  explicit FieldChart(QWidget* parent = nullptr);
  /// fit: nullopt while there is none; the points then stand alone.
  void show(const std::vector<calibrate::FieldPoint>& points, const std::optional<calibrate::CompassFit>& fit);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  struct Scale;
  [[nodiscard]] Scale scaleFor(const QRectF& area) const;
  void paintAxes(QPainter& painter, const Scale& scale) const;
  void paintMeasured(QPainter& painter, const Scale& scale) const;
  void paintCorrected(QPainter& painter, const Scale& scale) const;
  void paintDirections(QPainter& painter, const Scale& scale) const;
  [[nodiscard]] double paintLegend(QPainter& painter) const;
  [[nodiscard]] QColor measuredColour() const;
  [[nodiscard]] QColor correctedColour() const;
  void retranslate();

  std::vector<calibrate::FieldPoint> points_;
  std::optional<calibrate::CompassFit> fit_;
};

}  // namespace tessera::ui
