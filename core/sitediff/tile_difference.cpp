// Tile types, tiles with their UIDs, where they lie, and loose tags.
#include <algorithm>
#include <map>

#include "floor/laid_tile.h"
#include "sitediff/matching.h"

namespace tessera::sitediff {
namespace {

using floor::LooseTag;
using floor::Placement;
using floor::Site;
using floor::Tile;
using floor::TileType;

Sentence tileCalled(const std::string& serial) { return phrase("Core", "Tile \"%1\"").with(serial); }

// Where tiles lie, by serial number.
class Places {
public:
  explicit Places(const Site& site) {
    std::map<std::string_view, const TileType*> types;
    for (const TileType& t : site.tileTypes) types.emplace(t.name, &t);
    for (const Tile& t : site.tiles) {
      const auto type = types.find(t.type);
      typeOf_.emplace(t.serial, type == types.end() ? nullptr : type->second);
    }
    for (const Placement& p : site.placements) placements_.emplace(p.serial, &p);
  }
  [[nodiscard]] std::optional<Box> of(const std::string& serial) const {
    const auto placement = placements_.find(serial);
    return placement == placements_.end() ? std::nullopt : std::optional{of(*placement->second)};
  }
  [[nodiscard]] Box of(const Placement& p) const {
    const auto type = typeOf_.find(p.serial);
    if (type == typeOf_.end() || type->second == nullptr) return {p.origin, p.origin};
    return boxOf(p, *type->second);
  }

private:
  std::map<std::string_view, const TileType*> typeOf_;
  std::map<std::string_view, const Placement*> placements_;
};

void uids(const Tile& before, const Tile& after, const std::optional<Box>& place, Teller& tell) {
  int registered = 0;
  int cleared = 0;
  int replaced = 0;
  for (std::size_t n = 0; n < std::max(before.uids.size(), after.uids.size()); ++n) {
    const floor::TagUid a = n < before.uids.size() ? before.uids[n] : floor::TagUid{};
    const floor::TagUid b = n < after.uids.size() ? after.uids[n] : floor::TagUid{};
    if (a == b) continue;
    ++(a.empty() ? registered : b.empty() ? cleared : replaced);
  }
  // A longer list of tags that are not registered says nothing new, but is another file.
  tell.changed(
      after.serial, tileCalled(after.serial),
      registered + cleared + replaced == 0
          ? Sentence{phrase("Core", "its list of tags has another length")}
          : phrase("Core", "tags registered: %1, cleared: %2, replaced: %3").with(registered, cleared, replaced),
      place);
}

}  // namespace

void tileDifference(const Site& before, const Site& after, Changes& changes) {
  const Places was{before};
  const Places is{after};
  match(
      before.tileTypes, after.tileTypes, [](const TileType& t) { return std::string_view{t.name}; },
      [tell = Teller{changes, Subject::TileType}](const TileType* a, const TileType* b) mutable {
        const std::string& name = (a != nullptr ? a : b)->name;
        const Sentence who = phrase("Core", "Tile type \"%1\"").with(name);
        if (a == nullptr) return tell.added(name, who, {});
        if (b == nullptr) return tell.removed(name, who, {});
        if (*a != *b) tell.changed(name, who, phrase("Core", "another size or pattern"), {});
      });
  match(
      before.tiles, after.tiles, [](const Tile& t) { return std::string_view{t.serial}; },
      [&, tell = Teller{changes, Subject::Tile}](const Tile* a, const Tile* b) mutable {
        const std::string& serial = (a != nullptr ? a : b)->serial;
        if (a == nullptr) return tell.added(serial, tileCalled(serial), is.of(serial));
        if (b == nullptr) return tell.removed(serial, tileCalled(serial), was.of(serial));
        if (a->type != b->type)
          tell.changed(serial, tileCalled(serial),
                       phrase("Core", "type \"%1\" instead of \"%2\"").with(b->type, a->type), is.of(serial));
        if (a->uids != b->uids) uids(*a, *b, is.of(serial), tell);
      });
  match(
      before.placements, after.placements, [](const Placement& p) { return std::string_view{p.serial}; },
      [&, tell = Teller{changes, Subject::Tile}](const Placement* a, const Placement* b) mutable {
        const std::string& serial = (a != nullptr ? a : b)->serial;
        const Sentence who = tileCalled(serial);
        if (a == nullptr)
          return tell.tell(ChangeKind::Added, serial,
                           phrase("Core", "%1 is laid at %2 m.").with(who, placed(b->origin)), is.of(*b));
        if (b == nullptr)
          return tell.tell(ChangeKind::Removed, serial,
                           phrase("Core", "%1 is taken up from %2 m.").with(who, placed(a->origin)), was.of(*a));
        if (a->origin != b->origin) tell.moved(serial, who, a->origin, b->origin);
        if (a->quarterTurns != b->quarterTurns)
          tell.tell(
              ChangeKind::Moved, serial,
              phrase("Core", "%1 is turned from %2° to %3°.").with(who, 90 * a->quarterTurns, 90 * b->quarterTurns),
              is.of(*b));
      });
  match(
      before.looseTags, after.looseTags, [](const LooseTag& t) { return t.uid; },
      [tell = Teller{changes, Subject::LooseTag}](const LooseTag* a, const LooseTag* b) mutable {
        const LooseTag& any = a != nullptr ? *a : *b;
        const Sentence who = phrase("Core", "Loose tag %1").with(any.uid.text());
        const Box place{any.place, any.place};
        if (a == nullptr) return tell.added(any.uid.text(), who, place);
        if (b == nullptr) return tell.removed(any.uid.text(), who, place);
        if (a->place != b->place) tell.moved(any.uid.text(), who, a->place, b->place);
      });
}

}  // namespace tessera::sitediff
