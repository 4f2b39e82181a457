// The immutable picture of a site that the supervisor works with: the site, found free of contradictions, and the table
// of its tags. An edit makes a new one; holders of the old one are not disturbed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/pose.h"
#include "floor/contradiction.h"
#include "floor/site_patch.h"
#include "floor/tag_table.h"

namespace tessera::floor {

/// What to do with a site in which a name or a UID has two meanings, or none.
enum class Ambiguity {
  Refused,  ///< there is no map of it
  Carried   ///< there is one to mend the site with: what is ambiguous is no tag there, and nobody may drive by it
};

class SiteMap {
public:
  /// Error: a site that contradicts itself in a way that makes places or names ambiguous (a UID at two places, a
  /// placement of an unknown tile, a tile laid twice, a tile of unknown type, too many UIDs, two types, tiles, routes
  /// or vehicles of one name), the sentence names it; or, carried or not, a place that is no number.
  [[nodiscard]] static Result<std::shared_ptr<const SiteMap>> build(Site site,
                                                                    Ambiguity ambiguity = Ambiguity::Refused);
  /// The same for the site that `change` makes of the one of `before`: what the change leaves alone is not looked at,
  /// and the table of tags is shared, or mended where a few tags moved. What is ambiguous in `before` already may stay
  /// so while it is mended step by step; something new is refused.
  [[nodiscard]] static Result<std::shared_ptr<const SiteMap>> rebuild(Site site, const SiteMap& before,
                                                                      const SitePatch& change,
                                                                      Ambiguity ambiguity = Ambiguity::Refused);

  [[nodiscard]] const Site& site() const { return site_; }
  /// Empty unless the map was built with Ambiguity::Carried: then no vehicle may be led by it.
  [[nodiscard]] const Contradictions& contradictions() const { return contradictions_; }
  /// Ordered by grid cell, row by row from the lower left.
  [[nodiscard]] const std::vector<PlacedTag>& tags() const { return table_->tags(); }
  /// Site-frame place of a registered and placed tag.
  [[nodiscard]] std::optional<Point> find(const TagUid& uid) const { return table_->find(uid); }
  /// Calls visit(const PlacedTag&) for every tag within `radius` of `centre`, in the order of tags().
  template <class Visit>
  void forEachNear(Point centre, Metres radius, Visit&& visit) const {
    table_->forEachNear(centre, radius, std::forward<Visit>(visit));
  }
  [[nodiscard]] const Route* route(const std::string& name) const;
  [[nodiscard]] const VehicleSetup* vehicle(VehicleId id) const;

private:
  SiteMap() = default;
  static std::shared_ptr<const SiteMap> with(Site site, std::shared_ptr<const TagTable> table, Contradictions told);
  Site site_;
  Contradictions contradictions_;
  std::shared_ptr<const TagTable> table_;
};

}  // namespace tessera::floor
