#include "locate/particle_locator.h"

#include <algorithm>
#include <cmath>

namespace tessera::locate {
namespace {

constexpr double kCloudLeastSweep = 0.003;  // m; a reader that moved less tries the same place again
constexpr double kCloudLeastTurn = 0.02;    // rad
constexpr double kCloudMargin = 0.02;       // s before the instant up to which all is told; attempts tremble ...
constexpr double kCloudTremble = 0.5;       // ... by this share of their period
constexpr double kCloudVague = 0.12;        // m; a place less known than this makes silence say nothing
constexpr std::size_t kCloudMostTags = 8;   // near one reader
constexpr double kCloudSpread = 3.5;        // deviations of the place within which tags matter
constexpr std::uint64_t kCloudKey = 0x7E55E2A;
constexpr std::uint64_t kRivalKey = 0x51BA1;

}  // namespace

ParticleLocator::ParticleLocator(std::shared_ptr<const floor::SiteMap> map, const floor::VehicleSetup& vehicle,
                                 const ParticleOptions& options)
    : intake_{map, vehicle.readers.size()},
      map_{std::move(map)},
      vehicle_{vehicle},
      options_{options},
      odometry_{vehicle.maxSpeed},
      cloud_{options, vehicle.readers.size(), kCloudKey + vehicle.id.value},
      rival_{options, vehicle.readers.size(), kRivalKey + vehicle.id.value},
      watches_(vehicle.readers.size()) {
  reset(vehicle.start);
}

void ParticleLocator::reset(std::optional<Pose> pose) {
  odometry_.clear();
  pending_.clear();
  std::fill(watches_.begin(), watches_.end(), Watch{});
  placed_ = pose.has_value();
  rivals_ = false;
  rejectedInRow_ = 0;
  lead_ = 0.0;
  toldFrom_ = toldUntil_ = lostUntil_ = 0.0;
  cloud_.scatter(pose ? pose->position : Point{}, options_.startSigma, 0.0, options_.biasSigma);
  drawIn();
}

void ParticleLocator::drawIn() {
  moments_ = cloud_.moments();
  if (rivals_) rivalMoments_ = rival_.moments();
}

void ParticleLocator::add(const Motion& motion) {
  if (!std::isfinite(motion.at.value() + motion.travel.value() + motion.speed.value() + motion.heading.value())) {
    ++intake_.counters.invalid;
    return;
  }
  const bool first = odometry_.empty();
  const double before = odometry_.last().value();
  if (!odometry_.add(motion)) {
    ++intake_.counters.tooLate;
    return;
  }
  if (first) {
    firstMotion_ = motion.at.value();
    evidenceTravel_ = odometry_.at(firstMotion_).travel;
    for (Watch& watch : watches_) watch.accounted = firstMotion_;
    for (const Pending& p : pending_) take(p.read.reader, p.tag, motion.at.value());
    pending_.clear();
    return;
  }
  // One that comes late betters the picture of the past, not the present.
  if (motion.at.value() <= before || !placed_) return;
  cloudFrom_ = before;
  cloud_.beginMotion();
  if (rivals_) rival_.beginMotion();
  // Where the map is asked: the particles lie within a fraction of its grid.
  Eigen::Vector2d place = moments_.mean.head<2>();
  odometry_.walk(before, motion.at.value(), [&](const Odometry::Sample& a, const Odometry::Sample& b) {
    const double travel = b.travel - a.travel;
    const double pieces = std::ceil(std::max(1.0, std::abs(travel) / options_.longestPiece));
    const double turn = (b.heading - a.heading) / pieces;
    const double half = 0.5 * turn;
    // A run of even curvature is driven on an arc; its chord is what moves the place.
    const double chord = travel / pieces * (std::abs(half) > 1e-4 ? std::sin(half) / half : 1.0);
    for (double i = 0.0; i < pieces; ++i) {
      CloudStep step{chord, std::abs(travel) / pieces, a.heading + (2.0 * i + 1.0) * half, turn,
                     (b.at - a.at) / pieces};
      if (outlook_.map) foresee(step, place);
      cloud_.move(step);
      if (rivals_) rival_.move(step);
    }
  });
  drawIn();
}

bool ParticleLocator::usable(int reader, Seconds at) {
  if (!intake_.valid(reader, at)) return false;
  if (!odometry_.empty() && at < std::max(odometry_.last() - kHistory, Seconds{firstMotion_})) {
    ++intake_.counters.tooLate;
    return false;
  }
  return true;
}

void ParticleLocator::add(const TagRead& read) {
  ++intake_.counters.reads;
  if (!usable(read.reader, read.at)) return;
  const std::optional<Point> place = intake_.placeOf(read.uid);
  if (!place) return;
  const Eigen::Vector2d tag{place->x.value(), place->y.value()};
  if (odometry_.empty()) {
    if (pending_.size() < vehicle_.readers.size()) pending_.push_back({read, tag});
    return;
  }
  take(read.reader, tag, read.at.value());
}

void ParticleLocator::take(int reader, const Eigen::Vector2d& tag, double at) {
  Watch& watch = watches_[static_cast<std::size_t>(reader)];
  const bool still = watch.holds && watch.tag == tag;
  watch.accounted = std::max(watch.accounted, at);
  if (!placed_) return startFrom(reader, tag, at);
  const ReaderThen then = readerThen(reader, at);
  const double radius = vehicle_.readerRadius.value();
  const double chance = cloud_.chanceOf(then, tag, radius);
  watch.holds = true;
  watch.tag = tag;
  if (!still) watch.came = at;
  watch.trusted = chance >= options_.gate;
  if (!watch.trusted) {
    if (!still) contradicted(reader, tag, at);
    return;
  }
  cloud_.weighSeen(static_cast<std::size_t>(reader));
  cloud_.resampleIfNeeded();
  rejectedInRow_ = 0;
  evidenceTravel_ = odometry_.at(at).travel;
  if (rivals_) {
    const double other = rival_.chanceOf(then, tag, radius);
    lead_ += leadOf(chance, other);
    if (other >= options_.gate) {
      rival_.weighSeen(static_cast<std::size_t>(reader));
      if (tag != rivalTag_) ++rivalReads_;
    }
    judgeRival();
  }
  drawIn();
  // Its leaving may have been told before its coming.
  if (watch.left && *watch.left >= at) endVisit(reader, *watch.left);
}

void ParticleLocator::add(const TagLeft& left) {
  if (!usable(left.reader, left.at) || odometry_.empty()) return;
  Watch& watch = watches_[static_cast<std::size_t>(left.reader)];
  const double at = left.at.value();
  if (!watch.holds || at < watch.came) {
    watch.left = at;
    return;
  }
  endVisit(left.reader, at);
}

void ParticleLocator::endVisit(int reader, double lastGood) {
  Watch& watch = watches_[static_cast<std::size_t>(reader)];
  clock_.visit(lastGood - watch.came);
  watch.holds = false;
  watch.left.reset();
  watch.accounted = lastGood;
  if (!placed_ || !watch.trusted) return;
  const ReaderThen then = readerThen(reader, lastGood);
  const double radius = vehicle_.readerRadius.value();
  const auto index = static_cast<std::size_t>(reader);
  if (cloud_.chanceOf(then, watch.tag, radius) >= options_.gate) cloud_.weighSeen(index);
  if (rivals_ && rival_.chanceOf(then, watch.tag, radius) >= options_.gate) rival_.weighSeen(index);
  cloud_.resampleIfNeeded();
  drawIn();
}

void ParticleLocator::told(Seconds from, Seconds until) {
  if (from.value() > toldUntil_ + kCloudMargin) toldFrom_ = from.value();
  toldUntil_ = std::max(toldUntil_, until.value());
  if (odometry_.empty()) return;
  const double period = clock_.period();
  // An attempt that is expected just before `until` may really come after it, and see something.
  const double margin = std::max(kCloudMargin, kCloudTremble * period);
  for (std::size_t r = 0; r < watches_.size(); ++r) {
    Watch& watch = watches_[r];
    if (watch.holds) continue;
    // What came between may be missing: the attempts until then say nothing.
    const double known = std::max(toldFrom_, odometry_.last().value() - kHistory.value());
    if (watch.accounted < known) {
      const double gone = std::ceil((known - watch.accounted) / period);
      watch.accounted += gone * period;
    }
    while (watch.accounted + period <= until.value() - margin) {
      watch.accounted += period;
      if (placed_) silence(static_cast<int>(r), watch.accounted);
    }
  }
  if (placed_) {
    cloud_.resampleIfNeeded();
    if (rivals_) judgeRival();
    drawIn();
  }
}

void ParticleLocator::silence(int reader, double attempt) {
  Watch& watch = watches_[static_cast<std::size_t>(reader)];
  const Odometry::Sample sample = odometry_.at(attempt - options_.readLag);
  const Eigen::Vector2d stand{sample.travel, sample.heading};
  const Eigen::Vector2d moved = (stand - watch.lastSilent).cwiseAbs();
  if (moved.x() < kCloudLeastSweep && moved.y() < kCloudLeastTurn) return;
  watch.lastSilent = stand;
  const ReaderThen then = readerThen(reader, attempt);
  const double radius = vehicle_.readerRadius.value();
  const auto weigh = [&](ParticleCloud& cloud, const ParticleCloud::Moments& m) {
    const double sigma = std::sqrt(m.covariance(0, 0) + m.covariance(1, 1));
    if (sigma > kCloudVague) return 1.0;
    const double c = std::cos(m.mean(2));
    const double s = std::sin(m.mean(2));
    const Eigen::Vector2d u = then.lever - m.mean(3) * then.way;
    const Point place{Metres{m.mean(0) + c * u.x() + s * u.y()}, Metres{m.mean(1) + c * u.y() - s * u.x()}};
    near_.clear();
    map_->forEachNear(place, Metres{radius + 5.0 * options_.rim + kCloudSpread * sigma},
                      [&](const floor::PlacedTag& tag) {
                        if (near_.size() < kCloudMostTags) near_.push_back({tag.place.x.value(), tag.place.y.value()});
                      });
    return cloud.weighSilent(static_cast<std::size_t>(reader), then, near_, radius);
  };
  const double chance = weigh(cloud_, moments_);
  if (!rivals_) return;
  lead_ += std::log(std::max(chance, 0.1)) - std::log(std::max(weigh(rival_, rivalMoments_), 0.1));
}

std::vector<Point> ParticleLocator::guesses(std::size_t most) const {
  return placed_ ? cloud_.sample(most) : std::vector<Point>{};
}

Estimate ParticleLocator::at(Seconds now) const {
  Estimate estimate;
  estimate.at = now;
  if (odometry_.empty() || !std::isfinite(now.value())) return estimate;
  const double last = odometry_.last().value();
  Eigen::Vector2d place = moments_.mean.head<2>();
  const double bias = moments_.mean(2);
  const double sign = now.value() < last ? -1.0 : 1.0;
  odometry_.walk(std::min(last, now.value()), std::max(last, now.value()),
                 [&](const Odometry::Sample& a, const Odometry::Sample& b) {
                   const double heading = 0.5 * (a.heading + b.heading) - bias;
                   place += sign * (b.travel - a.travel) * moments_.mean(3) *
                            Eigen::Vector2d{std::cos(heading), std::sin(heading)};
                 });
  const Odometry::Sample sample = odometry_.at(now.value());
  estimate.headingBias = wrapped(Radians{bias});
  estimate.pose.heading = wrapped(Radians{sample.heading - bias});
  estimate.pose.position = {Metres{place.x()}, Metres{place.y()}};
  estimate.covariance = moments_.covariance.topLeftCorner<3, 3>();
  estimate.covariance.row(2) *= -1.0;
  estimate.covariance.col(2) *= -1.0;
  estimate.scale = moments_.covariance.col(3) / moments_.mean(3);
  estimate.scale(2) *= -1.0;
  estimate.scale(3) /= moments_.mean(3);
  estimate.speed = MetresPerSecond{sample.speed * moments_.mean(3)};
  estimate.turnRate = RadiansPerSecond{sample.turnRate};
  estimate.located = placed_ && estimate.positionSigma() < Metres{options_.largestSigma} && now.value() >= lostUntil_;
  if (rivals_) doubt(estimate);
  return estimate;
}

}  // namespace tessera::locate
