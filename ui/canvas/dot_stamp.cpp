#include "ui/canvas/dot_stamp.h"

#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr int kPhases = 4;

double discCover(double distance, double radius) { return std::clamp(radius - distance + 0.5, 0.0, 1.0); }

}  // namespace

DotStamp::DotStamp(double radius, QColor colour, bool ring) : colour_{colour.rgb()} {
  size_ = 2 * static_cast<int>(std::ceil(radius + 1.0)) + 1;
  const double middle = size_ / 2;
  cover_.resize(static_cast<std::size_t>(kPhases * kPhases * size_ * size_));
  auto* to = cover_.data();
  const double inner = ring ? radius - std::max(1.0, radius * 0.4) : -1.0;
  // A dot smaller than a pixel is paler, not larger.
  const double strength = radius < 0.5 ? std::max(0.35, 4 * radius * radius) : 1.0;
  for (int phaseY = 0; phaseY < kPhases; ++phaseY) {
    for (int phaseX = 0; phaseX < kPhases; ++phaseX) {
      const double x0 = middle + (phaseX + 0.5) / kPhases;
      const double y0 = middle + (phaseY + 0.5) / kPhases;
      for (int y = 0; y < size_; ++y) {
        for (int x = 0; x < size_; ++x) {
          const double distance = std::hypot(x + 0.5 - x0, y + 0.5 - y0);
          double cover = discCover(distance, std::max(radius, 0.5));
          if (ring && inner > 0.3) cover -= discCover(distance, inner);
          *to++ = static_cast<std::uint8_t>(std::clamp(cover * strength, 0.0, 1.0) * 255.0 + 0.5);
        }
      }
    }
  }
}

void DotStamp::put(QImage& image, double x, double y, const QRect& clip) const {
  const double floorX = std::floor(x);
  const double floorY = std::floor(y);
  const int left = static_cast<int>(floorX) - size_ / 2;
  const int top = static_cast<int>(floorY) - size_ / 2;
  const int fromX = std::max(left, clip.left());
  const int toX = std::min(left + size_, clip.right() + 1);
  const int fromY = std::max(top, clip.top());
  const int toY = std::min(top + size_, clip.bottom() + 1);
  if (fromX >= toX || fromY >= toY) return;
  const int phase = static_cast<int>((y - floorY) * kPhases) * kPhases + static_cast<int>((x - floorX) * kPhases);
  const std::uint8_t* mask = cover_.data() + static_cast<std::ptrdiff_t>(phase) * size_ * size_;
  const std::uint32_t redBlue = colour_ & 0xFF00FFU;
  const std::uint32_t green = colour_ & 0x00FF00U;
  for (int row = fromY; row < toY; ++row) {
    auto* line = reinterpret_cast<std::uint32_t*>(image.scanLine(row));
    const std::uint8_t* cover = mask + static_cast<std::ptrdiff_t>(row - top) * size_ - left;
    for (int column = fromX; column < toX; ++column) {
      const std::uint32_t a = cover[column] + (cover[column] >> 7U);  // 0 to 256
      if (a == 0) continue;
      const std::uint32_t under = line[column];
      const std::uint32_t rb = ((under & 0xFF00FFU) * (256 - a) + redBlue * a) >> 8U;
      const std::uint32_t g = ((under & 0x00FF00U) * (256 - a) + green * a) >> 8U;
      line[column] = 0xFF000000U | (rb & 0xFF00FFU) | (g & 0x00FF00U);
    }
  }
}

}  // namespace tessera::ui
