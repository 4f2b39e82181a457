// What in a site has two meanings, or none: names and UIDs that stand twice, tiles of which nothing is known.
#pragma once

#include <string>
#include <vector>

#include "base/sentence.h"
#include "floor/site.h"
#include "floor/tag_table.h"

namespace tessera::floor {

enum class ContradictionKind {
  TypeTwice,
  TileTwice,
  LaidTwice,
  TileUnknown,
  TypeUnknown,
  TooManyUids,
  UidTwice,
  RouteTwice,
  AddressTwice
};

struct Contradiction {
  ContradictionKind kind = ContradictionKind::UidTwice;
  std::string name;  ///< of the thing: serial number, UID, ...
  Sentence sentence;
};
using Contradictions = std::vector<Contradiction>;

/// Tile types, serial numbers and laid tiles that stand twice; one entry for each time too many.
[[nodiscard]] Contradictions doubledTiles(const Site& site);
/// Routes of one name and vehicles of one address, the same way.
[[nodiscard]] Contradictions doubledNames(const Site& site);

struct TagsOfSite {
  std::vector<PlacedTag> tags;
  Contradictions contradictions;  ///< in what is laid
};
/// Gives every laid, registered tag its place: P = L + R(turn) * l. What is ambiguous is left out.
/// ambiguous: of doubledTiles(). Error: a place that is no number.
[[nodiscard]] Result<TagsOfSite> layTags(const Site& site, const Contradictions& ambiguous);

/// Takes UIDs that are laid at two places out of `tags`: neither place counts. Of tiles and types that are ambiguous
/// themselves as well, so that mending one contradiction does not bring another to light.
[[nodiscard]] Contradictions takeOutDoubled(const Site& site, std::vector<PlacedTag>& tags);

/// The first of `after` that is not in `before`; null: there is none. Each stands for one time.
[[nodiscard]] const Contradiction* newAmong(const Contradictions& after, const Contradictions& before);

}  // namespace tessera::floor
