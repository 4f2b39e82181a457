// Serial numbers and types that name nothing, or two things.
#include <string_view>
#include <unordered_map>

#include "floor/laid_tile.h"
#include "sitecheck/checks.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

using floor::Placement;
using floor::Tile;
constexpr std::size_t kLongestSerial = 200;  // as a site file allows

using FirstByName = std::unordered_map<std::string_view, std::uint32_t>;

std::optional<Box> boxOfTile(const Context& context, std::size_t tile) {
  const std::uint32_t laid = context.plan.laidOf(tile);
  return laid == FloorPlan::kNone ? std::nullopt : std::optional{context.plan.laid()[laid].box};
}

void tileTypes(const Context& context, Faults& faults) {
  FaultList twice{faults, FaultKind::TileTypeTwice, Severity::Error, context.options.mostOfAKind};
  FirstByName seen;
  const auto& types = context.site.tileTypes;
  for (std::uint32_t i = 0; i < types.size(); ++i) {
    const floor::TileType& type = types[i];
    const auto [first, isNew] = seen.try_emplace(type.name, i);
    if (isNew) continue;
    twice.add({}, [&, same = types[first->second] == type] {
      Fault fault{.sentence = phrase("Core", "Two tile types are called \"%1\".").with(type.name),
                  .objects = {{ObjectKind::TileType, type.name}}};
      if (same)
        fault.fix =
            Fix{phrase("Core", "Forget the second entry of tile type \"%1\", which is the same").with(type.name),
                ForgetTileType{type}};
      return fault;
    });
  }
  twice.close();
}

void tiles(const Context& context, Faults& faults) {
  FaultList typeless{faults, FaultKind::TileTypeUnknown, Severity::Error, context.options.mostOfAKind};
  for (std::size_t i = 0; i < context.site.tiles.size(); ++i) {
    if (context.plan.typeOf(i) != FloorPlan::kNone) continue;
    const Tile& tile = context.site.tiles[i];
    typeless.add({}, [&] {
      return Fault{
          .sentence = phrase("Core", "Tile \"%1\" is of type \"%2\", which is not known.").with(tile.serial, tile.type),
          .objects = {{ObjectKind::Tile, tile.serial}, {ObjectKind::TileType, tile.type}}};
    });
  }
  typeless.close();
}

void placements(const Context& context, Faults& faults) {
  const std::size_t most = context.options.mostOfAKind;
  FaultList twice{faults, FaultKind::TileLaidTwice, Severity::Error, most};
  FaultList unknown{faults, FaultKind::TileUnknown, Severity::Error, most};
  FaultList nowhere{faults, FaultKind::PlaceNoNumber, Severity::Error, most};
  // Of known tiles by their number, of others by name.
  std::vector<std::uint32_t> placed(context.site.tiles.size(), FloorPlan::kNone);
  FirstByName stray;
  for (std::uint32_t i = 0; i < context.site.placements.size(); ++i) {
    const Placement& p = context.site.placements[i];
    const Box here{p.origin, p.origin};
    const bool isSomewhere = isPlace(here);
    const auto shown = isSomewhere ? std::optional{here} : std::nullopt;
    const Fix takeUp{phrase("Core", "Take tile \"%1\" up").with(p.serial), TakeTileUp{p}};
    const auto fault = [&](const Sentence& sentence) {
      return Fault{.sentence = sentence, .objects = {{ObjectKind::Tile, p.serial}}, .fix = takeUp};
    };
    if (!isSomewhere)
      nowhere.add({}, [&] {
        return fault(
            phrase("Core", "Tile \"%1\" has a place that is no number or farther than 1000 km from the site's origin.")
                .with(p.serial));
      });
    const std::uint32_t tile = context.plan.tileOf(i);
    if (tile == FloorPlan::kNone)
      unknown.add(shown, [&] {
        return fault(phrase("Core", "Tile \"%1\" is laid, but no such tile is known.").with(p.serial));
      });
    std::uint32_t& first = tile == FloorPlan::kNone ? stray.try_emplace(p.serial, i).first->second : placed[tile];
    if (first == FloorPlan::kNone) first = i;
    if (first == i) continue;
    const Point other = context.site.placements[first].origin;
    const Box both = isPlace({other, other}) && isSomewhere ? boxAround(here, {other, other}) : here;
    twice.add(isSomewhere ? std::optional{both} : std::nullopt, [&] {
      return fault(phrase("Core", "Tile \"%1\" is laid twice: at %2 and at %3 m.")
                       .with(p.serial, placeText(other), placeText(p.origin)));
    });
  }
  twice.close();
  unknown.close();
  nowhere.close();
}

}  // namespace

Faults checkTwins(const Context& context) {
  Faults faults;
  FaultList twice{faults, FaultKind::TileTwice, Severity::Error, context.options.mostOfAKind};
  FirstByName taken;
  if (!context.plan.twins().empty()) {
    for (const Tile& tile : context.site.tiles) taken.try_emplace(tile.serial, 0);
    // What is laid by that name would come to lie there.
    for (const Placement& p : context.site.placements) taken.try_emplace(p.serial, 0);
  }
  const auto freeSerial = [&taken](const std::string& serial) {
    for (int n = 2;; ++n)
      if (std::string other = serial + "-" + std::to_string(n); !taken.contains(other)) return other;
  };
  for (const auto& [first, later] : context.plan.twins()) {
    const Tile& tile = context.site.tiles[later];
    twice.add(boxOfTile(context, first), [&, same = context.site.tiles[first] == tile] {
      Fault fault{.sentence = phrase("Core", "Two tiles have the serial number \"%1\".").with(tile.serial),
                  .objects = {{ObjectKind::Tile, tile.serial}}};
      if (same)
        fault.fix = Fix{phrase("Core", "Forget the second entry of tile \"%1\", which is the same").with(tile.serial),
                        ForgetTile{tile}};
      else if (const std::string other = freeSerial(tile.serial); other.size() <= kLongestSerial)
        fault.fix = Fix{phrase("Core", "Call the second tile \"%1\" \"%2\" instead").with(tile.serial, other),
                        RenameTile{tile, other}};
      return fault;
    });
  }
  twice.close();
  return faults;
}

Faults checkTileNames(const Context& context) {
  Faults faults;
  tileTypes(context, faults);
  tiles(context, faults);
  placements(context, faults);
  return faults;
}

}  // namespace tessera::sitecheck
