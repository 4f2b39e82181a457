// What a panel shows upon the floor beside what the canvas itself knows; live, over the vehicles' bodies.
#pragma once

#include <QPainter>
#include <QRegion>

#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

class CanvasOverlay {
public:
  virtual ~CanvasOverlay() = default;
  virtual void paint(QPainter& painter, const View& view, const CanvasTheme& theme) = 0;
  /// Where it paints, in pixels.
  [[nodiscard]] virtual QRegion extent(const View& view, const QFont& font) const = 0;
};

}  // namespace tessera::ui
