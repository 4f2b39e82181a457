// Which tags an edit takes away and brings, so that the table of a million tags need not be made anew for one tile.
#pragma once

#include <optional>
#include <vector>

#include "floor/site_patch.h"
#include "floor/tag_table.h"

namespace tessera::floor {

struct TagChange {
  std::vector<TagUid> removed;
  std::vector<PlacedTag> added;  ///< may hold what `removed` does, at another place or at the same
};

/// What `change`, which leads from `before` to `after`, does to the registered, laid tags. `before` has to be a site
/// that a map was built of. Nothing: types changed, more than a part of the floor changed, or something about `after`
/// is ambiguous; whoever makes the table anew is told what.
[[nodiscard]] std::optional<TagChange> tagChange(const Site& before, const Site& after, const SitePatch& change);

}  // namespace tessera::floor
