#include "tilecheck/tile_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "floor/laid_tile.h"
#include "floor/tile_finder.h"
#include "region/box_tree.h"

namespace tessera::tilecheck {
namespace {

constexpr double kSameSize = 0.02;  // m: tiles that differ by more do not fit each other's places

struct ReadInTile {
  Offset offset;  ///< of the tag in its tile
  std::size_t tag = 0;
  Point place;
};

struct Laid {
  const floor::Placement* placement = nullptr;
  const floor::TileType* type = nullptr;
  Box box;
  std::vector<ReadInTile> reads;
};

/// Where the tile lies as far as its reads tell.
struct Belief {
  std::size_t place = 0;  ///< that of the tile that is laid there by the site
  int turns = 0;
};

class TileCheck {
public:
  TileCheck(const floor::Site& site, const std::vector<PlacedRead>& reads, const TileCheckOptions& options)
      : options_{options} {
    collect(site);
    sortReads(site, reads);
  }

  std::vector<TileSuspect> suspects() {
    std::vector<Box> boxes;
    boxes.reserve(tiles_.size());
    for (const Laid& tile : tiles_) boxes.push_back(tile.box);
    tree_ = region::BoxTree{boxes};
    for (std::size_t t = 0; t < tiles_.size(); ++t)
      if (const auto belief = believe(t)) beliefs_.emplace(t, *belief);
    std::vector<TileSuspect> all;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
      const auto belief = beliefs_.find(t);
      if (belief == beliefs_.end() || told_.contains(t)) continue;
      if (belief->second.place == t) {
        if (belief->second.turns != tiles_[t].placement->quarterTurns) all.push_back(turned(t, belief->second));
      } else if (auto ring = ringFrom(t)) {
        all.push_back(swapped(*ring));
      }
    }
    return all;
  }

  /// After suspects(). Placements whose tile or type the site does not have stay untouched.
  [[nodiscard]] std::vector<TileState> states(const floor::Site& site, const std::vector<TileSuspect>& suspects) const {
    std::vector<TileState> states(site.placements.size(), TileState::Untouched);
    std::set<std::string> suspected;
    for (const TileSuspect& suspect : suspects) suspected.insert(suspect.serials.begin(), suspect.serials.end());
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
      const Laid& tile = tiles_[t];
      TileState& state = states[static_cast<std::size_t>(tile.placement - site.placements.data())];
      const auto belief = beliefs_.find(t);
      if (suspected.contains(tile.placement->serial)) {
        state = TileState::Suspect;
      } else if (belief != beliefs_.end() && belief->second.place == t &&
                 belief->second.turns == tile.placement->quarterTurns) {
        state = TileState::Confirmed;
      } else if (!tile.reads.empty()) {
        state = TileState::Seen;
      }
    }
    return states;
  }

private:
  void collect(const floor::Site& site) {
    floor::LaidTypes types{site};
    for (std::size_t n = 0; n < site.placements.size(); ++n) {
      const floor::Placement& placement = site.placements[n];
      const floor::TileType* type = types.find(placement, n);
      if (type == nullptr) continue;
      tileOf_.try_emplace(placement.serial, tiles_.size());
      tiles_.push_back({&placement, type, boxOf(placement, *type), {}});
    }
  }

  void sortReads(const floor::Site& site, const std::vector<PlacedRead>& reads) {
    struct Tag {
      std::size_t tile;
      std::size_t index;
      Offset offset;
    };
    std::unordered_map<floor::TagUid, Tag> tags;
    for (const auto& tile : site.tiles) {
      const auto laid = tileOf_.find(tile.serial);
      if (laid == tileOf_.end()) continue;
      const auto offsets = tagOffsets(*tiles_[laid->second].type);
      for (std::size_t n = 0; n < std::min(offsets.size(), tile.uids.size()); ++n)
        if (!tile.uids[n].empty()) tags.try_emplace(tile.uids[n], Tag{laid->second, n, offsets[n]});
    }
    for (const PlacedRead& read : reads)
      if (const auto tag = tags.find(read.uid); tag != tags.end())
        tiles_[tag->second.tile].reads.push_back({tag->second.offset, tag->second.index, read.place});
  }

  [[nodiscard]] bool enough(const Laid& tile) const {
    std::set<std::size_t> tags;
    for (const ReadInTile& read : tile.reads) tags.insert(read.tag);
    return tile.reads.size() >= options_.leastReads && tags.size() >= options_.leastTags;
  }

  [[nodiscard]] double costOf(const Laid& tile, const floor::Placement& placement) const {
    double cost = 0.0;
    for (const ReadInTile& read : tile.reads) {
      const double away = distance(placeOn(placement, read.offset), read.place) / options_.noise;
      cost += std::min(away * away, options_.mostPerRead);
    }
    return cost;
  }

  [[nodiscard]] std::optional<floor::Placement> placement(std::size_t t, const Belief& belief) const {
    const Laid& tile = tiles_[t];
    const Box& there = tiles_[belief.place].box;
    const auto laid = placedAt(tile.placement->serial, *tile.type, there.low, belief.turns);
    const Box box = boxOf(laid, *tile.type);
    const Offset tooLarge = box.high - there.high;
    if (std::abs(tooLarge.x.value()) > kSameSize || std::abs(tooLarge.y.value()) > kSameSize) return std::nullopt;
    return laid;
  }

