#include "floor/site_map.h"

#include <algorithm>
#include <bit>
#include <limits>
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

std::optional<Error> doubledName(const Site& site) {
  if (auto n = repeated(site.tileTypes, [](const TileType& t) { return t.name; }))
    return Error{phrase("Core", "Two tile types are called \"%1\".").with(*n)};
  if (auto n = repeated(site.tiles, [](const Tile& t) { return t.serial; }))
    return Error{phrase("Core", "Two tiles have the serial number \"%1\".").with(*n)};
  if (auto n = repeated(site.placements, [](const Placement& p) { return p.serial; }))
    return Error{phrase("Core", "Tile \"%1\" is laid twice.").with(*n)};
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
  if (auto error = doubledName(site)) return tl::unexpected{std::move(*error)};
  auto tags = Layer{site}.lay();
  if (!tags) return tl::unexpected{std::move(tags.error())};
  if (tags->size() >= std::numeric_limits<std::uint32_t>::max() / 4)
    return failure(phrase("Core", "The site has too many tags."));

  if (const auto twice = repeated(*tags, [](const PlacedTag& t) { return t.uid; })) {
    return failure(phrase("Core", "Tag %1 is registered at two places.").with(twice->text()));
  }
  std::shared_ptr<SiteMap> map{new SiteMap};
  map->site_ = std::move(site);
  map->sortIntoGrid(std::move(*tags));
  if (!map->hashTags()) return failure(phrase("Core", "The UIDs of the site's tags cannot be told apart quickly."));
  return map;
}

void SiteMap::sortIntoGrid(std::vector<PlacedTag> tags) {
  if (tags.empty()) {
    cellStart_.assign(2, 0);
    return;
  }
  const auto byX = [](const PlacedTag& a, const PlacedTag& b) { return a.place.x < b.place.x; };
  const auto byY = [](const PlacedTag& a, const PlacedTag& b) { return a.place.y < b.place.y; };
  const auto [west, east] = std::minmax_element(tags.begin(), tags.end(), byX);
  const auto [south, north] = std::minmax_element(tags.begin(), tags.end(), byY);
  left_ = west->place.x.value();
  bottom_ = south->place.y.value();
  const double width = east->place.x.value() - left_;
  const double height = north->place.y.value() - bottom_;
  // A cell of 0.3 m holds a few tags of any usual floor. Where tags lie far apart it grows, so that the grid never
  // has many more cells than there are tags.
  const double most = 2.0 * static_cast<double>(tags.size()) + 16.0;
  cellSize_ = 0.3;
  while ((std::floor(width / cellSize_) + 1.0) * (std::floor(height / cellSize_) + 1.0) > most) cellSize_ *= 1.5;
  columns_ = static_cast<std::size_t>(width / cellSize_) + 1;
  rows_ = static_cast<std::size_t>(height / cellSize_) + 1;

  const auto cellOf = [this](const PlacedTag& t) {
    return row(t.place.y.value()) * columns_ + column(t.place.x.value());
  };
  cellStart_.assign(columns_ * rows_ + 1, 0);
  for (const PlacedTag& tag : tags) ++cellStart_[cellOf(tag) + 1];
  for (std::size_t c = 1; c < cellStart_.size(); ++c) cellStart_[c] += cellStart_[c - 1];
  std::vector<std::uint32_t> next{cellStart_.begin(), cellStart_.end() - 1};
  tags_.resize(tags.size());
  for (const PlacedTag& tag : tags) tags_[next[cellOf(tag)]++] = tag;
}

// UIDs chosen to collide would make look-ups slow: a table with a long probe is laid out anew with another salt.
bool SiteMap::hashTags() {
  const std::size_t capacity = std::bit_ceil(2 * tags_.size() + 2);
  for (std::uint64_t salt = 0; salt < 16; ++salt) {
    if (fillTable(capacity, salt)) return true;
  }
  return false;
}

bool SiteMap::fillTable(std::size_t capacity, std::uint64_t salt) {
  constexpr std::size_t longestProbe = 256;
  table_.assign(capacity, 0);
  salt_ = salt;
  for (std::uint32_t i = 0; i < tags_.size(); ++i) {
    std::size_t at = tags_[i].uid.hash(salt_) & (capacity - 1);
    std::size_t probes = 0;
    while (table_[at] != 0) {
      if (++probes > longestProbe) return false;
      at = (at + 1) & (capacity - 1);
    }
    table_[at] = i + 1;
  }
  return true;
}

std::optional<Point> SiteMap::find(const TagUid& uid) const {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t at = uid.hash(salt_) & mask; table_[at] != 0; at = (at + 1) & mask) {
    const PlacedTag& tag = tags_[table_[at] - 1];
    if (tag.uid == uid) return tag.place;
  }
  return std::nullopt;
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
