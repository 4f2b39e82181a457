// A floor seen from far: how much of each cell is tile, how many tags it has and how many are missing, halved level by
// level, so that a million tags cost no more to draw than the window has pixels.
#pragma once

#include <QImage>
#include <QRectF>
#include <cstdint>
#include <vector>

#include "ui/canvas/floor_index.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

class FloorMip {
public:
  explicit FloorMip(const FloorIndex& floor);

  struct Picture {
    QImage image;  ///< premultiplied, one pixel a cell; null when nothing is in view
    SiteBox box;   ///< what the image covers
  };
  /// Cells of at least about `1.25` pixels that touch the box.
  [[nodiscard]] Picture picture(const SiteBox& box, double pixelsPerMetre, const CanvasTheme& theme) const;

  [[nodiscard]] std::size_t levels() const { return levels_.size(); }
  [[nodiscard]] Metres cellSize(std::size_t level) const { return cell_ * static_cast<double>(1U << level); }

private:
  struct Cell {
    std::uint8_t floor = 0;    ///< covered by tiles, 255 = all
    std::uint8_t tags = 0;     ///< 255 = as many as a full pattern has
    std::uint8_t missing = 0;  ///< the same for places without a registered tag
  };
  struct Level {
    std::size_t columns = 0;
    std::size_t rows = 0;  ///< from below
    std::vector<Cell> cells;
  };
  static Level halved(const Level& from);

  Point low_;
  Metres cell_;
  std::vector<Level> levels_;
};

}  // namespace tessera::ui
