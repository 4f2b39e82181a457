// The layout of the database, in numbered steps from the first version on. A step that has been released is never
// changed: what comes next is a new one.
#pragma once

#include "store/database.h"

namespace tessera::store {

/// The newest layout that this program knows.
[[nodiscard]] int newestVersion();

/// The layout that the file has, 0 when it is empty. Error: it is not one of this program's, or was made by a newer
/// version of it. Writes nothing.
[[nodiscard]] Result<int> checkVersion(Database& database);

/// Takes the steps after `from`, each in a transaction of its own. Writes nothing when there is none.
[[nodiscard]] Result<void> migrate(Database& database, int from);

}  // namespace tessera::store
