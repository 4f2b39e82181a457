#include "sitecheck/site_checker.h"

#include <algorithm>
#include <array>
#include <map>

namespace tessera::sitecheck {
namespace {

using floor::Site;

// Parts of a site that change apart from one another.
enum Section : unsigned {
  kRadio = 1,
  kTypes = 2,
  kTiles = 4,  ///< serial numbers and types
  kUids = 8,
  kPlacements = 16,
  kLooseTags = 32,
  kZones = 64,
  kRoutes = 128,
  kVehicles = 256,
  kAll = 511
};
constexpr unsigned kFloor = kTypes | kTiles | kPlacements;

unsigned changedTiles(const std::vector<floor::Tile>& a, const std::vector<floor::Tile>& b) {
  if (a.size() != b.size()) return kTiles | kUids;
  unsigned changed = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].serial != b[i].serial || a[i].type != b[i].type) changed |= kTiles;
    if (a[i].uids != b[i].uids) changed |= kUids;
  }
  return changed;
}

unsigned changedSections(const Site& a, const Site& b) {
  unsigned changed = changedTiles(a.tiles, b.tiles);
  const auto mark = [&changed](bool same, Section section) { changed |= same ? 0U : section; };
  mark(a.radio == b.radio, kRadio);
  mark(a.tileTypes == b.tileTypes, kTypes);
  mark(a.placements == b.placements, kPlacements);
  mark(a.looseTags == b.looseTags, kLooseTags);
  mark(a.zones == b.zones, kZones);
  mark(a.routes == b.routes, kRoutes);
  mark(a.vehicles == b.vehicles, kVehicles);
  return changed;
}

struct Check {
  unsigned reads;
  Faults (*run)(const Context&);
};

// What a check reads; a change of anything else leaves its result as it was.
constexpr std::array<Check, 13> kChecks{{{kFloor, checkTileNames},
                                         {kFloor | kUids, checkTwins},
                                         {kFloor | kUids | kLooseTags, checkUids},
                                         {kFloor | kUids, checkRegistration},
                                         {kFloor, checkLattice},
                                         {kZones, checkZoneShapes},
                                         {kZones, checkZoneStacking},
                                         {kZones, checkReach},
                                         {kRoutes, checkRouteNames},
                                         {kVehicles, checkVehicles},
                                         {kVehicles | kZones, checkStarts},
                                         {kRadio | kVehicles, checkRadio},
                                         {kPlacements | kLooseTags | kVehicles | kZones, checkEmpty}}};
// Of one zone or route beside the item itself. A no-go zone cuts holes into the floor of others: zones count as a
// whole.
constexpr unsigned kGapsRead = kFloor;
constexpr unsigned kWaysRead = kZones | kVehicles;
constexpr unsigned kTagsRead = kFloor | kUids | kLooseTags | kVehicles;

std::shared_ptr<const Faults> kept(Faults faults) { return std::make_shared<const Faults>(std::move(faults)); }

}  // namespace

std::size_t Verdict::size() const {
  std::size_t n = 0;
  forEach([&](const Fault& fault) { n += fault.stands; });
  return n;
}

std::size_t Verdict::count(Severity severity) const {
  std::size_t n = 0;
  forEach([&](const Fault& fault) { n += fault.severity == severity ? fault.stands : 0; });
  return n;
}

void Verdict::forEach(const std::function<void(const Fault&)>& visit) const {
  for (const auto& part : parts_)
    for (const Fault& fault : *part) visit(fault);
}

Faults Verdict::faults() const {
  Faults all;
  forEach([&](const Fault& fault) { all.push_back(fault); });
  return all;
}

bool operator==(const Verdict& a, const Verdict& b) { return a.faults() == b.faults(); }

std::shared_ptr<const Site> siteOf(const std::shared_ptr<const floor::SiteMap>& map) { return {map, &map->site()}; }

namespace {

// Tiles that have come or gone bring and take no registered tag, and the others have those that they had.
bool sameUids(const Site& before, const Site& now, const Alignment& tiles) {
  const auto isBare = [](const floor::Tile& tile) {
    return std::all_of(tile.uids.begin(), tile.uids.end(), [](const floor::TagUid& uid) { return uid.empty(); });
  };
  for (std::size_t i = 0; i < now.tiles.size(); ++i)
    if (tiles.wasAt[i] == kGone ? !isBare(now.tiles[i]) : now.tiles[i].uids != before.tiles[tiles.wasAt[i]].uids)
      return false;
  return std::all_of(tiles.gone.begin(), tiles.gone.end(), [&](auto i) { return isBare(before.tiles[i]); });
}

}  // namespace

Context SiteChecker::context() const {
  return {*site_, options_, plan_, zones_, looseTags_, lattice_, repeated_, registered_};
}

void SiteChecker::renewFloor(unsigned changed, const Site* before, std::optional<FloorChange>& some) {
  if (before != nullptr && (changed & kTypes) == 0) some = plan_.follow(*before, *site_);
  if (some) {
    lattice_.follow(plan_, options_, *some);
    return;
  }
  plan_ = FloorPlan{*site_, options_.seam};
  lattice_ = Lattice{plan_, options_};
}

