#include "sitediff/tally.h"

#include <algorithm>

#include "sitediff/matching.h"

namespace tessera::sitediff {
namespace {

using floor::TagUid;
using floor::Tile;

int registeredIn(const Tile& tile) {
  return static_cast<int>(
      std::count_if(tile.uids.begin(), tile.uids.end(), [](const TagUid& u) { return !u.empty(); }));
}

int tagsBetween(const Tile& a, const Tile& b) {
  int count = 0;
  for (std::size_t n = 0; n < std::max(a.uids.size(), b.uids.size()); ++n)
    count += static_cast<int>((n < a.uids.size() ? a.uids[n] : TagUid{}) != (n < b.uids.size() ? b.uids[n] : TagUid{}));
  return count;
}

// Items that are new, gone or others.
template <class Items, class KeyOf>
int differing(const Items& before, const Items& after, KeyOf keyOf) {
  using Item = typename Items::value_type;
  int count = 0;
  if (before == after) return count;
  match(before, after, keyOf,
        [&](const Item* a, const Item* b) { count += static_cast<int>(a == nullptr || b == nullptr || !(*a == *b)); });
  return count;
}

constexpr auto kByName = [](const auto& item) { return std::string_view{item.name}; };
constexpr auto kBySerial = [](const auto& item) { return std::string_view{item.serial}; };

}  // namespace

Tally tallyOf(const floor::Site& before, const floor::Site& after) {
  Tally tally;
  if (before.placements != after.placements)
    match(before.placements, after.placements, kBySerial, [&](const floor::Placement* a, const floor::Placement* b) {
      if (a == nullptr) return void(++tally.laid);
      if (b == nullptr) return void(++tally.takenUp);
      if (!(*a == *b)) ++tally.moved;
    });
  if (before.tiles != after.tiles)
    match(before.tiles, after.tiles, kBySerial, [&](const Tile* a, const Tile* b) {
      if (a == nullptr || b == nullptr) {
        ++tally.others;
        tally.tags += registeredIn(a == nullptr ? *b : *a);
      } else {
        tally.others += static_cast<int>(a->type != b->type);
        tally.tags += tagsBetween(*a, *b);
      }
    });
  tally.tags += differing(before.looseTags, after.looseTags, [](const floor::LooseTag& t) { return t.uid; });
  tally.zones = differing(before.zones, after.zones, kByName);
  tally.routes = differing(before.routes, after.routes, kByName);
  tally.vehicles = differing(before.vehicles, after.vehicles, [](const floor::VehicleSetup& v) { return v.id; });
  tally.others += differing(before.tileTypes, after.tileTypes, kByName);
  tally.others += static_cast<int>(before.name != after.name) + static_cast<int>(before.northToY != after.northToY) +
                  static_cast<int>(!(before.radio == after.radio)) +
                  static_cast<int>(!(before.backdrop == after.backdrop));
  return tally;
}

}  // namespace tessera::sitediff
