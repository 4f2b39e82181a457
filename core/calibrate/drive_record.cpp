#include "calibrate/drive_record.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace tessera::calibrate {
namespace {

constexpr Radians kTrembles{0.15};

}  // namespace

void DriveRecord::add(const locate::Motion& motion) {
  if (motions_.size() == kMost || (!motions_.empty() && motion.at <= motions_.back().at)) return;
  locate::Motion next = motion;
  if (motions_.empty()) {
    counted_ = motion.heading;
  } else {
    const Radians last = motions_.back().heading;
    next.heading = last + turnBetween(last, motion.heading);
    const Radians more = abs(next.heading - counted_);
    if (more > kTrembles) {
      turned_ += more;
      counted_ = next.heading;
    }
  }
  motions_.push_back(next);
}

void DriveRecord::add(const PlacedRead& read) {
  if (reads_.size() < kMost) reads_.push_back(read);
}

void DriveRecord::clear() { *this = {}; }

Metres DriveRecord::length() const {
  Metres sum{};
  for (std::size_t i = 1; i < motions_.size(); ++i) sum += abs(motions_[i].travel - motions_[i - 1].travel);
  return sum;
}

bool DriveRecord::covers(Seconds at) const {
  return !motions_.empty() && at >= motions_.front().at && at <= motions_.back().at;
}

locate::Motion DriveRecord::at(Seconds at) const {
  const auto after = std::lower_bound(motions_.begin(), motions_.end(), at,
                                      [](const locate::Motion& m, Seconds t) { return m.at < t; });
  if (after == motions_.begin()) return motions_.front();
  const locate::Motion& a = *std::prev(after);
  const locate::Motion& b = *after;
  const double share = (at - a.at) / (b.at - a.at);
  return {at, a.travel + share * (b.travel - a.travel), a.speed + share * (b.speed - a.speed),
          a.heading + share * (b.heading - a.heading)};
}

Movement DriveRecord::between(Seconds from, Seconds until) const {
  Movement movement;
  locate::Motion a = at(from);
  const Radians first = a.heading;
  const auto step = [&](const locate::Motion& b) {
    const Metres travel = b.travel - a.travel;
    // An arc's chord points along the middle heading.
    const double half = 0.5 * (b.heading - a.heading).value();
    const double chord = std::abs(half) > 1e-4 ? std::sin(half) / half : 1.0;
    movement.way = movement.way + tessera::turned({chord * travel, Metres{}}, 0.5 * (a.heading + b.heading));
    movement.length += abs(travel);
    a = b;
  };
  auto next = std::upper_bound(motions_.begin(), motions_.end(), from,
                               [](Seconds t, const locate::Motion& m) { return t < m.at; });
  for (; next != motions_.end() && next->at < until; ++next) step(*next);
  step(at(until));
  movement.turn = a.heading - first;
  return movement;
}

}  // namespace tessera::calibrate
