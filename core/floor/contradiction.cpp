#include "floor/contradiction.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "floor/laid_tile.h"
#include "floor/tile_finder.h"

namespace tessera::floor {
namespace {

// The keys that appear again among the items, each as often as it is one too many. Where no two hashes are alike no two
// keys are, and numbers are sorted several times sooner than a hundred thousand names that begin alike.
template <class Items, class KeyOf>
auto repeated(const Items& items, KeyOf keyOf) {
  using Key = std::decay_t<decltype(keyOf(*items.begin()))>;
  std::vector<Key> keys;
  std::vector<std::size_t> hashes;
  hashes.reserve(items.size());
  for (const auto& item : items) hashes.push_back(std::hash<Key>{}(keyOf(item)));
  std::sort(hashes.begin(), hashes.end());
  if (std::adjacent_find(hashes.begin(), hashes.end()) == hashes.end()) return keys;
  keys.reserve(items.size());
  for (const auto& item : items) keys.push_back(keyOf(item));
  std::sort(keys.begin(), keys.end());
  decltype(keys) again;
  for (auto at = keys.begin(); (at = std::adjacent_find(at, keys.end())) != keys.end(); ++at) again.push_back(*at);
  return again;
}

// Not a number fails both comparisons.
bool isPlace(Point p) {
  constexpr Metres farthest{1e6};
  return abs(p.x) <= farthest && abs(p.y) <= farthest;
}

class Layer {
public:
  Layer(const Site& site, const Contradictions& ambiguous) : site_{site}, tiles_{site.tiles} {
    for (const TileType& type : site.tileTypes) types_.emplace(type.name, &type);
    for (const Contradiction& c : ambiguous)
      (c.kind == ContradictionKind::TypeTwice ? ambiguousTypes_ : ambiguousTiles_).insert(c.name);
  }

  Result<TagsOfSite> lay() {
    for (std::size_t n = 0; n < site_.placements.size(); ++n) lay(site_.placements[n], n);
    for (const LooseTag& tag : site_.looseTags) {
      if (!tag.uid.empty()) result_.tags.push_back({tag.uid, tag.place});
    }
    for (const PlacedTag& tag : result_.tags) {
      if (!isPlace(tag.place))
        return failure(
            phrase("Core", "Tag %1 has a place that is no number or farther than 1000 km from the site's origin.")
                .with(tag.uid.text()));
    }
    return std::move(result_);
  }

private:
  void tell(ContradictionKind kind, const std::string& name, const Sentence& sentence) {
    result_.contradictions.push_back({kind, name, sentence});
  }

  void lay(const Placement& placement, std::size_t index) {
    const Tile* tile = tiles_.find(placement.serial, index);
    if (tile == nullptr)
      return tell(ContradictionKind::TileUnknown, placement.serial,
                  phrase("Core", "Tile \"%1\" is laid, but no such tile is known.").with(placement.serial));
    const auto type = types_.find(tile->type);
    if (type == types_.end())
      return tell(
          ContradictionKind::TypeUnknown, placement.serial,
          phrase("Core", "Tile \"%1\" is of type \"%2\", which is not known.").with(placement.serial, tile->type));
    const std::vector<Offset>& offsets = offsetsOf(*type->second);
    const std::vector<TagUid>& uids = tile->uids;
    if (uids.size() > offsets.size())
      return tell(ContradictionKind::TooManyUids, placement.serial,
                  phrase("Core", "Tile \"%1\" has %2 UIDs, but its type \"%3\" has only %4 tags.")
                      .with(placement.serial, uids.size(), type->second->name, offsets.size()));
    if (ambiguousTiles_.contains(placement.serial) || ambiguousTypes_.contains(type->second->name)) return;
    for (std::size_t n = 0; n < uids.size(); ++n) {
      if (!uids[n].empty()) result_.tags.push_back({uids[n], placeOn(placement, offsets[n])});
    }
  }

  const std::vector<Offset>& offsetsOf(const TileType& type) {
    const auto [entry, isNew] = offsets_.try_emplace(&type);
    if (isNew) entry->second = tagOffsets(type);
    return entry->second;
  }

