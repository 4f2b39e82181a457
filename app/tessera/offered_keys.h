// Keys on their way to vehicles, kept in a file before they are sent: a vehicle that took its new key obeys no other,
// even if this program ended before any site had it.
#pragma once

#include <QString>
#include <map>
#include <optional>

#include "base/ids.h"
#include "base/result.h"
#include "floor/site.h"

namespace tessera::desktop {

class OfferedKeys {
public:
  /// Of the program's data folder; a file that cannot be read counts as empty.
  OfferedKeys();

  /// Error: it is not on the disk; then the key must not be sent.
  [[nodiscard]] Result<void> add(VehicleId vehicle, const wire::Key& key);
  /// What vehicles of the site may have taken, apart from keys that one of them has there.
  [[nodiscard]] std::map<VehicleId, wire::Key> unknownTo(const floor::Site& site) const;
  /// A file has this site now: its keys need no second place.
  void forget(const floor::Site& site);

private:
  [[nodiscard]] Result<void> write() const;

  QString path_;
  std::map<VehicleId, wire::Key> keys_;
};

}  // namespace tessera::desktop
