#include "traffic/right_of_way.h"

#include <algorithm>

namespace tessera::traffic {
namespace {

bool has(const RightOfWay::Zones& zones, std::size_t zone) {
  return std::find(zones.begin(), zones.end(), zone) != zones.end();
}

}  // namespace

void RightOfWay::standsIn(VehicleId vehicle, const Zones& zones) {
  // Most vehicles never come near a zone.
  const auto found = vehicles_.find(vehicle);
  if (found != vehicles_.end())
    found->second.inside = zones;
  else if (!zones.empty())
    vehicles_[vehicle].inside = zones;
}

// All that keeps it from what it wants: those that are there, those that may be, and those that came first.
std::vector<RightOfWay::Wait> RightOfWay::blockers(VehicleId vehicle, const Entry& entry) const {
  std::vector<Wait> found;
  for (const std::size_t zone : entry.wanted) {
    if (has(entry.inside, zone) || has(entry.granted, zone)) continue;
    for (const auto& [other, its] : vehicles_) {
      if (other == vehicle) continue;
      if (has(its.inside, zone))
        found.push_back({Why::Inside, zone, other});
      else if (has(its.granted, zone))
        found.push_back({Why::HasRight, zone, other});
      else if (has(its.wanted, zone) && its.number < entry.number)
        found.push_back({Why::CameFirst, zone, other});
    }
  }
  return found;
}

bool RightOfWay::leadsTo(VehicleId from, VehicleId to, std::set<VehicleId>& seen) const {
  if (!seen.insert(from).second) return false;
  const auto found = vehicles_.find(from);
  if (found == vehicles_.end()) return false;
  const std::vector<Wait> all = blockers(from, found->second);
  return std::any_of(all.begin(), all.end(), [&](const Wait& w) { return w.whom == to || leadsTo(w.whom, to, seen); });
}

std::optional<RightOfWay::Wait> RightOfWay::inTheWay(VehicleId vehicle, const Entry& entry) const {
  std::optional<Wait> first;
  for (Wait& wait : blockers(vehicle, entry)) {
    std::set<VehicleId> seen;
    const bool circle = leadsTo(wait.whom, vehicle, seen);
    // Who came first does not go first where it would wait for this one.
    if (wait.why == Why::CameFirst && circle) continue;
    if (circle) wait.why = Why::EachOther;
    if (!first || wait.why == Why::EachOther || (first->why == Why::CameFirst && wait.why != Why::CameFirst))
      first = wait;
  }
  return first;
}

bool RightOfWay::ask(VehicleId vehicle, const Zones& zones) {
  Entry& entry = vehicles_[vehicle];
  const bool all = std::all_of(zones.begin(), zones.end(), [&](std::size_t zone) { return has(entry.granted, zone); });
  if (all) return true;
  if (entry.wanted != zones) {
    entry.wanted = zones;
    entry.number = ++numbers_;
  }
  if (inTheWay(vehicle, entry)) return false;
  for (const std::size_t zone : zones)
    if (!has(entry.granted, zone)) entry.granted.push_back(zone);
  entry.wanted.clear();
  return true;
}

void RightOfWay::keepOnly(VehicleId vehicle, const Zones& zones, bool waits) {
  const auto found = vehicles_.find(vehicle);
  if (found == vehicles_.end()) return;
  Entry& entry = found->second;
  std::erase_if(entry.granted, [&](std::size_t zone) { return !has(zones, zone); });
  if (!waits) entry.wanted.clear();
  if (entry.inside.empty() && entry.granted.empty() && entry.wanted.empty()) vehicles_.erase(found);
}

std::optional<RightOfWay::Wait> RightOfWay::waitsFor(VehicleId vehicle) const {
  const auto found = vehicles_.find(vehicle);
  return found == vehicles_.end() ? std::nullopt : inTheWay(vehicle, found->second);
}

}  // namespace tessera::traffic
