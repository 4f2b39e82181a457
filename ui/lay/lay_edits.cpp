#include "ui/lay/lay_edits.h"

#include <algorithm>
#include <cmath>

#include "floor/laid_tile.h"
#include "floor/tile_finder.h"
#include "region/box_tree.h"

namespace tessera::ui {
namespace {

// What the site check calls a tile laid a little off: it is told there and mended there, and keeps no hand from moving
// a tile of a floor as it was found.
constexpr Metres kLaidOff{0.03};
constexpr Metres kFarthestTile{100'000.0};

tl::unexpected<Error> refusal(const QString& text) { return failure(text.toStdString()); }

int count(std::size_t n) { return static_cast<int>(n); }

}  // namespace

const floor::TileType* LayEdits::type(const std::string& name) const {
  const auto& types = document_.site().tileTypes;
  const auto found = std::find_if(types.begin(), types.end(), [&](const floor::TileType& t) { return t.name == name; });
  return found == types.end() ? nullptr : &*found;
}

std::vector<LayEdits::Laid> LayEdits::laid() const {
  const floor::Site& site = document_.site();
  floor::LaidTypes types{site};
  std::vector<Laid> all;
  all.reserve(site.placements.size());
  for (std::size_t n = 0; n < site.placements.size(); ++n) {
    const floor::Placement& placement = site.placements[n];
    if (const floor::TileType* type = types.find(placement, n))
      all.push_back({n, type, floor::boxOf(placement, *type)});
  }
  return all;
}

LayEdits::Moves LayEdits::movesOf(const std::vector<Laid>& laid, const TileSet& tiles) const {
  Moves moves;
  const auto& placements = document_.site().placements;
  for (std::size_t n = 0; n < laid.size(); ++n) {
    const floor::Placement& placement = placements[laid[n].placement];
    if (tiles.contains(placement.serial))
      moves.push_back({n, laid[n].box.low, placement.quarterTurns, sizeOf(laid[n].box)});
  }
  return moves;
}

Result<void> LayEdits::rearrange(const QString& step, const std::vector<Laid>& laid, const Moves& moves, int mergeKey) {
  std::vector<Box> boxes;
  boxes.reserve(laid.size());
  for (const Laid& tile : laid) boxes.push_back(tile.box);
  for (const Move& move : moves) boxes[move.index] = boxOf(move.low, move.size);
  const region::BoxTree tree{boxes};
  const auto& placements = document_.site().placements;
  for (const Move& move : moves) {
    if (abs(move.low.x) > kFarthestTile || abs(move.low.y) > kFarthestTile)
      return refusal(tr("A tile may lie no farther than 100 km from the site's origin."));
    std::optional<std::size_t> under;
    tree.forEachIn(boxes[move.index], [&](std::size_t other) {
      if (other != move.index && lieUpon(boxes[other], boxes[move.index], kLaidOff) &&
          !lieUpon(laid[other].box, laid[move.index].box, kLaidOff))
        under = other;
    });
    if (under) {
      return refusal(tr("Tile “%1” would lie upon tile “%2”.")
                         .arg(QString::fromStdString(placements[laid[move.index].placement].serial),
                              QString::fromStdString(placements[laid[*under].placement].serial)));
    }
  }
  return document_.edit(
      step,
      [&](floor::Site& site) {
        for (const Move& move : moves) {
          floor::Placement& placement = site.placements[laid[move.index].placement];
          placement.quarterTurns = move.turns;
          placement.origin = toMicrometre(floor::originFor(move.low, *laid[move.index].type, move.turns));
        }
      },
      mergeKey);
}

Result<void> LayEdits::move(const TileSet& tiles, Offset by, int mergeKey) {
  const auto all = laid();
  Moves moves = movesOf(all, tiles);
  for (Move& move : moves) move.low = move.low + by;
  return rearrange(tr("Move %n tile(s)", nullptr, count(moves.size())), all, moves, mergeKey);
}

Result<void> LayEdits::turn(const TileSet& tiles) {
  const auto all = laid();
  Moves moves = movesOf(all, tiles);
  if (moves.empty()) return {};
  Box group = all[moves.front().index].box;
  Metres step = std::min(moves.front().size.x, moves.front().size.y);
  for (const Move& move : moves) {
    group = boxAround(group, all[move.index].box);
    step = std::min({step, move.size.x, move.size.y});
  }
  const Point middle = middleOf(group);
  const Offset size = sizeOf(group);
  // About its very middle a group of 5 × 4 tiles would come to lie half a tile off the lattice that it lay on.
  // Half a step is none, to either side alike, so that four quarters lead back.
  const auto ontoLattice = [&](Metres off) {
    const double steps = std::floor(std::abs(off / step) + 0.5 - 1e-6);
    return std::copysign(steps, off.value()) * step - off;
  };
  const Offset shift{ontoLattice((size.x - size.y) / 2.0), ontoLattice((size.y - size.x) / 2.0)};
  for (Move& move : moves) {
    const Offset arm = floor::quarterTurned(middleOf(all[move.index].box) - middle, 1);
    move.turns = (move.turns + 1) % 4;
    move.size = {move.size.y, move.size.x};
    move.low = toMicrometre(middle + arm + shift - 0.5 * move.size);
  }
  return rearrange(tr("Turn %n tile(s)", nullptr, count(moves.size())), all, moves);
}

Result<void> LayEdits::turnEach(const TileSet& tiles) {
  const auto all = laid();
  Moves moves = movesOf(all, tiles);
  for (Move& move : moves) {
    const Point middle = middleOf(all[move.index].box);
    move.turns = (move.turns + 1) % 4;
    move.size = {move.size.y, move.size.x};
    move.low = toMicrometre(middle - 0.5 * move.size);
  }
  return rearrange(tr("Turn %n tile(s)", nullptr, count(moves.size())), all, moves);
}

Result<void> LayEdits::align(const TileSet& tiles, Line line) {
  const auto all = laid();
  Moves moves = movesOf(all, tiles);
  if (moves.empty()) return {};
  Box group = all[moves.front().index].box;
  for (const Move& move : moves) group = boxAround(group, all[move.index].box);
  // The lattice is the nearest neighbour's; where all that lies is chosen, that of the tile at the lower left.
  std::optional<Box> anchor;
  double least = 0.0;
  const auto away = [&](const Box& box) {
    const double x = std::max({(group.low.x - box.high.x).value(), (box.low.x - group.high.x).value(), 0.0});
    const double y = std::max({(group.low.y - box.high.y).value(), (box.low.y - group.high.y).value(), 0.0});
    return std::hypot(x, y);
  };
  for (std::size_t n = 0, next = 0; line == Line::Lattice && n < all.size(); ++n) {
    if (next < moves.size() && moves[next].index == n) {
      ++next;
    } else if (const double distance = away(all[n].box); !anchor || distance < least) {
      anchor = all[n].box;
      least = distance;
    }
  }
  if (!anchor) {
    anchor = all[std::min_element(moves.begin(), moves.end(),
                                  [](const Move& a, const Move& b) { return a.low.x + a.low.y < b.low.x + b.low.y; })
                     ->index]
                 .box;
  }
  for (Move& move : moves) {
    if (line == Line::Left) move.low.x = group.low.x;
    if (line == Line::Right) move.low.x = group.high.x - move.size.x;
    if (line == Line::Bottom) move.low.y = group.low.y;
    if (line == Line::Top) move.low.y = group.high.y - move.size.y;
    if (line == Line::Lattice) move.low = besideTile(move.low, move.size, *anchor);
  }
  return rearrange(tr("Align %n tile(s)", nullptr, count(moves.size())), all, moves);
}

Result<void> LayEdits::place(const std::string& serial, Point low, int quarterTurns, int mergeKey) {
  const auto all = laid();
  Moves moves = movesOf(all, {serial});
  for (Move& move : moves) {
    const bool across = (move.turns + quarterTurns) % 2 != 0;
    move.low = low;
    move.turns = quarterTurns;
    if (across) move.size = {move.size.y, move.size.x};
  }
  return rearrange(tr("Place tile %1").arg(QString::fromStdString(serial)), all, moves, mergeKey);
}

}  // namespace tessera::ui
