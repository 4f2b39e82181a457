// How often vehicles drove over each tag so that a reader should have seen it, and how often one did.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "floor/site_map.h"

namespace tessera::tilecheck {

/// Of one tag.
struct TagPasses {
  floor::TagUid uid;
  std::size_t passes = 0;
  std::size_t hits = 0;  ///< in which it was read
};

class PassCounter {
public:
  /// A vehicle is believed to be here; instants of a vehicle in their order. Tags are those of the map.
  void moved(const floor::SiteMap& map, const floor::VehicleSetup& vehicle, Seconds at, const Pose& pose);
  /// Where it is is not known, or was not where it was believed to be: what it was just passing does not count.
  void lost(VehicleId vehicle);
  /// May be told some seconds later.
  void read(VehicleId vehicle, const floor::TagUid& uid, Seconds at);
  void clear();
  /// Passes of which all reads have come by now. In the order of their first pass.
  [[nodiscard]] std::vector<TagPasses> passes(Seconds now) const;

private:
  struct Pass {
    VehicleId vehicle;
    Seconds from;
    Seconds to;
    bool hit = false;
  };
  struct OfTag {
    std::size_t order = 0;
    std::vector<Pass> open;  ///< one of a vehicle
    std::vector<Pass> over;  ///< the latest
    std::optional<Seconds> lastRead;
  };
  struct Vehicle {
    Seconds at;
    Pose pose;
    std::vector<floor::TagUid> over;  ///< tags that are just passed
  };

  static constexpr std::size_t kMostOfATag = 20;

  std::unordered_map<VehicleId, Vehicle> vehicles_;
  std::unordered_map<floor::TagUid, OfTag> ofTag_;
};

}  // namespace tessera::tilecheck
