#include "app/experiment/metrics.h"

#include <algorithm>
#include <cmath>

namespace tessera::experiment {
namespace {

// How far the projection may move between two samples; far less than the distance to a parallel leg along the route.
constexpr Metres kWindow{0.30};
// Inside a corner two legs are equally near, and a tremble of a millimetre would make the nearest one flip by
// centimetres along the route. Of places that are as near as this, the one next to the last progress counts.
constexpr Metres kAsNear{0.01};

// Root of a mean of squares, fed one by one.
class RootMeanSquare {
public:
  void add(double v) {
    sum_ += v * v;
    ++count_;
  }
  [[nodiscard]] double value() const { return count_ == 0 ? 0.0 : std::sqrt(sum_ / static_cast<double>(count_)); }

private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

bool awayFromVertices(const Polyline& route, Metres along, Metres margin) {
  for (std::size_t v = 0; v < route.vertices().size(); ++v) {
    if (abs(along - route.startOf(v)) < margin) return false;
  }
  return true;
}

// Counts falls of the progress by more than kReversal; one fall is one reversal however deep it goes.
class ReversalCounter {
public:
  void add(Metres along) {
    high_ = std::max(high_, along);
    if (!falling_ && high_ - along > kReversal) {
      falling_ = true;
      ++count_;
    }
    if (falling_ && along >= high_) falling_ = false;
    if (falling_) {
      low_ = std::min(low_, along);
      if (along - low_ > kReversal) {  // turned forward again: the next fall is a new one
        falling_ = false;
        high_ = along;
        low_ = Metres{1e9};
      }
    }
  }
  [[nodiscard]] int count() const { return count_; }

private:
  Metres high_{-1e9};
  Metres low_{1e9};
  bool falling_ = false;
  int count_ = 0;
};

}  // namespace

Polyline::Projection ProgressTracker::update(Point truth) {
  const Metres from = along_ - kWindow;
  const Metres to = along_ + kWindow;
  const auto best = route_.project(truth, from, to);
  auto chosen = best;
  for (std::size_t leg = 0; leg < route_.legCount(); ++leg) {
    const Metres legFrom = std::max(from, route_.startOf(leg));
    const Metres legTo = std::min(to, route_.startOf(leg + 1));
    if (legFrom > legTo) continue;
    const auto candidate = route_.project(truth, legFrom, legTo);
    if (abs(candidate.across) > abs(best.across) + kAsNear) continue;
    if (abs(candidate.along - along_) < abs(chosen.along - along_)) chosen = candidate;
  }
  along_ = chosen.along;
  return {chosen.along, best.across, chosen.leg, best.nearest};
}

Metrics evaluate(const Polyline& route, const std::vector<Sample>& samples, MetresPerSecond asked,
                 Metres cornerMargin) {
  Metrics m;
  if (route.legCount() == 0) return m;
  std::vector<double> errors, nees;
  RootMeanSquare heading, cross, crossOff;
  ReversalCounter reversals;
  ProgressTracker progress{route};
  double speedSum = 0;
  std::size_t speedCount = 0, located = 0;
  Seconds first, last;
  for (const Sample& s : samples) {
    if (!s.belief.driving) continue;
    if (errors.empty()) first = s.belief.at;
    last = s.belief.at;
    errors.push_back(distance(s.belief.pose.position, s.truth.pose.position).value());
    heading.add(turnBetween(s.truth.pose.heading, s.belief.pose.heading).value());
    located += s.belief.located ? 1 : 0;
    if (located > 0) m.positionErrorMax = std::max(m.positionErrorMax, Metres{errors.back()});
    if (const auto one = neesOf(s); one && s.belief.located) nees.push_back(*one);
    const auto p = progress.update(s.truth.pose.position);
    reversals.add(p.along);
    const double off = abs(p.across).value();
    cross.add(off);
    m.crossTrackMax = std::max(m.crossTrackMax, Metres{off});
    if (awayFromVertices(route, p.along, cornerMargin)) {
      crossOff.add(off);
      m.crossTrackMaxOffCorners = std::max(m.crossTrackMaxOffCorners, Metres{off});
      speedSum += s.truth.speed.value();
      ++speedCount;
    }
    m.endError = distance(s.truth.pose.position, route.vertices().back());
  }
  if (errors.empty()) return m;
  m.samples = errors.size();
  double sum = 0;
  for (double e : errors) sum += e;
  m.positionErrorMean = Metres{sum / static_cast<double>(errors.size())};
  const auto p95 = static_cast<std::size_t>(0.95 * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(p95), errors.end());
  m.positionErrorP95 = Metres{errors[p95]};
  m.headingErrorRms = Radians{heading.value()};
  m.crossTrackRms = Metres{cross.value()};
  m.crossTrackRmsOffCorners = Metres{crossOff.value()};
  m.reversals = reversals.count();
  m.consistency = consistencyOf(nees);
  m.meanSpeedRatio =
      speedCount == 0 || asked.value() <= 0 ? 0 : speedSum / static_cast<double>(speedCount) / asked.value();
  m.duration = last - first;
  m.locatedShare = static_cast<double>(located) / static_cast<double>(m.samples);
  return m;
}

}  // namespace tessera::experiment
