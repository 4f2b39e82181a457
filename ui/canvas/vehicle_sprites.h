// Small vehicles, their labels and the flashes of reads as ready pictures: a hundred of each are put down in the time
// in which a painter fills a few dozen shapes. Large vehicles, of which few fit into a window, are drawn as they are.
// While the scale changes from frame to frame, pictures of another scale stand in for those that there is no time for.
#pragma once

#include <QHash>
#include <QPixmap>
#include <vector>

#include "ui/canvas/vehicle_painter.h"

namespace tessera::ui {

class VehicleSprites {
public:
  /// Of another look of the canvas: colours, font, footprints.
  void clear();
  /// Before each painting: what is put down has this scale, and new pictures are made for some milliseconds, or all
  /// that are needed.
  void begin(const View& view, bool all);
  /// Pictures of another scale were used, or small things left out: another painting is needed.
  [[nodiscard]] bool isPending() const { return pending_; }
  void paintBody(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
  void paintGhost(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
  void paintDoubt(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
  void paintLabel(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
  void paintFlash(QPainter& painter, const View& view, Point place, QColor colour, double age);

private:
  enum class Kind : quint64 { Body, Ghost, Doubt, Flash };

  struct Picture {
    QPixmap pixmap;
    double scale;  ///< pixels per metre that it was drawn for
  };

  [[nodiscard]] quint64 shapeOf(const VehicleMark& mark);
  /// Nullptr: there is no time for it in this painting.
  template <class Draw>
  const Picture* made(quint64 key, bool needed, QSizeF size, Draw draw);
  template <class Draw>
  bool paintTurned(QPainter& painter, const View& view, Kind kind, const VehicleMark& mark, const Pose& at, Draw draw);

  QHash<quint64, Picture> pictures_;
  QHash<QString, QPixmap> labels_;
  std::vector<std::vector<Point>> shapes_;  ///< footprints seen so far: vehicles of one type share their pictures
  qsizetype bytes_ = 0;
  double scale_ = 0.0;
  double ratio_ = 0.0;
  qint64 made_ = 0;  ///< nanoseconds that this painting has spent on new pictures
  bool all_ = false;
  bool pending_ = false;
};

}  // namespace tessera::ui
