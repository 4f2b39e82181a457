#include "app/experiment/samples.h"

#include <algorithm>

namespace tessera::experiment {

std::optional<Truth> TruthTrack::at(Seconds when) const {
  if (poses_.empty() || when < poses_.front().at || when > poses_.back().at) return std::nullopt;
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), when, [](const Truth& t, Seconds s) { return t.at < s; });
  if (after == poses_.begin() || after->at == when) return *after;
  const Truth& a = *std::prev(after);
  const Truth& b = *after;
  const double part = (when - a.at) / (b.at - a.at);
  Truth result;
  result.at = when;
  result.pose.position = a.pose.position + part * (b.pose.position - a.pose.position);
  result.pose.heading = wrapped(a.pose.heading + turnBetween(a.pose.heading, b.pose.heading) * part);
  result.speed = a.speed + (b.speed - a.speed) * part;
  return result;
}

std::vector<Sample> pair(const std::vector<Belief>& beliefs, const TruthTrack& truth) {
  std::vector<Sample> samples;
  samples.reserve(beliefs.size());
  for (const Belief& belief : beliefs) {
    if (const auto t = truth.at(belief.at)) samples.push_back({belief, *t});
  }
  return samples;
}

}  // namespace tessera::experiment