unsigned SiteChecker::renewPlans(unsigned changed, const Site* before, std::optional<FloorChange>& some) {
  if (before == nullptr || (changed & kFloor) != 0) renewFloor(changed, before, some);
  if (before == nullptr || (changed & kZones) != 0) zones_ = ZonePlan{site_->zones};
  if (before == nullptr || (changed & kLooseTags) != 0) {
    std::vector<Box> boxes;
    boxes.reserve(site_->looseTags.size());
    for (const floor::LooseTag& tag : site_->looseTags) boxes.push_back({tag.place, tag.place});
    looseTags_ = region::BoxTree{boxes};
  }
  unsigned rest = changed;
  if (some) {
    rest &= ~kFloor;
    if (((changed & kUids) == 0) || sameUids(*before, *site_, some->tiles)) rest &= ~static_cast<unsigned>(kUids);
  }
  if (before == nullptr || (changed & (kTiles | kUids)) != 0) registered_ = registeredTags(*site_);
  if (before == nullptr || (rest & (kTiles | kUids | kLooseTags)) != 0) {
    repeated_ = repeatedUids(*site_);
  } else if (some) {
    for (RepeatedUid& repeated : repeated_)
      for (RepeatedUid::End* end : {&repeated.first, &repeated.later})
        if (end->tile != kGone) end->tile = some->tiles.nowAt[end->tile];
  }
  return rest;
}

// An item that was there before, just as it is now, keeps its result wherever in the list it stands.
template <class Items, class IsStale, class CheckItem>
void SiteChecker::runPerItem(PerItem& results, const Items* before, const Items& items, IsStale isStale,
                             CheckItem check) {
  PerItem old = std::move(results);
  results.clear();
  std::multimap<std::string_view, std::size_t> byName;
  if (before != nullptr)
    for (std::size_t i = 0; i < before->size(); ++i) byName.emplace((*before)[i].name, i);
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::shared_ptr<const Faults> found;
    const bool stale = before == nullptr || isStale(i);
    const auto [first, last] = byName.equal_range(items[i].name);
    for (auto at = first; at != last && !stale && !found; ++at)
      if ((*before)[at->second] == items[i]) found = old[at->second];
    if (!found) {
      found = kept(check(i));
      ++runs_;
    }
    results.push_back(std::move(found));
  }
}

void SiteChecker::setOptions(const CheckOptions& options) {
  if (options == options_) return;
  options_ = options;
  site_.reset();
}

const Verdict& SiteChecker::check(std::shared_ptr<const Site> site) {
  const std::shared_ptr<const Site> before = std::exchange(site_, std::move(site));
  const unsigned changed = before == nullptr ? kAll : before == site_ ? 0U : changedSections(*before, *site_);
  runs_ = 0;
  if (changed == 0) return verdict_;
  const region::Region noGo = zones_.noGo;
  const region::Region covered = plan_.covered();
  const bool wasBare = plan_.laid().empty();
  std::optional<FloorChange> some;
  const unsigned rest = renewPlans(changed, before.get(), some);
  const Context context = this->context();
  whole_.resize(kChecks.size());
  for (std::size_t i = 0; i < kChecks.size(); ++i) {
    if (before != nullptr && (kChecks.at(i).reads & changed) == 0) continue;
    whole_[i] = kept(kChecks.at(i).run(context));
    ++runs_;
  }
  const auto* zonesBefore = before ? &before->zones : nullptr;
  const auto* routesBefore = before ? &before->routes : nullptr;
  const bool isBare = plan_.laid().empty();
  if ((changed & (kGapsRead | kZones)) != 0)
    runPerItem(
        gaps_, zonesBefore, site_->zones,
        [&, all = covered != plan_.covered() || wasBare != isBare || noGo != zones_.noGo](std::size_t) { return all; },
        [&](std::size_t i) { return checkGaps(context, i); });
  if ((changed & (kWaysRead | kRoutes)) != 0)
    runPerItem(
        ways_, routesBefore, site_->routes, [all = (changed & kWaysRead) != 0](std::size_t) { return all; },
        [&](std::size_t i) {
          Faults faults = checkRouteWay(context, site_->routes[i]);
          offerRouteFixes(context, site_->routes[i], faults);
          return faults;
        });
  if ((changed & (kTagsRead | kRoutes)) != 0)
    runPerItem(
        tags_, routesBefore, site_->routes,
        [&, all = (rest & kTagsRead) != 0 || wasBare != isBare](std::size_t i) {
          return all || (some && passesNear(context, site_->routes[i], some->places));
        },
        [&](std::size_t i) { return checkRouteTags(context, site_->routes[i]); });
  verdict_.parts_ = whole_;
  for (const PerItem* items : {&gaps_, &ways_, &tags_})
    verdict_.parts_.insert(verdict_.parts_.end(), items->begin(), items->end());
  return verdict_;
}

Faults SiteChecker::tryRoute(const floor::Route& route) const {
  if (site_ == nullptr) return {};
  const Context context = this->context();
  // What is not in the site yet cannot be mended there.
  Faults faults = checkRouteWay(context, route);
  Faults blind = checkRouteTags(context, route);
  faults.insert(faults.end(), blind.begin(), blind.end());
  return faults;
}

Verdict checkSite(const Site& site, const CheckOptions& options) {
  SiteChecker checker{options};
  // Not owned: it outlives the checker.
  return checker.check(std::shared_ptr<const Site>{std::shared_ptr<const Site>{}, &site});
}

}  // namespace tessera::sitecheck
