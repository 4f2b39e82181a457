// The immutable picture of a site that the supervisor works with: every registered tag with its place, found by UID in
// constant time and by place through a grid. An edit makes a new one; holders of the old one are not disturbed.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/pose.h"
#include "floor/site.h"

namespace tessera::floor {

struct PlacedTag {
  TagUid uid;
  Point place;
};

class SiteMap {
public:
  /// Error: a site that contradicts itself in a way that makes places ambiguous (a UID at two places, a placement of an
  /// unknown tile, a tile laid twice, a tile of unknown type, too many UIDs); the sentence names it.
  [[nodiscard]] static Result<std::shared_ptr<const SiteMap>> build(Site site);

  [[nodiscard]] const Site& site() const;
  [[nodiscard]] const std::vector<PlacedTag>& tags() const;
  /// Site-frame place of a registered and placed tag.
  [[nodiscard]] std::optional<Point> find(const TagUid& uid) const;
  /// Calls visit(const PlacedTag&) for every tag within `radius` of `centre`, in the order of tags().
  template <class Visit>
  void forEachNear(Point centre, Metres radius, Visit&& visit) const;
  [[nodiscard]] const Route* route(const std::string& name) const;
  [[nodiscard]] const VehicleSetup* vehicle(VehicleId id) const;
};

}  // namespace tessera::floor
