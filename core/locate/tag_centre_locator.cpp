#include "locate/tag_centre_locator.h"

#include <algorithm>
#include <cmath>

namespace tessera::locate {

TagCentreLocator::TagCentreLocator(std::shared_ptr<const floor::SiteMap> map, const floor::VehicleSetup& vehicle)
    : intake_{std::move(map), vehicle.readers.size()}, vehicle_{vehicle}, odometry_{vehicle.maxSpeed} {
  reset(vehicle.start);
}

void TagCentreLocator::reset(std::optional<Pose> pose) {
  odometry_.clear();
  known_ = pose.has_value();
  pending_ = false;
  anchorAt_ = Seconds{};
  anchor_ = pose ? pose->position : Point{};
}

void TagCentreLocator::add(const Motion& motion) {
  const bool first = odometry_.empty();
  // Before the anchor falls out of the odometry's history it is moved up to the newest sample.
  if (!first && known_ && odometry_.last() - anchorAt_ > 0.8 * kHistory) {
    anchor_ = after(odometry_.last() - 0.5 * kHistory);
    anchorAt_ = odometry_.last() - 0.5 * kHistory;
  }
  if (!odometry_.add(motion)) {
    ++intake_.counters.tooLate;
    return;
  }
  if (!first) return;
  if (known_ && !pending_) anchorAt_ = motion.at;
  if (pending_) {
    anchor_ = anchor_ - turned(vehicle_.readers[static_cast<std::size_t>(reader_)], motion.heading);
    pending_ = false;
    known_ = true;
  }
}

void TagCentreLocator::add(const TagRead& read) {
  ++intake_.counters.reads;
  if (!intake_.valid(read.reader, read.at)) return;
  const std::optional<Point> place = intake_.placeOf(read.uid);
  if (!place) return;
  if (known_ && read.at < anchorAt_) {
    ++intake_.counters.tooLate;
    return;
  }
  anchorAt_ = read.at;
  reader_ = read.reader;
  pending_ = odometry_.empty();
  if (pending_) {
    anchor_ = *place;
    return;
  }
  if (!known_) ++intake_.counters.reacquisitions;
  const Radians heading{odometry_.at(read.at.value()).heading};
  anchor_ = *place - turned(vehicle_.readers[static_cast<std::size_t>(read.reader)], heading);
  known_ = true;
}

void TagCentreLocator::add(const TagLeft& left) { static_cast<void>(intake_.valid(left.reader, left.at)); }

Point TagCentreLocator::after(Seconds until) const {
  Point place = anchor_;
  odometry_.walk(anchorAt_.value(), until.value(), [&](const Odometry::Sample& from, const Odometry::Sample& to) {
    place = place + turned({Metres{to.travel - from.travel}, Metres{}}, Radians{0.5 * (from.heading + to.heading)});
  });
  return place;
}

Estimate TagCentreLocator::at(Seconds now) const {
  Estimate estimate;
  estimate.at = now;
  if (odometry_.empty() || !std::isfinite(now.value())) return estimate;
  const Odometry::Sample sample = odometry_.at(now.value());
  const double variance = vehicle_.readerRadius.value() * vehicle_.readerRadius.value() / 4.0;
  estimate.pose = {after(now), wrapped(Radians{sample.heading})};
  estimate.covariance.diagonal() << variance, variance, 0.0025;
  estimate.speed = MetresPerSecond{sample.speed};
  estimate.turnRate = RadiansPerSecond{sample.turnRate};
  estimate.located = known_;
  return estimate;
}

}  // namespace tessera::locate
