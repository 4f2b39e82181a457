// What stands beside a revision of a site. Free of Qt, as it waits in the queue.
#pragma once

#include <cstdint>
#include <string>

namespace tessera::store {

struct RevisionNote {
  std::int64_t savedUtcMs = 0;
  std::string who;     ///< empty: nobody knows
  std::string what;    ///< names of the steps since the saving before, in the language in which they were made
  bool found = false;  ///< not saved here: as its file was when it was opened
  bool operator==(const RevisionNote&) const = default;
};

}  // namespace tessera::store
