// The tiles of a floor by place, flat and ready to be drawn: found by rectangle in time that grows with what is found.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "floor/site_map.h"
#include "ui/canvas/site_box.h"

namespace tessera::ui {

class FloorIndex {
public:
  struct Tile {
    SiteBox box;
    Point origin;              ///< of its offsets, after turning
    std::uint32_t shape;       ///< offsetsOf(shape): its places
    std::uint32_t firstPlace;  ///< isRegistered(firstPlace + n)
    std::uint32_t serial;
  };
  struct Loose {
    Point place;
  };

  /// Tiles that the map could not know (it refuses such sites) are left out.
  explicit FloorIndex(const floor::Site& site);

  [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }
  [[nodiscard]] const std::vector<Loose>& loose() const { return loose_; }
  [[nodiscard]] const std::vector<Offset>& offsetsOf(std::uint32_t shape) const { return shapes_[shape]; }
  [[nodiscard]] bool isRegistered(std::size_t place) const { return registered_[place]; }
  [[nodiscard]] const std::string& serial(const Tile& tile) const { return serials_[tile.serial]; }
  /// Of tiles and loose tags.
  [[nodiscard]] const SiteBox& box() const { return box_; }
  /// The closest that neighbouring places lie; 0.15 m when no tile says it.
  [[nodiscard]] Metres pitch() const { return pitch_; }
  [[nodiscard]] Metres smallestTile() const { return smallestTile_; }

  /// Calls visit(const Tile&) for each tile that touches the box, in a fixed order.
  template <class Visit>
  void forEachTile(const SiteBox& box, Visit&& visit) const {
    if (tiles_.empty() || box.empty()) return;
    // A tile is filed under its lower left corner; one that reaches in from outside begins at most its size before.
    const std::size_t left = column(box.low.x.value() - largest_);
    const std::size_t right = column(box.high.x.value());
    const std::size_t top = row(box.high.y.value());
    for (std::size_t r = row(box.low.y.value() - largest_); r <= top; ++r) {
      for (std::size_t i = cellStart_[r * columns_ + left]; i < cellStart_[r * columns_ + right + 1]; ++i) {
        if (tiles_[i].box.touches(box)) visit(tiles_[i]);
      }
    }
  }

private:
  void sortIntoCells();
  [[nodiscard]] std::size_t column(double x) const { return cell((x - left_) / cellSize_, columns_); }
  [[nodiscard]] std::size_t row(double y) const { return cell((y - bottom_) / cellSize_, rows_); }
  [[nodiscard]] static std::size_t cell(double at, std::size_t count) {
    if (!(at > 0.0)) return 0;
    return at >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(at);
  }

  std::vector<Tile> tiles_;
  std::vector<Loose> loose_;
  std::vector<std::vector<Offset>> shapes_;
  std::vector<bool> registered_;
  std::vector<std::string> serials_;
  SiteBox box_;
  Metres pitch_{0.15};
  Metres smallestTile_{0.6};
  double largest_ = 0.0;
  double left_ = 0.0;
  double bottom_ = 0.0;
  double cellSize_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> cellStart_;
};

/// Whether both sites have the same tiles at the same places with the same tags: an edit of routes, not another floor.
[[nodiscard]] bool sameFloor(const floor::Site& a, const floor::Site& b);

}  // namespace tessera::ui
