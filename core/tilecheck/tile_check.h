// Driven over, a floor tells which of its tiles were laid at each other's places or turned: their tags are read where
// others are expected. Each read comes with the place where the locator believed the reader to be just then.
#pragma once

#include <vector>

#include "base/sentence.h"
#include "floor/site.h"
#include "tilecheck/relaying.h"

namespace tessera::tilecheck {

struct PlacedRead {
  floor::TagUid uid;
  Point place;  ///< of the reader, without what this read itself said
};

struct TileSuspect {
  enum class Kind { Turned, Swapped } kind = Kind::Turned;
  std::vector<std::string> serials;  ///< one that is turned, or those that changed places in a ring
  Sentence sentence;
  Relaying fix;
};

struct TileCheckOptions {
  Metres noise{0.05};          ///< of a read's place along each axis
  std::size_t leastReads = 3;  ///< of a tile, before anything is said of it
  std::size_t leastTags = 2;   ///< different ones among them
  /// How much likelier another way to lie has to be than the site's, and than any third: the difference of the squared
  /// distances over the squared noise. 16 is odds of some 3000 to 1.
  double margin = 16.0;
  /// No read counts for more: one that is quite wrong must not outvote the others.
  double mostPerRead = 16.0;
};

/// How far a laid tile is checked.
enum class TileState {
  Untouched,  ///< none of its tags was read
  Seen,       ///< some were, too few to tell how it lies
  Confirmed,  ///< it lies as the site says
  Suspect,    ///< it is among those of a suspect
};

struct TileCheckResult {
  std::vector<TileSuspect> suspects;  ///< in the order of the site's placements
  std::vector<TileState> states;      ///< one for each of the site's placements
};

/// Reads of tags that no laid tile has are passed over.
[[nodiscard]] TileCheckResult checkFloor(const floor::Site& site, const std::vector<PlacedRead>& reads,
                                         const TileCheckOptions& options = {});

/// Its suspects alone. Reads of tags that no laid tile has are passed over. In the order of the site's placements.
[[nodiscard]] std::vector<TileSuspect> checkTiles(const floor::Site& site, const std::vector<PlacedRead>& reads,
                                                  const TileCheckOptions& options = {});

}  // namespace tessera::tilecheck
