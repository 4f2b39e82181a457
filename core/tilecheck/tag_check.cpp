#include "tilecheck/tag_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "floor/laid_tile.h"
#include "region/box_tree.h"

namespace tessera::tilecheck {
namespace {

constexpr Metres kTagNear{0.03};  // a place is known no better than that, however often a tag was read there

std::string decimals(double value, int count) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", count, value);
  return text;
}
std::string atPlace(Point p) { return "(" + decimals(p.x.value(), 2) + ", " + decimals(p.y.value(), 2) + ")"; }

double middleOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// "1 in 4 000"; beyond a million nobody counts.
std::string oddsOf(double chance) {
  const double times = 1.0 / std::max(chance, 1e-6);
  const double digits = std::pow(10.0, std::floor(std::log10(times)));
  return decimals(std::floor(times / digits) * digits, 0);
}

class TagCheck {
public:
  TagCheck(const floor::Site& site, const std::vector<PlacedRead>& reads, const TileCheckResult& tiles,
           const TagCheckOptions& options)
      : site_{site}, options_{options} {
    for (const PlacedRead& read : reads) {
      auto& of = reads_[read.uid];
      if (of.empty()) order_.push_back(read.uid);
      of.push_back(read.place);
    }
    collect(tiles);
  }

  std::vector<TagFinding> findings(const std::vector<TagPasses>& passes) {
    for (const floor::TagUid& uid : order_)
      if (!known_.contains(uid)) unknown(uid, reads_[uid]);
    missed(passes);
    return std::move(findings_);
  }

private:
  // A place on a laid tile where a tag belongs.
  struct Spot {
    std::uint32_t tile = 0;
    std::uint32_t position = 0;
    Point place;
  };

  void collect(const TileCheckResult& tiles) {
    std::unordered_map<std::string_view, const floor::TileType*> types;
    for (const auto& type : site_.tileTypes) types.try_emplace(type.name, &type);
    std::unordered_map<std::string_view, std::size_t> placements;
    for (std::size_t n = 0; n < site_.placements.size(); ++n) placements.try_emplace(site_.placements[n].serial, n);
    for (std::uint32_t t = 0; t < site_.tiles.size(); ++t) {
      const floor::Tile& tile = site_.tiles[t];
      const auto type = types.find(tile.type);
      const auto laid = placements.find(tile.serial);
      if (type == types.end() || laid == placements.end()) {
        for (const floor::TagUid& uid : tile.uids) shelved_.try_emplace(uid, t);
        continue;
      }
      const bool elsewhere = laid->second < tiles.states.size() && tiles.states[laid->second] == TileState::Suspect;
      const auto offsets = tagOffsets(*type->second);
      for (std::uint32_t n = 0; n < offsets.size(); ++n) {
        const floor::TagUid uid = n < tile.uids.size() ? tile.uids[n] : floor::TagUid{};
        const Point place = placeOn(site_.placements[laid->second], offsets[n]);
        if (!uid.empty()) known_.try_emplace(uid, elsewhere ? kNowhere : spots_.size());
        if (elsewhere) continue;
        spots_.push_back({t, n, place});
        boxes_.push_back({place, place});
      }
    }
    for (const floor::LooseTag& tag : site_.looseTags) known_.try_emplace(tag.uid, kNowhere);
    tree_ = region::BoxTree{boxes_};
  }

  [[nodiscard]] floor::TagUid uidOf(const Spot& spot) const {
    const auto& uids = site_.tiles[spot.tile].uids;
    return spot.position < uids.size() ? uids[spot.position] : floor::TagUid{};
  }

  // The one place that it can lie at, as far as its reads tell: not where the tag that belongs there was read.
  [[nodiscard]] std::optional<std::size_t> spotAt(Point place, std::size_t reads) const {
    const Metres near = 3.0 / std::sqrt(static_cast<double>(reads)) * options_.noise + kTagNear;
    std::optional<std::size_t> best;
    Metres least{1e9};
    Metres next{1e9};
    tree_.forEachIn(grown(Box{place, place}, 3.0 * near), [&](std::size_t i) {
      const Metres away = distance(spots_[i].place, place);
      const floor::TagUid uid = uidOf(spots_[i]);
      if (!uid.empty() && reads_.contains(uid)) return;
      if (away < least) {
        next = std::exchange(least, away);
        best = i;
      } else {
        next = std::min(next, away);
      }
    });
    if (!best || least > near || next < 2.0 * least || next - least < options_.noise) return std::nullopt;
    return best;
  }

