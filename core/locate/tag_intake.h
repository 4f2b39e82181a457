// What every locator asks of a tag read before it takes it in: is there such a reader, is its instant one, does the
// map have the tag. Counts what it refuses.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "floor/site_map.h"
#include "locate/locator.h"

namespace tessera::locate {

class TagIntake {
public:
  TagIntake(std::shared_ptr<const floor::SiteMap> map, std::size_t readers) : map_{std::move(map)}, readers_{readers} {}

  void useMap(std::shared_ptr<const floor::SiteMap> map) { map_ = std::move(map); }
  [[nodiscard]] bool valid(int reader, Seconds at) {
    if (reader >= 0 && static_cast<std::size_t>(reader) < readers_ && std::isfinite(at.value())) return true;
    ++counters.invalid;
    return false;
  }
  /// Where the tag lies; nothing when the map does not have it.
  [[nodiscard]] std::optional<Point> placeOf(const floor::TagUid& uid) {
    const std::optional<Point> place = map_->find(uid);
    if (!place) ++counters.unknownTags;
    return place;
  }

  LocatorCounters counters;  ///< the locator's; it counts what it refuses itself as well

private:
  std::shared_ptr<const floor::SiteMap> map_;
  std::size_t readers_;
};

}  // namespace tessera::locate
