#include "floor/tag_change.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "floor/laid_tile.h"

namespace tessera::floor {
namespace {

struct Laid {
  const Tile* tile = nullptr;
  const Placement* placement = nullptr;
};
using Touched = std::unordered_map<std::string_view, Laid>;

// More than this is a change of the whole floor: to make the table anew is quicker then.
std::size_t most(const Site& before) { return 64 + before.placements.size() / 16; }

template <class Item>
void collect(const ListPatch<Item>& patch, Touched& touched) {
  for (const Hunk<Item>& hunk : patch) {
    for (const Item& item : hunk.before) touched.try_emplace(item.serial);
    for (const Item& item : hunk.after) touched.try_emplace(item.serial);
  }
}

// Finds the touched tiles in a site. False: two have one serial number.
bool locate(const Site& site, Touched& touched) {
  for (auto& [serial, laid] : touched) laid = {};
  const auto put = [&touched](const auto& items, auto member) {
    for (const auto& item : items) {
      const auto at = touched.find(item.serial);
      if (at == touched.end()) continue;
      if (at->second.*member != nullptr) return false;
      at->second.*member = &item;
    }
    return true;
  };
  return put(site.tiles, &Laid::tile) && put(site.placements, &Laid::placement);
}

// Calls visit(UID, place) for each registered tag of the touched tiles that are laid. False: a tile is not what its
// placement or its type says.
template <class Visit>
bool forEachTag(const Site& site, const Touched& touched, Visit visit) {
  std::unordered_map<std::string_view, std::vector<Offset>> offsets;
  for (const TileType& type : site.tileTypes) offsets.emplace(type.name, tagOffsets(type));
  for (const auto& [serial, laid] : touched) {
    if (laid.placement == nullptr) continue;
    if (laid.tile == nullptr) return false;
    const auto places = offsets.find(laid.tile->type);
    if (places == offsets.end() || laid.tile->uids.size() > places->second.size()) return false;
    for (std::size_t n = 0; n < laid.tile->uids.size(); ++n) {
      if (!laid.tile->uids[n].empty()) visit(laid.tile->uids[n], placeOn(*laid.placement, places->second[n]));
    }
  }
  return true;
}

}  // namespace

std::optional<TagChange> tagChange(const Site& before, const Site& after, const SitePatch& change) {
  if (!change.tileTypes().empty()) return std::nullopt;
  Touched touched;
  collect(change.tiles(), touched);
  collect(change.placements(), touched);
  if (touched.size() > most(before)) return std::nullopt;
  TagChange tags;
  if (!locate(before, touched) ||
      !forEachTag(before, touched, [&](const TagUid& uid, Point) { tags.removed.push_back(uid); }) ||
      !locate(after, touched) || !forEachTag(after, touched, [&](const TagUid& uid, Point place) {
        tags.added.push_back({uid, place});
      }))
    return std::nullopt;
  for (const Hunk<LooseTag>& hunk : change.looseTags()) {
    for (const LooseTag& tag : hunk.before)
      if (!tag.uid.empty()) tags.removed.push_back(tag.uid);
    for (const LooseTag& tag : hunk.after)
      if (!tag.uid.empty()) tags.added.push_back({tag.uid, tag.place});
  }
  if (tags.removed.size() + tags.added.size() > 64 * most(before)) return std::nullopt;
  return tags;
}

}  // namespace tessera::floor
