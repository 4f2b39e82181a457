#include "floor/site_patch.h"

#include <iterator>
#include <type_traits>

namespace tessera::floor {
namespace {

// Where two lists differ, looks one item ahead to tell a changed item from one put in or taken out; in doubt the
// lengths of what is left decide. One pass, where a shortest edit script would cost lists that differ much their
// square.
template <class Item>
ListPatch<Item> patchOf(const std::vector<Item>& before, const std::vector<Item>& after) {
  ListPatch<Item> patch;
  std::size_t i = 0;
  std::size_t k = 0;
  bool together = false;  // the last step lengthened a hunk
  const auto alike = [&](std::size_t a, std::size_t b) {
    return a < before.size() && b < after.size() && before[a] == after[b];
  };
  while (i < before.size() || k < after.size()) {
    if (alike(i, k)) {
      ++i, ++k;
      together = false;
      continue;
    }
    if (!together) patch.push_back({i, {}, {}});
    together = true;
    const std::size_t oldLeft = before.size() - i;
    const std::size_t newLeft = after.size() - k;
    const bool changed = oldLeft > 0 && newLeft > 0 && (oldLeft == newLeft || alike(i + 1, k + 1));
    if (changed || oldLeft > newLeft) patch.back().before.push_back(before[i++]);
    if (changed || oldLeft < newLeft) patch.back().after.push_back(after[k++]);
  }
  return patch;
}

template <class Value>
ValuePatch<Value> patchOf(const Value& before, const Value& after) {
  if (before == after) return std::nullopt;
  return std::pair{before, after};
}

enum class Way { Forward, Back };

template <class Value>
void put(const ValuePatch<Value>& patch, Value& value, Way way) {
  if (patch) value = way == Way::Forward ? patch->second : patch->first;
}

template <class Item>
void put(const ListPatch<Item>& patch, std::vector<Item>& list, Way way) {
  const auto difference = [](std::size_t n) { return static_cast<std::ptrdiff_t>(n); };
  // Most steps change items in place, which needs no list anew.
  bool sameLength = true;
  for (const Hunk<Item>& hunk : patch) sameLength = sameLength && hunk.before.size() == hunk.after.size();
  if (sameLength) {
    for (const Hunk<Item>& hunk : patch) {
      const std::vector<Item>& items = way == Way::Forward ? hunk.after : hunk.before;
      std::copy(items.begin(), items.end(), list.begin() + difference(hunk.at));
    }
    return;
  }
  std::vector<Item> made;
  made.reserve(list.size());
  std::size_t taken = 0;      // of `list`
  std::ptrdiff_t longer = 0;  // by how much the list is longer here than the older one
  for (const Hunk<Item>& hunk : patch) {
    const std::vector<Item>& gone = way == Way::Forward ? hunk.before : hunk.after;
    const std::vector<Item>& come = way == Way::Forward ? hunk.after : hunk.before;
    const std::size_t at = way == Way::Forward ? hunk.at : hunk.at + static_cast<std::size_t>(longer);
    std::move(list.begin() + difference(taken), list.begin() + difference(at), std::back_inserter(made));
    made.insert(made.end(), come.begin(), come.end());
    taken = at + gone.size();
    longer += difference(hunk.after.size()) - difference(hunk.before.size());
  }
  std::move(list.begin() + difference(taken), list.end(), std::back_inserter(made));
  list = std::move(made);
}

template <class Value>
std::size_t itemsIn(const ValuePatch<Value>& patch) {
  return patch ? 2 : 0;
}

template <class Item>
std::size_t itemsIn(const ListPatch<Item>& patch) {
  std::size_t n = 0;
  for (const Hunk<Item>& hunk : patch) n += hunk.before.size() + hunk.after.size();
  return n;
}

}  // namespace

template <class Patch, class Part, class Visit>
void SitePatch::forEachPart(Patch& patch, Part& site, Visit&& visit) {
  // A part that is added to a site does not compile until it stands here.
  auto& [name, northToY, radio, tileTypes, tiles, placements, looseTags, zones, routes, vehicles, backdrop] = site;
  visit(patch.name_, name);
  visit(patch.northToY_, northToY);
  visit(patch.radio_, radio);
  visit(patch.tileTypes_, tileTypes);
  visit(patch.tiles_, tiles);
  visit(patch.placements_, placements);
  visit(patch.looseTags_, looseTags);
  visit(patch.zones_, zones);
  visit(patch.routes_, routes);
  visit(patch.vehicles_, vehicles);
  visit(patch.backdrop_, backdrop);
}

SitePatch::SitePatch(const Site& before, const Site& after)
    : name_{patchOf(before.name, after.name)},
      northToY_{patchOf(before.northToY, after.northToY)},
      radio_{patchOf(before.radio, after.radio)},
      tileTypes_{patchOf(before.tileTypes, after.tileTypes)},
      tiles_{patchOf(before.tiles, after.tiles)},
      placements_{patchOf(before.placements, after.placements)},
      looseTags_{patchOf(before.looseTags, after.looseTags)},
      zones_{patchOf(before.zones, after.zones)},
      routes_{patchOf(before.routes, after.routes)},
      vehicles_{patchOf(before.vehicles, after.vehicles)},
      backdrop_{patchOf(before.backdrop, after.backdrop)} {}

std::size_t SitePatch::items() const {
  std::size_t n = 0;
  const Site none;
  forEachPart(*this, none, [&n](const auto& patch, const auto& /*part*/) { n += itemsIn(patch); });
  return n;
}

bool SitePatch::movesTags() const {
  return !(tileTypes_.empty() && tiles_.empty() && placements_.empty() && looseTags_.empty());
}

void SitePatch::apply(Site& site) const {
  forEachPart(*this, site, [](const auto& patch, auto& part) { put(patch, part, Way::Forward); });
}

void SitePatch::revert(Site& site) const {
  forEachPart(*this, site, [](const auto& patch, auto& part) { put(patch, part, Way::Back); });
}

}  // namespace tessera::floor
