#include "scan/walk.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "floor/laid_tile.h"

namespace tessera::scan {
namespace {

struct At {
  double x;
  double y;
  std::size_t index;
};

/// Indices in rows from below, each second row from right to left. What lies within `tolerance` of a row's lowest is of
/// that row: tiles are laid by hand.
std::vector<std::size_t> serpentine(std::vector<At> points, double tolerance) {
  std::sort(points.begin(), points.end(),
            [](const At& a, const At& b) { return std::tie(a.y, a.x, a.index) < std::tie(b.y, b.x, b.index); });
  std::vector<std::size_t> order;
  order.reserve(points.size());
  bool back = false;
  for (auto row = points.begin(); row != points.end(); back = !back) {
    const auto end = std::find_if(row, points.end(), [&](const At& p) { return p.y > row->y + tolerance; });
    std::sort(row, end, [&](const At& a, const At& b) {
      return back ? std::tie(b.x, a.y, a.index) < std::tie(a.x, b.y, b.index)
                  : std::tie(a.x, a.y, a.index) < std::tie(b.x, b.y, b.index);
    });
    for (; row != end; ++row) order.push_back(row->index);
  }
  return order;
}

class Floor {
public:
  Floor(const floor::Site& site, const std::string& tile) : site_{site} {
    for (const floor::TileType& type : site.tileTypes) {
      types_.try_emplace(type.name, &type);
      offsets_.try_emplace(type.name, tagOffsets(type));
      pitch_ = std::min(pitch_, type.pitch.value());
      height_ = std::min({height_, type.width.value(), type.height.value()});
    }
    for (const floor::Placement& p : site.placements) laid_.try_emplace(p.serial, &p);
    for (std::size_t i = 0; i < site.tiles.size(); ++i)
      if ((tile.empty() || site.tiles[i].serial == tile) && types_.contains(site.tiles[i].type)) wanted_.push_back(i);
  }

  /// Tag by tag: as they are numbered, or serpentine where they lie.
  std::vector<Stop> stopsOf(std::size_t tile, bool serpentineWithin) const {
    const floor::Tile& t = site_.tiles[tile];
    const auto& offsets = offsets_.at(t.type);
    const auto placement = laid_.find(t.serial);
    std::vector<Stop> stops;
    std::vector<At> points;
    for (std::size_t n = 0; n < offsets.size(); ++n) {
      Stop stop{static_cast<std::uint32_t>(tile), static_cast<std::uint32_t>(n), std::nullopt};
      if (placement != laid_.end()) stop.place = placeOn(*placement->second, offsets[n]);
      const Point p = stop.place.value_or(Point{offsets[n].x, offsets[n].y});
      points.push_back({p.x.value(), p.y.value(), n});
      stops.push_back(stop);
    }
    if (!serpentineWithin) return stops;
    std::vector<Stop> ordered;
    const double tolerance = 0.4 * types_.at(t.type)->pitch.value();
    const std::vector<std::size_t> order = serpentine(std::move(points), tolerance);
    for (const std::size_t n : order) ordered.push_back(stops[n]);
    return ordered;
  }

  std::vector<Stop> byNumber() const {
    std::vector<Stop> walk;
    for (const std::size_t tile : wanted_) add(walk, stopsOf(tile, false));
    return walk;
  }

  std::vector<Stop> byTile() const {
    std::vector<At> middles;
    for (const std::size_t tile : wanted_) {
      const auto placement = laid_.find(site_.tiles[tile].serial);
      if (placement == laid_.end()) continue;
      const Point m = middleOf(boxOf(*placement->second, *types_.at(site_.tiles[tile].type)));
      middles.push_back({m.x.value(), m.y.value(), tile});
    }
    std::vector<Stop> walk;
    const std::vector<std::size_t> order = serpentine(std::move(middles), 0.5 * height_);
    for (const std::size_t tile : order) add(walk, stopsOf(tile, true));
    return walk;
  }

  std::vector<Stop> byRow() const {
    std::vector<Stop> all;
    for (const std::size_t tile : wanted_) add(all, stopsOf(tile, false));
    std::erase_if(all, [](const Stop& s) { return !s.place; });
    std::vector<At> points;
    for (std::size_t i = 0; i < all.size(); ++i)
      points.push_back({all[i].place->x.value(), all[i].place->y.value(), i});
    std::vector<Stop> walk;
    walk.reserve(all.size());
    const std::vector<std::size_t> order = serpentine(std::move(points), 0.4 * pitch_);
    for (const std::size_t i : order) walk.push_back(all[i]);
    return walk;
  }

  /// A tile that is not laid has no place on the floor, but may be registered by itself.
  bool single() const { return wanted_.size() == 1 && !laid_.contains(site_.tiles[wanted_.front()].serial); }

private:
  static void add(std::vector<Stop>& walk, const std::vector<Stop>& more) {
    walk.insert(walk.end(), more.begin(), more.end());
  }

  const floor::Site& site_;
  std::unordered_map<std::string, const floor::TileType*> types_;
  std::unordered_map<std::string, std::vector<Offset>> offsets_;
  std::unordered_map<std::string, const floor::Placement*> laid_;
  std::vector<std::size_t> wanted_;
  double pitch_ = 1e9;
  double height_ = 1e9;
};

}  // namespace

std::vector<Stop> walkOver(const floor::Site& site, WalkOrder order, const std::string& tile) {
  const Floor floor{site, tile};
  if (order == WalkOrder::TilesByNumber || (!tile.empty() && floor.single())) return floor.byNumber();
  return order == WalkOrder::TilesAlongFloor ? floor.byTile() : floor.byRow();
}

bool samePlaces(const floor::Site& a, const floor::Site& b) {
  return a.placements == b.placements && a.tileTypes == b.tileTypes &&
         std::equal(
             a.tiles.begin(), a.tiles.end(), b.tiles.begin(), b.tiles.end(),
             [](const floor::Tile& x, const floor::Tile& y) { return x.serial == y.serial && x.type == y.type; });
}

}  // namespace tessera::scan
