#include "locate/poll_clock.h"

#include <algorithm>
#include <cmath>

namespace tessera::locate {
namespace {

constexpr double kFastestPoll = 0.02;    // s; the vehicle asks its readers a hundred times a second
constexpr double kNextPoll = 1.05;       // from candidate to candidate
constexpr double kVisitReading = 0.008;  // s; instants are told in hundredths
constexpr double kPollJitter = 0.03;     // of the period, of each attempt
constexpr double kLongestVisit = 0.6;    // s; what lasts longer tells nothing more
constexpr int kVisitsToBelieve = 4;
constexpr double kOddVisit = 1e-3;  // a visit that fits nothing

}  // namespace

void PollClock::visit(double lasted) {
  if (!(lasted > kVisitReading) || lasted > kLongestVisit) return;
  ++visits_;
  double period = kFastestPoll;
  double best = -1e300;
  for (std::size_t i = 0; i < kCandidates; ++i, period *= kNextPoll) {
    const double attempts = std::max(1.0, std::round(lasted / period));
    const double sigma = std::hypot(kVisitReading, kPollJitter * period * std::sqrt(attempts)) + 0.02 * period;
    const double off = (lasted - attempts * period) / sigma;
    // Short periods fit everything: what they could have shown instead is held against them.
    score_[i] += std::log(kOddVisit + period / sigma * std::exp(-0.5 * off * off));
    const bool usual = std::abs(period - kUsual) < 0.03 * kUsual;
    if (score_[i] + (usual ? 1.0 : 0.0) <= best) continue;
    best = score_[i] + (usual ? 1.0 : 0.0);
    if (visits_ >= kVisitsToBelieve) period_ = usual ? kUsual : period;
  }
}

}  // namespace tessera::locate