  // Nullopt: too few reads, or no way to lie explains them clearly better than another.
  [[nodiscard]] std::optional<Belief> believe(std::size_t t) const {
    const Laid& tile = tiles_[t];
    if (!enough(tile)) return std::nullopt;
    std::vector<Point> places;
    for (const ReadInTile& read : tile.reads) places.push_back(read.place);
    // Every place of a tile that one of the reads lies on or beside; its own too, if it is far from all of them.
    std::set<std::size_t> near{t};
    const Metres beside = 3.0 * options_.noise;
    for (const Point& p : places) tree_.forEachIn(grown(Box{p, p}, beside), [&](std::size_t i) { near.insert(i); });
    constexpr double kNone = std::numeric_limits<double>::infinity();
    double best = kNone;
    double second = kNone;
    Belief belief;
    for (const std::size_t at : near) {
      for (int turns = 0; turns < 4; ++turns) {
        const bool asLaid = at == t && turns == tile.placement->quarterTurns;
        const auto laid = asLaid ? std::optional{*tile.placement} : placement(t, {at, turns});
        if (!laid) continue;
        const double cost = costOf(tile, *laid);
        if (cost < best) {
          second = std::exchange(best, cost);
          belief = {at, turns};
        } else {
          second = std::min(second, cost);
        }
      }
    }
    const bool explained = best <= 0.5 * options_.mostPerRead * static_cast<double>(tile.reads.size());
    if (!explained || second - best < options_.margin) return std::nullopt;
    return belief;
  }

  // From place to place: the tile at t lies at the second's place, that one at the third's, until one lies at t's. A
  // tile that was not read enough may lie where the ring begins.
  std::optional<std::vector<std::size_t>> ringFrom(std::size_t t) {
    std::vector<std::size_t> ring{t};
    for (;;) {
      const auto belief = beliefs_.find(ring.back());
      if (belief == beliefs_.end() || belief->second.place == t) break;
      const std::size_t next = belief->second.place;
      if (std::find(ring.begin(), ring.end(), next) != ring.end() || told_.contains(next)) return std::nullopt;
      const auto its = beliefs_.find(next);
      if (its != beliefs_.end() && its->second.place == next) return std::nullopt;  // two would lie at one place
      ring.push_back(next);
    }
    for (const std::size_t one : ring) {
      const auto belief = beliefs_.find(one);
      const Belief last{t, tiles_[one].placement->quarterTurns};
      if (!placement(one, belief == beliefs_.end() ? last : belief->second)) return std::nullopt;
    }
    told_.insert(ring.begin(), ring.end());
    return ring;
  }

  [[nodiscard]] Relaying::Move move(std::size_t t, const Belief& belief) const {
    return {*tiles_[t].placement, *placement(t, belief)};
  }

  [[nodiscard]] TileSuspect turned(std::size_t t, const Belief& belief) const {
    const std::string& serial = tiles_[t].placement->serial;
    const int by = ((belief.turns - tiles_[t].placement->quarterTurns) % 4 + 4) % 4;
    return {TileSuspect::Kind::Turned,
            {serial},
            phrase("Core", "Tile \"%1\" lies turned by %2° against the site.").with(serial, by * 90),
            {{move(t, belief)}}};
  }

  [[nodiscard]] TileSuspect swapped(const std::vector<std::size_t>& ring) const {
    TileSuspect suspect{TileSuspect::Kind::Swapped, {}, {}, {}};
    for (const std::size_t one : ring) {
      const auto belief = beliefs_.find(one);
      const Belief last{ring.front(), tiles_[one].placement->quarterTurns};
      suspect.serials.push_back(tiles_[one].placement->serial);
      suspect.fix.moves.push_back(move(one, belief == beliefs_.end() ? last : belief->second));
    }
    const auto& names = suspect.serials;
    suspect.sentence =
        names.size() == 2
            ? phrase("Core", "Tiles \"%1\" and \"%2\" lie at each other's places.").with(names[0], names[1])
            : phrase("Core", "%1 tiles lie at one another's places, \"%2\" at that of \"%3\".")
                  .with(names.size(), names[0], names[1]);
    return suspect;
  }

  TileCheckOptions options_;
  std::vector<Laid> tiles_;
  std::unordered_map<std::string, std::size_t> tileOf_;
  region::BoxTree tree_;
  std::unordered_map<std::size_t, Belief> beliefs_;
  std::set<std::size_t> told_;
};

}  // namespace

TileCheckResult checkFloor(const floor::Site& site, const std::vector<PlacedRead>& reads,
                           const TileCheckOptions& options) {
  if (reads.empty()) return {{}, std::vector<TileState>(site.placements.size(), TileState::Untouched)};
  TileCheck check{site, reads, options};
  TileCheckResult result{check.suspects(), {}};
  result.states = check.states(site, result.suspects);
  return result;
}

std::vector<TileSuspect> checkTiles(const floor::Site& site, const std::vector<PlacedRead>& reads,
                                    const TileCheckOptions& options) {
  return TileCheck{site, reads, options}.suspects();
}

}  // namespace tessera::tilecheck