  void unknown(const floor::TagUid& uid, const std::vector<Point>& places) {
    if (places.size() < options_.leastReads) return;
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Point& p : places) {
      xs.push_back(p.x.value());
      ys.push_back(p.y.value());
    }
    const Point place{Metres{middleOf(std::move(xs))}, Metres{middleOf(std::move(ys))}};
    if (const auto shelved = shelved_.find(uid); shelved != shelved_.end()) {
      findings_.push_back({TagFinding::Kind::Unknown,
                           phrase("Core", "Tag %1 was read %2 times at %3 m, but its tile \"%4\" is not laid.")
                               .with(uid.text(), places.size(), atPlace(place), site_.tiles[shelved->second].serial),
                           place,
                           {},
                           uid.text()});
      return;
    }
    const auto at = places.size() >= options_.surelyReads ? spotAt(place, places.size()) : std::nullopt;
    if (at && !taken_.contains(*at)) {
      const Spot& spot = spots_[*at];
      const floor::Tile& tile = site_.tiles[spot.tile];
      const floor::TagUid before = uidOf(spot);
      const std::optional<PutUid> fix{PutUid{tile.serial, spot.position, before, uid}};
      taken_.insert(*at);
      const auto sentence =
          before.empty()
              ? phrase("Core",
                       "Tag %1 was read %2 times where tag %3 of tile \"%4\" is not registered: probably it is that.")
              : phrase("Core",
                       "Tag %1, which no tile has, was read %2 times where tag %3 of tile \"%4\" should be, which "
                       "was never read: probably the card was exchanged.");
      findings_.push_back({before.empty() ? TagFinding::Kind::Unregistered : TagFinding::Kind::Exchanged,
                           sentence.with(uid.text(), places.size(), spot.position + 1, tile.serial), spot.place, fix,
                           uid.text()});
      return;
    }
    findings_.push_back({TagFinding::Kind::Unknown,
                         phrase("Core", "Tag %1 was read %2 times at %3 m, but no tile has it.")
                             .with(uid.text(), places.size(), atPlace(place)),
                         place,
                         {},
                         uid.text()});
  }

  struct Missed {
    std::size_t spot;
    std::size_t passes;
  };

  void missed(const std::vector<TagPasses>& passes) {
    std::size_t all = 0;
    std::size_t hits = 0;
    std::size_t often = 0;
    std::vector<Missed> silent;
    for (const TagPasses& tag : passes) {
      const auto known = known_.find(tag.uid);
      if (known == known_.end() || known->second == kNowhere || taken_.contains(known->second)) continue;
      all += tag.passes;
      hits += tag.hits;
      if (tag.passes < options_.leastPasses) continue;
      ++often;
      if (tag.hits == 0 && !reads_.contains(tag.uid)) silent.push_back({known->second, tag.passes});
    }
    if (static_cast<double>(silent.size()) > options_.mostMissed * static_cast<double>(often)) return;
    // One more missed than there were: few passes do not make a reader perfect.
    const double miss = 1.0 - static_cast<double>(hits) / static_cast<double>(all + 1);
    // Each of them improbable by itself; what is told of a tile is told once.
    std::map<std::uint32_t, std::vector<Missed>> ofTile;
    for (const Missed& one : silent)
      if (std::pow(miss, static_cast<double>(one.passes)) <= options_.improbable)
        ofTile[spots_[one.spot].tile].push_back(one);
    for (const auto& [tile, tags] : ofTile) tellMissed(site_.tiles[tile].serial, tags, miss);
  }

  void tellMissed(const std::string& serial, const std::vector<Missed>& tags, double miss) {
    std::size_t passes = 0;
    for (const Missed& one : tags) passes += one.passes;
    const Spot& spot = spots_[tags.front().spot];
    const std::string share = decimals(100.0 * (1.0 - miss), 0);
    const std::string odds = oddsOf(std::pow(miss, static_cast<double>(passes)));
    const Sentence sentence =
        tags.size() == 1
            ? phrase("Core",
                     "Tag %1 of tile \"%2\" was never read in %3 passes over it; others are read in %4 % of passes. By "
                     "chance that is once in %5.")
                  .with(spot.position + 1, serial, passes, share, odds)
            : phrase(
                  "Core",
                  "%1 tags of tile \"%2\" were never read in %3 passes over them; others are read in %4 % of passes. "
                  "By chance that is once in %5.")
                  .with(tags.size(), serial, passes, share, odds);
    findings_.push_back({TagFinding::Kind::Missed, sentence, spot.place, {}, serial});
  }

  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  const floor::Site& site_;
  const TagCheckOptions& options_;
  std::unordered_map<floor::TagUid, std::vector<Point>> reads_;
  std::vector<floor::TagUid> order_;
  std::vector<Spot> spots_;
  std::vector<Box> boxes_;
  region::BoxTree tree_;
  std::unordered_map<floor::TagUid, std::size_t> known_;      ///< laid or loose; index of its spot, or kNowhere
  std::unordered_map<floor::TagUid, std::uint32_t> shelved_;  ///< of tiles that are not laid
  std::unordered_set<std::size_t> taken_;                     ///< spots at which another tag lies
  std::vector<TagFinding> findings_;
};

}  // namespace

bool put(const PutUid& change, floor::Site& site) {
  const auto tile = std::find_if(site.tiles.begin(), site.tiles.end(),
                                 [&](const floor::Tile& t) { return t.serial == change.serial; });
  if (tile == site.tiles.end()) return false;
  const floor::TagUid now = change.position < tile->uids.size() ? tile->uids[change.position] : floor::TagUid{};
  if (now != change.before) return false;
  if (tile->uids.size() <= change.position) tile->uids.resize(change.position + 1);
  tile->uids[change.position] = change.after;
  return true;
}

std::vector<TagFinding> checkTags(const floor::Site& site, const std::vector<PlacedRead>& reads,
                                  const std::vector<TagPasses>& passes, const TileCheckResult& tiles,
                                  const TagCheckOptions& options) {
  if (reads.empty() && passes.empty()) return {};
  return TagCheck{site, reads, tiles, options}.findings(passes);
}

}  // namespace tessera::tilecheck
