// Who may be in which single-vehicle zone. First come, first served; a vehicle gets all the zones that it asks for at
// once or none of them.
//
// Nobody waits for ever on that account: a vehicle that waits outside holds nothing, and one that stands in a zone (it
// was put there, or was there before the zone was drawn) goes before those that wait for it to leave. What is left are
// vehicles that stand in each other's way; those are named.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "base/ids.h"

namespace tessera::traffic {

class RightOfWay {
public:
  using Zones = std::vector<std::size_t>;

  enum class Why {
    Inside,     ///< the other one is in the zone
    HasRight,   ///< it may drive into it, or may not have left it
    CameFirst,  ///< it waits for the same and has come first
    EachOther,  ///< it is in the zone and waits, in the end, for this one
  };
  struct Wait {
    Why why = Why::Inside;
    std::size_t zone = 0;
    VehicleId whom;
  };

  /// Where the vehicle's body is now; there it is, rightly or not.
  void standsIn(VehicleId vehicle, const Zones& zones);
  /// True: it has the right to all of them, and keeps it until keepOnly. False: it waits, in the order of coming.
  [[nodiscard]] bool ask(VehicleId vehicle, const Zones& zones);
  /// Gives up the right to all others, and with `waits` false also its place among those that wait.
  void keepOnly(VehicleId vehicle, const Zones& zones, bool waits);
  /// For what a vehicle that was told to wait waits; nullopt: it does not, or nothing is in its way any more.
  [[nodiscard]] std::optional<Wait> waitsFor(VehicleId vehicle) const;
  void clear() { vehicles_.clear(); }

private:
  struct Entry {
    Zones inside;
    Zones granted;
    Zones wanted;              ///< empty: it waits for nothing
    std::uint64_t number = 0;  ///< of the request, in the order of coming
  };
  [[nodiscard]] std::vector<Wait> blockers(VehicleId vehicle, const Entry& entry) const;
  [[nodiscard]] bool leadsTo(VehicleId from, VehicleId to, std::set<VehicleId>& seen) const;
  [[nodiscard]] std::optional<Wait> inTheWay(VehicleId vehicle, const Entry& entry) const;

  std::map<VehicleId, Entry> vehicles_;
  std::uint64_t numbers_ = 0;
};

}  // namespace tessera::traffic
