#include "exchange/site_import.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "floor/laid_tile.h"
#include "floor/site_json.h"
#include "floor/site_map.h"
#include "region/box_tree.h"

namespace tessera::exchange {
namespace {

using floor::Site;

constexpr std::size_t kNamed = 5;  // one by one; the rest is counted
constexpr Metres kUpon{0.001};     // tiles that only touch do not lie upon one another

/// Items that go by a key that is taken already.
class Held {
public:
  Held(std::vector<Sentence>& notes, const Pattern& sentence, const Pattern& rest)
      : notes_{notes}, sentence_{sentence}, rest_{rest} {}
  void add(const std::string& name) {
    if (++count_ <= kNamed) notes_.push_back(sentence_.with(name));
  }
  void close() {
    if (count_ > kNamed) notes_.push_back(rest_.with(count_ - kNamed));
  }

private:
  std::vector<Sentence>& notes_;
  Pattern sentence_;
  Pattern rest_;
  std::size_t count_ = 0;
};

// Adds those whose key is free. Gives the indices of the added in `from`.
template <class Item, class KeyOf, class NameOf>
std::vector<std::size_t> addNew(std::vector<Item>& to, const std::vector<Item>& from, KeyOf keyOf, NameOf nameOf,
                                Held held) {
  using Key = std::decay_t<decltype(keyOf(from.front()))>;
  std::unordered_map<Key, std::size_t> taken;
  for (std::size_t n = 0; n < to.size(); ++n) taken.try_emplace(keyOf(to[n]), n);
  std::vector<std::size_t> added;
  for (std::size_t n = 0; n < from.size(); ++n) {
    const auto there = taken.find(keyOf(from[n]));
    if (there == taken.end()) {
      to.push_back(from[n]);
      added.push_back(n);
    } else if (!(to[there->second] == from[n])) {
      held.add(nameOf(from[n]));
    }
  }
  held.close();
  return added;
}

std::string calledByName(const auto& item) { return item.name; }
std::string calledBySerial(const auto& item) { return item.serial; }

class SiteImport {
public:
  SiteImport(const Site& onto, const Site& from) : onto_{onto}, from_{from}, preview_{onto, {}, {}} {}

  Result<Preview> run() {
    Site& site = preview_.site;
    std::vector<Sentence>& notes = preview_.notes;
    addNew(site.tileTypes, from_.tileTypes, [](const auto& t) { return t.name; }, &calledByName<floor::TileType>,
           {notes, phrase("Core", "Tile type \"%1\" is here already, and another one: it stays as it is."),
            phrase("Core", "More tile types that stay as they are: %1.")});
    const auto tiles = addNew(
        site.tiles, from_.tiles, [](const auto& t) { return t.serial; }, &calledBySerial<floor::Tile>,
        {notes, phrase("Core", "Tile \"%1\" is here already, of another type or with other tags: it stays as it is."),
         phrase("Core", "More tiles that stay as they are: %1.")});
    if (auto error = otherType(tiles)) return tl::unexpected{std::move(*error)};
    takePlacements();
    const auto laid =
        addNew(site.placements, placements_, [](const auto& p) { return p.serial; }, &calledBySerial<floor::Placement>,
               {notes, phrase("Core", "Tile \"%1\" is laid here already, at another place: it stays there."),
                phrase("Core", "More tiles that stay as they are: %1.")});
    addNew(
        site.looseTags, from_.looseTags, [](const auto& t) { return t.uid; },
        [](const auto& t) { return t.uid.text(); },
        {notes, phrase("Core", "Loose tag %1 is here already, at another place: it stays there."),
         phrase("Core", "More loose tags that stay as they are: %1.")});
    addNew(site.zones, from_.zones, [](const auto& z) { return z.name; }, &calledByName<floor::Zone>,
           {notes, phrase("Core", "Zone \"%1\" is here already, and another one: it stays as it is."),
            phrase("Core", "More zones that stay as they are: %1.")});
    addNew(site.routes, from_.routes, [](const auto& r) { return r.name; }, &calledByName<floor::Route>,
           {notes, phrase("Core", "Route \"%1\" is here already, and another one: it stays as it is."),
            phrase("Core", "More routes that stay as they are: %1.")});
    addNew(
        site.vehicles, from_.vehicles, [](const auto& v) { return v.id.value; },
        [](const auto& v) { return std::to_string(v.id.value); },
        {notes, phrase("Core", "Address %1 is a vehicle's here already, and another one's: it stays as it is."),
         phrase("Core", "More vehicles that stay as they are: %1.")});
    if (auto error = doubledUid(tiles)) return tl::unexpected{std::move(*error)};
    if (auto error = tooMany()) return tl::unexpected{std::move(*error)};
    noteWhatLiesUpon(laid);
    noteWhatIsLeft();
    preview_.changes = sitediff::difference(onto_, site);
    return std::move(preview_);
  }

private:
  // Where a tile lies says nothing of another one of its serial number.
  void takePlacements() {
    std::unordered_map<std::string_view, const floor::Tile*> here;
    for (const auto& tile : onto_.tiles) here.try_emplace(tile.serial, &tile);
    std::unordered_set<std::string_view> others;
    for (const auto& tile : from_.tiles)
      if (const auto same = here.find(tile.serial); same != here.end() && !(*same->second == tile))
        others.insert(tile.serial);
    for (const auto& placement : from_.placements)
      if (!others.contains(placement.serial)) placements_.push_back(placement);
  }

