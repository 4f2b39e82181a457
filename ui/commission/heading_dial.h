// A compass rose with the direction in which the vehicle's nose points.
#pragma once

#include <QWidget>
#include <optional>

#include "base/units.h"

namespace tessera::ui {

class HeadingDial : public QWidget {
  Q_OBJECT
public:
  explicit HeadingDial(QWidget* parent = nullptr);
  /// Clockwise from north; nullopt: not known, no needle.
  void setBearing(std::optional<Radians> bearing);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  std::optional<Radians> bearing_;
};

}  // namespace tessera::ui
