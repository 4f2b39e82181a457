// Small vehicles, their labels and the flashes of reads as ready pictures: a hundred of each are put down in the time
// in which a painter fills a few dozen shapes. Large vehicles, of which few fit into a window, are drawn as they are.
#pragma once

#include <QHash>
#include <QPixmap>

#include "ui/canvas/vehicle_painter.h"

namespace tessera::ui {

class VehicleSprites {
public:
  /// Of another look of the canvas: colours, font.
  void clear();
  void paintBody(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
  void paintLabel(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
  void paintFlash(QPainter& painter, const View& view, Point place, QColor colour, double age);

private:
  void useScale(const View& view);
  template <class Draw>
  const QPixmap& made(quint64 key, QSizeF size, double ratio, Draw draw);

  QHash<quint64, QPixmap> bodies_;
  QHash<QString, QPixmap> labels_;
  double scale_ = 0.0;
  double ratio_ = 0.0;
};

}  // namespace tessera::ui