  std::optional<Error> otherType(const std::vector<std::size_t>& tiles) const {
    std::unordered_map<std::string_view, const floor::TileType*> here;
    for (const auto& type : onto_.tileTypes) here.try_emplace(type.name, &type);
    std::unordered_set<std::string_view> others;
    for (const auto& type : from_.tileTypes)
      if (const auto same = here.find(type.name); same != here.end() && !(*same->second == type))
        others.insert(type.name);
    for (const std::size_t n : tiles)
      if (others.contains(from_.tiles[n].type))
        return Error{phrase("Core", "Tile \"%1\" is of type \"%2\", which is another one in the open site.")
                         .with(from_.tiles[n].serial, from_.tiles[n].type)};
    return std::nullopt;
  }

  // A UID that is here already must not come with a tile or a loose tag; among the file's own the map looks.
  std::optional<Error> doubledUid(const std::vector<std::size_t>& tiles) const {
    std::unordered_map<floor::TagUid, Sentence> here;
    for (const auto& tile : onto_.tiles)
      for (std::size_t n = 0; n < tile.uids.size(); ++n)
        if (!tile.uids[n].empty())
          here.try_emplace(tile.uids[n], phrase("Core", "tag %1 of tile \"%2\"").with(n + 1, tile.serial));
    const auto clash = [&](const floor::TagUid& uid, const Sentence& as) -> std::optional<Error> {
      const auto there = here.find(uid);
      if (there == here.end()) return std::nullopt;
      return Error{
          phrase("Core", "tag %1 would be registered twice: as %2 and as %3.").with(uid.text(), there->second, as)};
    };
    for (const auto& tag : from_.looseTags)
      if (auto error = clash(tag.uid, phrase("Core", "a loose tag"))) return error;
    for (const auto& tag : onto_.looseTags) here.try_emplace(tag.uid, phrase("Core", "a loose tag"));
    for (const std::size_t t : tiles)
      for (std::size_t n = 0; n < from_.tiles[t].uids.size(); ++n)
        if (const floor::TagUid& uid = from_.tiles[t].uids[n]; !uid.empty())
          if (auto error = clash(uid, phrase("Core", "tag %1 of tile \"%2\"").with(n + 1, from_.tiles[t].serial)))
            return error;
    return std::nullopt;
  }

