// Tags that a drive over the floor shows to be others than the site says: read though no tile has them, or never read
// though vehicles passed over them.
#pragma once

#include <optional>
#include <vector>

#include "tilecheck/pass_counter.h"
#include "tilecheck/tile_check.h"

namespace tessera::tilecheck {

/// A tile's tag is another one.
struct PutUid {
  std::string serial;
  std::size_t position = 0;  ///< in the tile's UIDs, from 0
  floor::TagUid before;      ///< empty: none is registered there
  floor::TagUid after;
  bool operator==(const PutUid&) const = default;
};
/// False: the site is no longer as it was when this was found; nothing has changed then.
[[nodiscard]] bool put(const PutUid& change, floor::Site& site);

struct TagFinding {
  enum class Kind {
    Unknown,       ///< read, but no laid tile has it
    Unregistered,  ///< read where a tile's tag is not registered
    Exchanged,     ///< read where another tag is registered, which is never read
    Missed         ///< never read though vehicles passed over it
  } kind = Kind::Unknown;
  Sentence sentence;
  Point place;
  std::optional<PutUid> fix;
  std::string subject;  ///< the UID that was read, or the tile whose tags are not: as more is read, it is the same
};

struct TagCheckOptions {
  Metres noise{0.05};           ///< of a read's place along each axis
  std::size_t leastReads = 2;   ///< of a tag that no tile has, before anything is said of it
  std::size_t surelyReads = 3;  ///< before it is taken for the tag of a place
  std::size_t leastPasses = 3;
  double improbable = 0.0001;  ///< of a good tag to be missed so often by chance
  /// When more than this share of the tags that were passed over often were never read, the vehicle is not where it is
  /// believed to be, or its readers see badly: then nothing is said of single tags.
  double mostMissed = 0.1;
};

/// tiles: what checkFloor() made of the same reads; tags of tiles that lie elsewhere are passed over. Unknown tags
/// first.
[[nodiscard]] std::vector<TagFinding> checkTags(const floor::Site& site, const std::vector<PlacedRead>& reads,
                                                const std::vector<TagPasses>& passes, const TileCheckResult& tiles,
                                                const TagCheckOptions& options = {});

}  // namespace tessera::tilecheck
