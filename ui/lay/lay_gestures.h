// What the lay tool is in the middle of: values that know no mouse and change no document.
#pragma once

#include <QPointF>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "ui/lay/lay_edits.h"

namespace tessera::ui {

/// Tiles as they were copied, from the lower left corner of them all; their types come along to another site.
struct TileStamp {
  std::vector<floor::TileType> types;
  std::vector<NewTile> tiles;
  Offset size;

  [[nodiscard]] const floor::TileType& typeOf(const NewTile& tile) const;
  /// Of a tile when the stamp lies at `low`.
  [[nodiscard]] Box boxOf(const NewTile& tile, Point low) const;
  void turn();
};

/// The laid tiles of these serial numbers, in the site's order.
[[nodiscard]] TileStamp stampOf(const floor::Site& site, const TileSet& tiles);

/// A cell of the lattice that begins where the first tile of a gesture lies.
struct LayCell {
  int column = 0;
  int row = 0;
  bool operator==(const LayCell&) const = default;
};

/// The lattice along which tiles are painted or filled in: fixed by the first one.
struct LayLattice {
  Point first;  ///< its lower left corner
  Offset size;

  [[nodiscard]] LayCell cellAt(Point place) const;
  [[nodiscard]] Box boxOf(LayCell cell) const;
};

/// Painting: every free cell that the mouse came over, once.
class LayStroke {
public:
  explicit LayStroke(const LayLattice& lattice) : lattice_{lattice} {}
  /// Takes the cells on the way from the last one, so that a quick hand leaves none out.
  void goTo(LayCell cell, const FloorIndex& floor);
  [[nodiscard]] const LayLattice& lattice() const { return lattice_; }
  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

private:
  void visit(LayCell cell, const FloorIndex& floor);

  LayLattice lattice_;
  bool begun_ = false;
  LayCell at_;
  std::unordered_set<std::uint64_t> seen_;
  std::vector<Box> boxes_;
};

/// Filling a rectangle from the lattice's first cell to another.
struct LayFill {
  static constexpr std::int64_t kMostCells = 100'000;

  LayLattice lattice;
  LayCell to;

  [[nodiscard]] int columns() const { return std::abs(to.column) + 1; }
  [[nodiscard]] int rows() const { return std::abs(to.row) + 1; }
  [[nodiscard]] bool tooMany() const { return static_cast<std::int64_t>(columns()) * rows() > kMostCells; }
  [[nodiscard]] Box box() const;
  /// Cells of the rectangle that lie in `within` and are free, row by row from the lower left.
  [[nodiscard]] std::vector<Box> freeBoxes(const FloorIndex& floor, const Box& within) const;
};

/// Choosing what a rectangle touches.
struct LayBand {
  QPointF from;
  QPointF to;
  TileSet before;  ///< chosen when it began, and staying so
};

/// Moving the chosen tiles.
struct LayDrag {
  std::string grabbed;  ///< the tile under the mouse
  Box grabbedBox;
  std::vector<Box> boxes;  ///< of all of them, where they lie
  QPointF pressed;
  Point from;  ///< where the mouse was
  Offset by;
  bool moved = false;
  bool free = true;
};

using LayGesture = std::variant<std::monostate, LayStroke, LayFill, LayBand, LayDrag>;

}  // namespace tessera::ui
