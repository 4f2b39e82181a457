#include "drive/stretch_limits.h"

#include <algorithm>
#include <optional>

#include "base/polyline.h"
#include "floor/route_legs.h"

namespace tessera::drive {
namespace {

constexpr Metres kBefore{0.02};  // of a slower stretch, in which the last of the braking dies away

// One after the other, each with the lowest speed of those that lie there.
std::vector<SpeedStretch> parted(std::vector<SpeedStretch> all) {
  std::sort(all.begin(), all.end(), [](const SpeedStretch& a, const SpeedStretch& b) { return a.from < b.from; });
  const auto overlap = [](const SpeedStretch& a, const SpeedStretch& b) { return b.from < a.to; };
  if (std::adjacent_find(all.begin(), all.end(), overlap) == all.end()) return all;
  std::vector<Metres> cuts;
  for (const SpeedStretch& stretch : all) {
    cuts.push_back(stretch.from);
    cuts.push_back(stretch.to);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<SpeedStretch> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (!(cuts[i] < cuts[i + 1])) continue;
    std::optional<MetresPerSecond> lowest;
    for (const SpeedStretch& stretch : all)
      if (stretch.from <= cuts[i] && cuts[i + 1] <= stretch.to && (!lowest || stretch.speed < *lowest))
        lowest = stretch.speed;
    if (!lowest) continue;
    if (!parts.empty() && parts.back().to == cuts[i] && parts.back().speed == *lowest)
      parts.back().to = cuts[i + 1];
    else
      parts.push_back({cuts[i], cuts[i + 1], *lowest});
  }
  return parts;
}

}  // namespace

StretchLimits::StretchLimits(Of of, std::vector<SpeedStretch> stretches) : stretches_{parted(std::move(stretches))} {
  if (of == Of::Zones) {
    here_ = SpeedReason::Zone;
    before_ = SpeedReason::SlowZone;
  } else if (of == Of::Bends) {
    here_ = before_ = SpeedReason::Bend;
  }
}

StretchLimits StretchLimits::ofLegs(const floor::Route& route, const RoundedLine& way) {
  const Polyline line{route.vertices};
  const auto speeds = floor::legSpeedsOfLine(route);
  std::vector<SpeedStretch> legs;
  for (std::size_t leg = 0; leg < line.legCount(); ++leg)
    if (speeds[leg]) legs.push_back({way.onLine(line.startOf(leg)), way.onLine(line.startOf(leg + 1)), *speeds[leg]});
  return {Of::Legs, std::move(legs)};
}

SpeedLimit StretchLimits::at(Metres along, Metres doubt, Seconds delay, const SpeedPlan& plan, Metres from) const {
  SpeedLimit limit{MetresPerSecond{std::numeric_limits<double>::infinity()}, here_};
  const double top = std::min(plan.options().requested, plan.ability().maxSpeed).value();
  const Metres behind = std::max(along - doubt, from);
  const auto first = std::partition_point(stretches_.begin(), stretches_.end(),
                                          [&](const SpeedStretch& stretch) { return stretch.to <= behind; });
  for (auto at = first; at != stretches_.end(); ++at) {
    const Metres way = std::max(at->from, from) - (along + doubt + kBefore);
    if (brakingSpeed(way, {}, delay, plan.braking()).value() > top) break;  // as is every later one
    const bool here = way <= Metres{};
    const MetresPerSecond speed = here ? at->speed : brakingSpeed(way, at->speed, delay, plan.braking());
    if (speed < limit.speed) limit = {speed, here ? here_ : before_};
  }
  return limit;
}

}  // namespace tessera::drive
