// A vehicle seen from above, to scale: outline, wheels and axes, readers with the discs in which they see a tag.
#pragma once

#include <QWidget>

#include "floor/site.h"

namespace tessera::ui {

class VehiclePreview : public QWidget {
  Q_OBJECT
public:
  explicit VehiclePreview(QWidget* parent = nullptr);
  void setVehicle(const floor::VehicleSetup& vehicle);
  /// Bit i: reader i is drawn alight.
  void setAlight(unsigned readers);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void drawBody(QPainter& painter) const;
  void drawReaders(QPainter& painter) const;

  floor::VehicleSetup vehicle_;
  unsigned alight_ = 0;
};

}  // namespace tessera::ui
