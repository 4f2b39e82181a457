#include "ui/canvas/floor_mip.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tessera::ui {
namespace {

// 64 MB at three bytes a cell and all levels; a floor of a million tags needs a tenth of it.
constexpr double kMostCells = 16e6;

std::uint8_t addedUp(std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::min(255.0, to + std::round(share * 255.0)));
}

QRgb mixed(QRgb from, QRgb to, int share) {
  const auto mix = [share](int a, int b) { return a + (b - a) * share / 255; };
  return qRgb(mix(qRed(from), qRed(to)), mix(qGreen(from), qGreen(to)), mix(qBlue(from), qBlue(to)));
}

}  // namespace

FloorMip::FloorMip(const FloorIndex& floor) : cell_{floor.pitch()} {
  if (floor.box().empty()) return;
  // Cells begin where the first tile does: then each holds one place of a usual floor, in its middle.
  const SiteBox& box = floor.box();
  const Point anchor = floor.tiles().empty() ? box.low : floor.tiles().front().box.low;
  const double area = std::max(box.width().value(), 0.1) * std::max(box.height().value(), 0.1);
  while (area / (cell_.value() * cell_.value()) > kMostCells) cell_ *= 2.0;
  const double size = cell_.value();
  // By sixteens, so that tiles' edges fall on those of the coarser cells as well.
  const Metres block = 16.0 * cell_;
  low_ = {anchor.x - std::ceil((anchor.x - box.low.x) / block - 1e-9) * block,
          anchor.y - std::ceil((anchor.y - box.low.y) / block - 1e-9) * block};
  Level level;
  level.columns = static_cast<std::size_t>((box.high.x - low_.x) / cell_) + 2;
  level.rows = static_cast<std::size_t>((box.high.y - low_.y) / cell_) + 2;
  level.cells.resize(level.columns * level.rows);
  const double usual = floor.pitch().value() / size;
  const double weight = std::min(1.0, usual * usual);
  const auto at = [&](Point p) -> Cell& {
    const auto column = static_cast<std::size_t>(std::max(0.0, (p.x - low_.x) / cell_));
    const auto row = static_cast<std::size_t>(std::max(0.0, (p.y - low_.y) / cell_));
    return level.cells[std::min(row, level.rows - 1) * level.columns + std::min(column, level.columns - 1)];
  };
  for (const FloorIndex::Tile& tile : floor.tiles()) {
    const double left = std::max(0.0, (tile.box.low.x - low_.x) / cell_);
    const double right = (tile.box.high.x - low_.x) / cell_;
    const double bottom = std::max(0.0, (tile.box.low.y - low_.y) / cell_);
    const double top = (tile.box.high.y - low_.y) / cell_;
    for (auto row = static_cast<std::size_t>(bottom); row < level.rows && static_cast<double>(row) < top; ++row) {
      const double high = std::min(top, static_cast<double>(row) + 1) - std::max(bottom, static_cast<double>(row));
      for (auto c = static_cast<std::size_t>(left); c < level.columns && static_cast<double>(c) < right; ++c) {
        const double wide = std::min(right, static_cast<double>(c) + 1) - std::max(left, static_cast<double>(c));
        Cell& cell = level.cells[row * level.columns + c];
        cell.floor = addedUp(cell.floor, high * wide);
      }
    }
    const std::vector<Offset>& offsets = floor.offsetsOf(tile.shape);
    for (std::size_t n = 0; n < offsets.size(); ++n) {
      Cell& cell = at(tile.origin + offsets[n]);
      auto& channel = floor.isRegistered(tile.firstPlace + n) ? cell.tags : cell.missing;
      channel = addedUp(channel, weight);
    }
  }
  for (const FloorIndex::Loose& tag : floor.loose()) {
    Cell& cell = at(tag.place);
    cell.tags = addedUp(cell.tags, weight);
  }
  levels_.push_back(std::move(level));
  while (levels_.back().columns > 2 && levels_.back().rows > 2 && levels_.size() < 24)
    levels_.push_back(halved(levels_.back()));
}