  const Site& site_;
  std::map<std::string_view, const TileType*> types_;
  TileFinder tiles_;
  std::set<std::string, std::less<>> ambiguousTypes_;
  std::set<std::string, std::less<>> ambiguousTiles_;
  std::map<const TileType*, std::vector<Offset>> offsets_;
  TagsOfSite result_;
};

std::vector<std::pair<ContradictionKind, std::string_view>> keysOf(const Contradictions& all) {
  std::vector<std::pair<ContradictionKind, std::string_view>> keys;
  for (const Contradiction& c : all) keys.emplace_back(c.kind, c.name);
  return keys;
}

}  // namespace

Contradictions doubledTiles(const Site& site) {
  Contradictions all;
  const auto tell = [&all](ContradictionKind kind, std::string_view name, const tessera::Pattern& pattern) {
    all.push_back({kind, std::string{name}, pattern.with(std::string{name})});
  };
  for (const auto name : repeated(site.tileTypes, [](const TileType& t) -> std::string_view { return t.name; }))
    tell(ContradictionKind::TypeTwice, name, phrase("Core", "Two tile types are called \"%1\"."));
  for (const auto name : repeated(site.tiles, [](const Tile& t) -> std::string_view { return t.serial; }))
    tell(ContradictionKind::TileTwice, name, phrase("Core", "Two tiles have the serial number \"%1\"."));
  for (const auto name : repeated(site.placements, [](const Placement& p) -> std::string_view { return p.serial; }))
    tell(ContradictionKind::LaidTwice, name, phrase("Core", "Tile \"%1\" is laid twice."));
  return all;
}

Contradictions doubledNames(const Site& site) {
  Contradictions all;
  for (const std::string_view name : repeated(site.routes, [](const Route& r) -> std::string_view { return r.name; }))
    all.push_back({ContradictionKind::RouteTwice, std::string{name},
                   phrase("Core", "Two routes are called \"%1\".").with(std::string{name})});
  for (const VehicleId id : repeated(site.vehicles, [](const VehicleSetup& v) { return v.id; }))
    all.push_back({ContradictionKind::AddressTwice, std::to_string(id.value),
                   phrase("Core", "Two vehicles have the address %1.").with(id.value)});
  return all;
}

Result<TagsOfSite> layTags(const Site& site, const Contradictions& ambiguous) { return Layer{site, ambiguous}.lay(); }

Contradictions takeOutDoubled(const Site& site, std::vector<PlacedTag>& tags) {
  std::unordered_map<std::string_view, std::size_t> laid;  // how often
  for (const Placement& placement : site.placements) ++laid[placement.serial];
  std::unordered_map<TagUid, std::size_t> count;
  for (const Tile& tile : site.tiles) {
    const auto often = laid.find(tile.serial);
    if (often == laid.end()) continue;
    for (const TagUid& uid : tile.uids)
      if (!uid.empty()) count[uid] += often->second;
  }
  for (const LooseTag& tag : site.looseTags)
    if (!tag.uid.empty()) ++count[tag.uid];
  std::erase_if(tags, [&](const PlacedTag& tag) { return count[tag.uid] > 1; });
  Contradictions all;
  for (const auto& [uid, times] : count)
    for (std::size_t n = 1; n < times; ++n)
      all.push_back({ContradictionKind::UidTwice, uid.text(),
                     phrase("Core", "Tag %1 is registered at two places.").with(uid.text())});
  // In an order that does not depend on the table's.
  std::sort(all.begin(), all.end(), [](const Contradiction& a, const Contradiction& b) { return a.name < b.name; });
  return all;
}

const Contradiction* newAmong(const Contradictions& after, const Contradictions& before) {
  auto known = keysOf(before);
  std::sort(known.begin(), known.end());
  std::map<std::pair<ContradictionKind, std::string_view>, std::size_t> seen;
  for (const Contradiction& c : after) {
    const std::pair key{c.kind, std::string_view{c.name}};
    const auto [first, last] = std::equal_range(known.begin(), known.end(), key);
    if (++seen[key] > static_cast<std::size_t>(last - first)) return &c;
  }
  return nullptr;
}

}  // namespace tessera::floor
