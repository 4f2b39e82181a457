// A layer of the floor, kept as a picture as long as view and appearance stay: vehicles that drive beneath cost no more
// than without it.
#pragma once

#include <QPainter>
#include <QPixmap>

#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

class LayerPicture {
public:
  /// What is drawn has changed.
  void forget() { picture_ = {}; }
  /// `draw(QPainter&)` is asked only where the picture is no longer right.
  template <class Draw>
  void paint(QPainter& painter, const View& view, const CanvasTheme& theme, Draw draw) {
    if (picture_.isNull() || !(view_ == view) || dark_ != theme.dark) {
      view_ = view;
      dark_ = theme.dark;
      picture_ = QPixmap{(view.size() * view.devicePixelRatio()).toSize()};
      picture_.setDevicePixelRatio(view.devicePixelRatio());
      picture_.fill(Qt::transparent);
      QPainter keeping{&picture_};
      draw(keeping);
    }
    painter.drawPixmap(QPointF{}, picture_);
  }

private:
  QPixmap picture_;
  View view_;
  bool dark_ = false;
};

}  // namespace tessera::ui
