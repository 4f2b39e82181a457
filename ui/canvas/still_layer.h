// The floor as a picture that is kept: larger than the window, so that panning shifts it and only what comes into view
// is drawn.
#pragma once

#include <QImage>

#include "ui/canvas/floor_painter.h"

namespace tessera::ui {

class StillLayer {
public:
  /// Something other than the view is different; the whole picture is drawn again when it is next needed.
  void invalidate() { picture_ = QImage{}; }
  /// Brings the picture up to date with the view.
  void prepare(const View& view, const FloorScene& scene, const CanvasTheme& theme);
  /// Puts the part of it that the rectangle (logical pixels of the window) shows.
  void blit(QPainter& painter, const QRect& rect) const;
  /// How often the whole picture was drawn, for tests and benchmarks.
  [[nodiscard]] int redraws() const { return redraws_; }

private:
  void shift(QPoint by, const View& to, const FloorScene& scene, const CanvasTheme& theme);

  QImage picture_;
  View view_;      ///< of the picture
  QPoint corner_;  ///< of the window within the picture, device pixels
  int redraws_ = 0;
};

}  // namespace tessera::ui
