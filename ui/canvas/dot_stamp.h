// Round dots put straight into an image's pixels: a tag each, tens of thousands a frame.
#pragma once

#include <QColor>
#include <QImage>
#include <QRect>
#include <cstdint>
#include <vector>

namespace tessera::ui {

class DotStamp {
public:
  /// Radius in device pixels; ring: hollow.
  DotStamp(double radius, QColor colour, bool ring = false);

  /// `at` in device pixels of an RGB32 or premultiplied opaque image; nothing outside `clip` is touched.
  void put(QImage& image, double x, double y, const QRect& clip) const;

private:
  int size_ = 0;
  std::vector<std::uint8_t> cover_;  ///< kPhases² masks of size_², for where within a pixel the middle lies
  std::uint32_t colour_ = 0;
};

}  // namespace tessera::ui
