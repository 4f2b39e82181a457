// Lists every fault of a site, and after an edit looks again only at what the edit can concern.
#pragma once

#include <functional>
#include <memory>

#include "floor/site_map.h"
#include "sitecheck/checks.h"

namespace tessera::sitecheck {

/// What a check found. Parts that an edit did not concern are shared with the verdict before it.
class Verdict {
public:
  /// How many faults there are, those that one sentence tells of together among them.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t count(Severity severity) const;
  /// In an order that depends on the site alone.
  void forEach(const std::function<void(const Fault&)>& visit) const;
  [[nodiscard]] Faults faults() const;
  friend bool operator==(const Verdict& a, const Verdict& b);

private:
  friend class SiteChecker;
  std::vector<std::shared_ptr<const Faults>> parts_;
};

/// The site of a map, kept alive by the map.
[[nodiscard]] std::shared_ptr<const floor::Site> siteOf(const std::shared_ptr<const floor::SiteMap>& map);

/// Remembers the site that it checked last. The verdict is that of a full check, whatever was checked before.
class SiteChecker {
public:
  explicit SiteChecker(CheckOptions options = {}) : options_{options} {}
  /// With others the next check is a full one.
  void setOptions(const CheckOptions& options);
  /// Any site at all: also one that no map can be built of. Sections are compared by value.
  const Verdict& check(std::shared_ptr<const floor::Site> site);
  /// What would be wrong with this route in the site that was checked last, as while it is being drawn.
  [[nodiscard]] Faults tryRoute(const floor::Route& route) const;
  [[nodiscard]] const Verdict& verdict() const { return verdict_; }
  /// How many checks (a zone's gaps, a route's way and the like each count) ran last time.
  [[nodiscard]] std::size_t runs() const { return runs_; }

private:
  /// Of one zone or route each.
  using PerItem = std::vector<std::shared_ptr<const Faults>>;
  [[nodiscard]] Context context() const;
  /// What has changed, less what is known to concern only some tiles: those are told apart then.
  unsigned renewPlans(unsigned changed, const floor::Site* before, std::optional<FloorChange>& some);
  void renewFloor(unsigned changed, const floor::Site* before, std::optional<FloorChange>& some);
  /// isStale(i): item i has to be looked at though it is as it was.
  template <class Items, class IsStale, class Check>
  void runPerItem(PerItem& results, const Items* before, const Items& items, IsStale isStale, Check check);

  CheckOptions options_;
  std::shared_ptr<const floor::Site> site_;
  FloorPlan plan_;
  ZonePlan zones_;
  region::BoxTree looseTags_;
  Lattice lattice_;
  std::vector<RepeatedUid> repeated_;
  std::vector<std::uint32_t> registered_;
  std::vector<std::shared_ptr<const Faults>> whole_;  ///< of the checks that look at all at once
  PerItem gaps_;
  PerItem ways_;
  PerItem tags_;
  Verdict verdict_;
  std::size_t runs_ = 0;
};

/// A full check.
[[nodiscard]] Verdict checkSite(const floor::Site& site, const CheckOptions& options = {});

}  // namespace tessera::sitecheck