  std::optional<Error> tooMany() const {
    const Site& site = preview_.site;
    if (site.tileTypes.size() <= floor::kMostTileTypes && site.tiles.size() <= floor::kMostTiles &&
        site.placements.size() <= floor::kMostTiles && site.looseTags.size() <= floor::kMostTiles &&
        site.zones.size() <= floor::kMostRoutes && site.routes.size() <= floor::kMostRoutes &&
        site.vehicles.size() <= floor::kMostVehicles)
      return std::nullopt;
    return Error{phrase("Core", "the site would have more of a kind than a site file holds.")};
  }

  static std::vector<std::pair<std::string_view, Box>> boxesOf(const Site& site) {
    std::unordered_map<std::string_view, const floor::TileType*> types;
    for (const auto& type : site.tileTypes) types.try_emplace(type.name, &type);
    std::unordered_map<std::string_view, const floor::TileType*> typeOf;
    for (const auto& tile : site.tiles)
      if (const auto type = types.find(tile.type); type != types.end()) typeOf.try_emplace(tile.serial, type->second);
    std::vector<std::pair<std::string_view, Box>> boxes;
    for (const auto& placement : site.placements)
      if (const auto type = typeOf.find(placement.serial); type != typeOf.end())
        boxes.emplace_back(placement.serial, boxOf(placement, *type->second));
    return boxes;
  }

  void noteWhatLiesUpon(const std::vector<std::size_t>& laid) {
    std::vector<Box> here;
    for (const auto& [serial, box] : boxesOf(onto_)) here.push_back(box);
    const region::BoxTree tree{here};
    std::unordered_set<std::string_view> added;
    for (const std::size_t n : laid) added.insert(placements_[n].serial);
    std::size_t upon = 0;
    for (const auto& [serial, box] : boxesOf(preview_.site)) {
      if (!added.contains(serial)) continue;
      bool any = false;
      tree.forEachIn(grown(box, -kUpon), [&any](std::size_t) { any = true; });
      upon += any ? 1 : 0;
    }
    if (upon > 0)
      preview_.notes.push_back(
          phrase("Core", "Tiles that come to lie upon tiles that are here already: %1. The panel Faults lists them.")
              .with(upon));
  }

  void noteWhatIsLeft() {
    if (from_.northToY != onto_.northToY)
      preview_.notes.push_back(
          phrase("Core", "The file's site lies otherwise to north: its coordinates are taken as they are."));
    if (!from_.vehicles.empty() && from_.radio != onto_.radio)
      preview_.notes.push_back(phrase("Core", "The file's vehicles were set up for another setting of the radio."));
    if (from_.backdrop) preview_.notes.push_back(phrase("Core", "The picture beneath the file's floor is left out."));
  }

  const Site& onto_;
  const Site& from_;
  std::vector<floor::Placement> placements_;  ///< of the file's tiles that are these
  Preview preview_;
};

}  // namespace

Result<Preview> importSite(const Site& onto, std::string_view text, const std::string& name) {
  const auto in = [&name](const Sentence& what) { return failure(phrase("Core", "%1: %2").with(name, what)); };
  const auto from = floor::parseSite(text, name);
  if (!from) return tl::unexpected{from.error()};
  if (const auto map = floor::SiteMap::build(*from); !map) return in(map.error().sentence);
  auto preview = SiteImport{onto, *from}.run();
  if (!preview) return in(preview.error().sentence);
  // Whatever else comes of putting both together; what was wrong here already is not the file's fault.
  const auto before = floor::SiteMap::build(onto, floor::Ambiguity::Carried);
  if (!before) return in(before.error().sentence);
  const auto after = floor::SiteMap::build(preview->site, floor::Ambiguity::Carried);
  if (!after) return in(after.error().sentence);
  if (const auto* added = newAmong((*after)->contradictions(), (*before)->contradictions())) return in(added->sentence);
  return preview;
}

}  // namespace tessera::exchange
