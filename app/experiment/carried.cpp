#include "app/experiment/carried.h"

namespace tessera::experiment {
namespace {

constexpr Metres kWrong{0.10};
constexpr MetresPerSecond kNoVehicle{3.0};  // what is faster is being carried, as the truth between two of its lines is

bool sure(const Sample& s) { return s.belief.located && !s.belief.doubted; }
Metres errorOf(const Sample& s) { return distance(s.belief.pose.position, s.truth.pose.position); }

}  // namespace

std::optional<Metres> foundAfter(const std::vector<Sample>& samples, Seconds at) {
  Metres way;
  std::optional<Metres> since;
  Seconds from;
  const Sample* before = nullptr;
  for (const Sample& s : samples) {
    if (s.belief.at < at) continue;
    if (before != nullptr) {
      const Metres step = distance(before->truth.pose.position, s.truth.pose.position);
      if (step <= kNoVehicle * (s.belief.at - before->belief.at)) way += step;
    }
    before = &s;
    if (!sure(s) || errorOf(s) > kFoundWithin) {
      since.reset();
      continue;
    }
    if (!since) {
      since = way;
      from = s.belief.at;
    }
    if (s.belief.at - from >= kFoundFor) return since;
  }
  return std::nullopt;
}

Seconds wronglySure(const std::vector<Sample>& samples, Seconds at) {
  Seconds total;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i].belief.at >= at && sure(samples[i]) && errorOf(samples[i]) > kWrong)
      total += samples[i].belief.at - samples[i - 1].belief.at;
  return total;
}

}  // namespace tessera::experiment