FloorMip::Level FloorMip::halved(const Level& from) {
  Level to;
  to.columns = (from.columns + 1) / 2;
  to.rows = (from.rows + 1) / 2;
  to.cells.resize(to.columns * to.rows);
  for (std::size_t row = 0; row < to.rows; ++row) {
    for (std::size_t column = 0; column < to.columns; ++column) {
      unsigned floor = 0;
      unsigned tags = 0;
      unsigned missing = 0;
      for (std::size_t y = 2 * row; y < std::min(2 * row + 2, from.rows); ++y) {
        for (std::size_t x = 2 * column; x < std::min(2 * column + 2, from.columns); ++x) {
          const Cell& cell = from.cells[y * from.columns + x];
          floor += cell.floor;
          tags += cell.tags;
          missing += cell.missing;
        }
      }
      to.cells[row * to.columns + column] = {static_cast<std::uint8_t>((floor + 2) / 4),
                                             static_cast<std::uint8_t>((tags + 2) / 4),
                                             static_cast<std::uint8_t>((missing + 2) / 4)};
    }
  }
  return to;
}

FloorMip::Picture FloorMip::picture(const SiteBox& box, double pixelsPerMetre, const CanvasTheme& theme) const {
  if (levels_.empty() || box.empty()) return {};
  // Not the finest level: its one-in-two pattern would beat with the pixels.
  std::size_t chosen = std::min<std::size_t>(1, levels_.size() - 1);
  while (chosen + 1 < levels_.size() && cellSize(chosen).value() * pixelsPerMetre < 1.25) ++chosen;
  const Level& level = levels_[chosen];
  const Metres size = cellSize(chosen);
  const auto span = [&](Metres from, Metres to, Metres origin, std::size_t count) {
    const double first = std::floor((from - origin) / size);
    const double last = std::floor((to - origin) / size);
    const double most = static_cast<double>(count);
    return std::pair{static_cast<int>(std::clamp(first, 0.0, most)), static_cast<int>(std::clamp(last + 1, 0.0, most))};
  };
  const auto [left, right] = span(box.low.x, box.high.x, low_.x, level.columns);
  const auto [bottom, top] = span(box.low.y, box.high.y, low_.y, level.rows);
  if (left >= right || bottom >= top) return {};

  // Colour by tags and missing ones, 32 steps each: pictures of millions of cells need a look-up, not a mixture.
  std::array<QRgb, 32 * 32> colours{};
  for (int tags = 0; tags < 32; ++tags) {
    for (int missing = 0; missing < 32; ++missing) {
      const QRgb tagged = mixed(theme.tile.rgb(), theme.tag.rgb(), tags * 255 / (31 * 4));
      colours[static_cast<std::size_t>(missing * 32 + tags)] =
          mixed(tagged, theme.missingTag.rgb(), std::min(255, missing * 255 * 6 / (31 * 8)));
    }
  }
  Picture picture;
  picture.image = QImage{right - left, top - bottom, QImage::Format_ARGB32_Premultiplied};
  for (int row = bottom; row < top; ++row) {
    auto* line = reinterpret_cast<QRgb*>(picture.image.scanLine(top - 1 - row));
    const Cell* cell = &level.cells[static_cast<std::size_t>(row) * level.columns + static_cast<std::size_t>(left)];
    for (int column = left; column < right; ++column, ++cell) {
      const QRgb colour = colours[static_cast<std::size_t>((cell->missing >> 3) * 32 + (cell->tags >> 3))];
      // Loose tags lie on no tile: they colour the cell by themselves.
      const int alpha = std::max<int>(cell->floor, std::min(255, cell->tags * 2));
      line[column - left] = alpha == 255 ? colour : qPremultiply((colour & 0x00FFFFFFU) | (unsigned(alpha) << 24U));
    }
  }
  picture.box.add(low_ + Offset{static_cast<double>(left) * size, static_cast<double>(bottom) * size});
  picture.box.add(low_ + Offset{static_cast<double>(right) * size, static_cast<double>(top) * size});
  return picture;
}

}  // namespace tessera::ui
