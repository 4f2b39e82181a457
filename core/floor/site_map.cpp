#include "floor/site_map.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "floor/laid_tile.h"

namespace tessera::floor {
namespace {

// A key that appears twice among the items, if any.
template <class Items, class KeyOf>
auto repeated(const Items& items, KeyOf keyOf) {
  std::vector<decltype(keyOf(*items.begin()))> keys;
  keys.reserve(items.size());
  for (const auto& item : items) keys.push_back(keyOf(item));
  std::sort(keys.begin(), keys.end());
  const auto twice = std::adjacent_find(keys.begin(), keys.end());
  return twice == keys.end() ? std::nullopt : std::optional{*twice};
}

std::optional<Error> doubledTile(const Site& site) {
  if (auto n = repeated(site.tileTypes, [](const TileType& t) -> std::string_view { return t.name; }))
    return Error{phrase("Core", "Two tile types are called \"%1\".").with(std::string{*n})};
  if (auto n = repeated(site.tiles, [](const Tile& t) -> std::string_view { return t.serial; }))
    return Error{phrase("Core", "Two tiles have the serial number \"%1\".").with(std::string{*n})};
  if (auto n = repeated(site.placements, [](const Placement& p) -> std::string_view { return p.serial; }))
    return Error{phrase("Core", "Tile \"%1\" is laid twice.").with(std::string{*n})};
  return std::nullopt;
}

std::optional<Error> doubledName(const Site& site) {
  if (auto n = repeated(site.routes, [](const Route& r) { return r.name; }))
    return Error{phrase("Core", "Two routes are called \"%1\".").with(*n)};
  if (auto n = repeated(site.vehicles, [](const VehicleSetup& v) { return v.id; }))
    return Error{phrase("Core", "Two vehicles have the address %1.").with(n->value)};
  return std::nullopt;
}

// Not a number fails both comparisons.
bool isPlace(Point p) {
  constexpr Metres farthest{1e6};
  return abs(p.x) <= farthest && abs(p.y) <= farthest;
}

// Gives every laid, registered tag its place: P = L + R(turn) * l.
class Layer {
public:
  explicit Layer(const Site& site) : site_{site} {
    for (const TileType& type : site.tileTypes) types_.emplace(type.name, &type);
    for (const Tile& tile : site.tiles) tiles_.emplace(tile.serial, &tile);
  }

  Result<std::vector<PlacedTag>> lay() {
    for (const Placement& placement : site_.placements) {
      if (auto error = lay(placement)) return tl::unexpected{std::move(*error)};
    }
    for (const LooseTag& tag : site_.looseTags) {
      if (!tag.uid.empty()) placed_.push_back({tag.uid, tag.place});
    }
    for (const PlacedTag& tag : placed_) {
      if (!isPlace(tag.place))
        return failure(
            phrase("Core", "Tag %1 has a place that is no number or farther than 1000 km from the site's origin.")
                .with(tag.uid.text()));
    }
    return std::move(placed_);
  }

private:
  std::optional<Error> lay(const Placement& placement) {
    const auto tile = tiles_.find(placement.serial);
    if (tile == tiles_.end())
      return Error{phrase("Core", "Tile \"%1\" is laid, but no such tile is known.").with(placement.serial)};
    const auto type = types_.find(tile->second->type);
    if (type == types_.end()) {
      return Error{phrase("Core", "Tile \"%1\" is of type \"%2\", which is not known.")
                       .with(placement.serial, tile->second->type)};
    }
    const std::vector<Offset>& offsets = offsetsOf(*type->second);
    const std::vector<TagUid>& uids = tile->second->uids;
    if (uids.size() > offsets.size()) {
      return Error{phrase("Core", "Tile \"%1\" has %2 UIDs, but its type \"%3\" has only %4 tags.")
                       .with(placement.serial, uids.size(), type->second->name, offsets.size())};
    }
    for (std::size_t n = 0; n < uids.size(); ++n) {
      if (uids[n].empty()) continue;
      placed_.push_back({uids[n], placeOn(placement, offsets[n])});
    }
    return std::nullopt;
  }

  const std::vector<Offset>& offsetsOf(const TileType& type) {
    const auto [entry, isNew] = offsets_.try_emplace(&type);
    if (isNew) entry->second = tagOffsets(type);
    return entry->second;
  }

  const Site& site_;
  std::map<std::string_view, const TileType*> types_;
  std::map<std::string_view, const Tile*> tiles_;
  std::map<const TileType*, std::vector<Offset>> offsets_;
  std::vector<PlacedTag> placed_;
};

}  // namespace

Result<std::shared_ptr<const SiteMap>> SiteMap::build(Site site) {
  if (auto error = doubledTile(site)) return tl::unexpected{std::move(*error)};
  auto tags = Layer{site}.lay();
  if (!tags) return tl::unexpected{std::move(tags.error())};
  auto table = TagTable::build(*std::move(tags));
  if (!table) return tl::unexpected{std::move(table.error())};
  return with(std::move(site), *std::move(table));
}

Result<std::shared_ptr<const SiteMap>> SiteMap::rebuild(Site site, const SiteMap& before, const SitePatch& change) {
  return change.movesTags() ? build(std::move(site)) : with(std::move(site), before.table_);
}

Result<std::shared_ptr<const SiteMap>> SiteMap::with(Site site, std::shared_ptr<const TagTable> table) {
  if (auto error = doubledName(site)) return tl::unexpected{std::move(*error)};
  std::shared_ptr<SiteMap> map{new SiteMap};
  map->site_ = std::move(site);
  map->table_ = std::move(table);
  return map;
}

const Route* SiteMap::route(const std::string& name) const {
  const auto found =
      std::find_if(site_.routes.begin(), site_.routes.end(), [&](const Route& r) { return r.name == name; });
  return found == site_.routes.end() ? nullptr : &*found;
}

const VehicleSetup* SiteMap::vehicle(VehicleId id) const {
  const auto found =
      std::find_if(site_.vehicles.begin(), site_.vehicles.end(), [&](const VehicleSetup& v) { return v.id == id; });
  return found == site_.vehicles.end() ? nullptr : &*found;
}

}  // namespace tessera::floor
