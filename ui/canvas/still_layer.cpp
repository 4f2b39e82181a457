#include "ui/canvas/still_layer.h"

#include <QPainter>
#include <cmath>
#include <cstring>

namespace tessera::ui {
namespace {

constexpr double kMargin = 128.0;  // logical pixels; whole device pixels at every usual ratio

QPoint onDevicePixels(QPointF logical, double ratio) {
  return {static_cast<int>(std::lround(logical.x() * ratio)), static_cast<int>(std::lround(logical.y() * ratio))};
}

// Moves the picture's content; what comes in from outside is left as it was, to be drawn over.
void scroll(QImage& image, QPoint by) {
  const int width = image.width() - std::abs(by.x());
  const int height = image.height() - std::abs(by.y());
  const int fromX = std::max(0, -by.x());
  const int toX = std::max(0, by.x());
  const auto bytes = static_cast<std::size_t>(width) * 4;
  for (int n = 0; n < height; ++n) {
    const int row = by.y() > 0 ? height - 1 - n : n - std::min(0, by.y());
    std::memmove(image.scanLine(row + by.y()) + 4 * toX, image.constScanLine(row) + 4 * fromX, bytes);
  }
}

}  // namespace

void StillLayer::prepare(const View& view, const FloorScene& scene, const CanvasTheme& theme) {
  View wanted = view;
  wanted.resize(view.size() + QSizeF{2 * kMargin, 2 * kMargin}, view.devicePixelRatio());
  const double ratio = view.devicePixelRatio();
  const bool usable = !picture_.isNull() && view_.size() == wanted.size() && view_.devicePixelRatio() == ratio &&
                      view_.scale() == view.scale();
  const QPointF origin = view_.toPixel({}) - view.toPixel({});
  if (usable && std::abs(origin.x() - kMargin) <= kMargin && std::abs(origin.y() - kMargin) <= kMargin) {
    corner_ = onDevicePixels(origin, ratio);
    return;
  }
  const QPoint by = onDevicePixels(wanted.toPixel({}) - view_.toPixel({}), ratio);
  if (usable && std::abs(by.x()) < picture_.width() / 2 && std::abs(by.y()) < picture_.height() / 2) {
    shift(by, wanted, scene, theme);
  } else {
    const QSize size{static_cast<int>(std::ceil(wanted.size().width() * ratio)),
                     static_cast<int>(std::ceil(wanted.size().height() * ratio))};
    if (picture_.size() != size) picture_ = QImage{size, QImage::Format_RGB32};
    picture_.setDevicePixelRatio(ratio);
    paintFloor(picture_, wanted, scene, theme, picture_.rect());
    ++redraws_;
  }
  view_ = wanted;
  corner_ = onDevicePixels(view_.toPixel({}) - view.toPixel({}), ratio);
}

void StillLayer::shift(QPoint by, const View& to, const FloorScene& scene, const CanvasTheme& theme) {
  scroll(picture_, by);
  const int width = picture_.width();
  const int height = picture_.height();
  if (by.x() != 0) {
    const QRect strip{by.x() > 0 ? 0 : width + by.x(), 0, std::abs(by.x()), height};
    paintFloor(picture_, to, scene, theme, strip);
  }
  if (by.y() != 0) {
    const QRect strip{0, by.y() > 0 ? 0 : height + by.y(), width, std::abs(by.y())};
    paintFloor(picture_, to, scene, theme, strip);
  }
}

void StillLayer::blit(QPainter& painter, const QRect& rect) const {
  if (picture_.isNull()) return;
  const double ratio = picture_.devicePixelRatio();
  // Whole device pixels around the rectangle, so that fractional ratios do not blur.
  const QRectF source{std::floor(rect.left() * ratio) + corner_.x(), std::floor(rect.top() * ratio) + corner_.y(),
                      std::ceil(rect.width() * ratio) + 1, std::ceil(rect.height() * ratio) + 1};
  const QPointF at{std::floor(rect.left() * ratio) / ratio, std::floor(rect.top() * ratio) / ratio};
  painter.drawImage(at, picture_, source);
}

}  // namespace tessera::ui
