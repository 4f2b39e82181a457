#include "locate/kalman_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera::locate {
namespace {

constexpr std::size_t kPruneRecordsAt = 256;
constexpr int kDoubtAfter = 4;            // contradicting reads in a row that agree on nothing
constexpr double kStill = 0.02;           // m of travel that count as not having moved
constexpr double kStandingTime = 0.5;     // s
constexpr double kStanding = 0.005;       // m of travel within that time
constexpr double kStandingTurn = 0.15;    // rad within that time; the compass is noisy
constexpr double kAgreement = 0.03;       // m beyond two radii
constexpr double kLeastSweep = 0.004;     // m; a reader that moved less between attempts says nothing by silence
constexpr double kFoundSigmaShare = 0.6;  // of the radius, per axis, when starting from one read
constexpr double kLongAgo = -std::numeric_limits<double>::infinity();

}  // namespace

KalmanLocator::KalmanLocator(std::shared_ptr<const floor::SiteMap> map, const floor::VehicleSetup& vehicle,
                             const KalmanOptions& options, DiscModel model)
    : intake_{std::move(map), std::min(vehicle.readers.size(), kMaxReaders)},
      vehicle_{vehicle},
      options_{options},
      model_{model},
      odometry_{vehicle.maxSpeed} {
  model_.radius = vehicle.readerRadius.value();
  records_.reserve(kPruneRecordsAt + 1);
  reset(vehicle.start);
}

void KalmanLocator::reset(std::optional<Pose> pose) {
  records_.clear();
  odometry_.clear();
  baseAt_ = kLongAgo;
  base_ = State{};
  base_.filter.forget(options_);
  if (pose) base_.filter.place(options_, pose->position, options_.startSigma);
}

void KalmanLocator::add(const Motion& motion) {
  const bool first = odometry_.empty();
  if (!std::isfinite(motion.at.value() + motion.travel.value() + motion.speed.value() + motion.heading.value())) {
    ++intake_.counters.invalid;
    return;
  }
  if (motion.at.value() < baseAt_ || !odometry_.add(motion)) {
    ++intake_.counters.tooLate;
    return;
  }
  if (first) base_.evidenceTravel = odometry_.at(motion.at.value()).travel;
  Record record;
  record.at = motion.at.value();
  std::size_t from = insert(record);
  // What happened since the motion before was placed by a guess that is now better known.
  while (from > 0 && records_[from - 1].kind != Kind::Motion) --from;
  replay(from);
  prune();
}

bool KalmanLocator::usable(int reader, Seconds at) {
  if (!intake_.valid(reader, at)) return false;
  const double oldest = odometry_.empty() ? baseAt_ : std::max(baseAt_, odometry_.last().value() - kHistory.value());
  if (at.value() < oldest) {
    ++intake_.counters.tooLate;
    return false;
  }
  return true;
}

void KalmanLocator::add(const TagRead& read) {
  ++intake_.counters.reads;
  if (!usable(read.reader, read.at)) return;
  const std::optional<Point> place = intake_.placeOf(read.uid);
  if (!place) return;
  Record record;
  record.at = read.at.value();
  record.kind = Kind::Read;
  record.reader = read.reader;
  record.tag = {place->x.value(), place->y.value()};
  const std::size_t index = insert(record);
  replay(index);
  if (odometry_.empty()) return;
  if (records_[index].verdict == Verdict::Rejected) ++intake_.counters.rejected;
  if (records_[index].verdict != Verdict::Accepted) findAnew(index);
}

void KalmanLocator::add(const TagLeft& left) {
  if (!usable(left.reader, left.at)) return;
  Record record;
  record.at = left.at.value();
  record.kind = Kind::Left;
  record.reader = left.reader;
  replay(insert(record));
}

std::size_t KalmanLocator::insert(Record record) {
  const auto place = std::upper_bound(records_.begin(), records_.end(), record.at,
                                      [](double at, const Record& r) { return at < r.at; });
  return static_cast<std::size_t>(std::distance(records_.begin(), records_.insert(place, std::move(record))));
}

void KalmanLocator::replay(std::size_t from) {
  if (odometry_.empty()) return;
  for (std::size_t i = from; i < records_.size(); ++i) apply(i);
}

void KalmanLocator::apply(std::size_t index) {
  Record& record = records_[index];
  const double since = index > 0 ? records_[index - 1].at : (std::isfinite(baseAt_) ? baseAt_ : record.at);
  State state = index > 0 ? records_[index - 1].after : base_;
  odometry_.walk(since, record.at, [&](const Odometry::Sample& from, const Odometry::Sample& to) {
    state.filter.predict(options_, from, to);
  });
  if (record.kind == Kind::Read) applyRead(index, state);
  if (record.kind == Kind::Left) applyLeft(record, state);
  if (record.kind == Kind::Found) {
    const Odometry::Sample now = odometry_.at(record.at);
    const Eigen::Vector2d place =
        record.tag - lever(record.reader, now.heading - state.filter.state()(KalmanFilter::kBias));
    state.filter.place(options_, {Metres{place.x()}, Metres{place.y()}}, kFoundSigmaShare * model_.radius);
    state.held = {};
    state.doubted = false;
    state.rejectedInRow = 0;
    state.evidenceTravel = now.travel;
  }
  record.after = state;
}

void KalmanLocator::applyRead(std::size_t index, State& state) {
  Record& record = records_[index];
  record.verdict = Verdict::Unused;
  const auto reader = static_cast<std::size_t>(record.reader);
  Held& held = state.held[reader];
  const bool still = held.any && held.tag == record.tag;
  held = {true, false, record.tag};
  if (!state.filter.placed()) return;
  const Odometry::Sample now = odometry_.at(record.at);
  const SilentAttempts silent = still ? SilentAttempts{} : silentAttempts(record.reader, record.at, -1.0, state);
  const double evidence =
      state.filter.correct(options_, model_, vehicle_.readers[reader], now.heading, record.tag, silent);
  held.trusted = evidence >= options_.gate;
  record.verdict = held.trusted ? Verdict::Accepted : Verdict::Rejected;
  if (held.trusted) {
    state.doubted = false;
    state.rejectedInRow = 0;
    state.evidenceTravel = now.travel;
  } else if (!still && ++state.rejectedInRow >= kDoubtAfter) {
    state.doubted = true;
  }
}

void KalmanLocator::applyLeft(const Record& record, State& state) const {
  const auto reader = static_cast<std::size_t>(record.reader);
  Held& held = state.held[reader];
  if (held.any && held.trusted && state.filter.placed()) {
    const SilentAttempts silent = silentAttempts(record.reader, record.at, +1.0, state);
    state.filter.correct(options_, model_, vehicle_.readers[reader], odometry_.at(record.at).heading, held.tag, silent);
  }
  held.any = false;
}

Eigen::Vector2d KalmanLocator::lever(int reader, double heading) const {
  const Offset mount = turned(vehicle_.readers[static_cast<std::size_t>(reader)], Radians{heading});
  return {mount.x.value(), mount.y.value()};
}

SilentAttempts KalmanLocator::silentAttempts(int reader, double at, double direction, const State& state) const {
  const double bias = state.filter.state()(KalmanFilter::kBias);
  const Odometry::Sample now = odometry_.at(at);
  const Eigen::Vector2d here = lever(reader, now.heading - bias);
  SilentAttempts silent;
  for (std::size_t k = 0; k < 2; ++k) {
    const Odometry::Sample then = odometry_.at(at + direction * static_cast<double>(k + 1) * model_.pollPeriod);
    const double heading = 0.5 * (now.heading + then.heading) - bias;
    const double way = (then.travel - now.travel) * state.filter.state()(KalmanFilter::kScale);
    silent.offset[k] =
        way * Eigen::Vector2d{std::cos(heading), std::sin(heading)} + lever(reader, then.heading - bias) - here;
    if (k == 0 && silent.offset[k].norm() < kLeastSweep) return silent;
    silent.count = k + 1;
  }
  return silent;
}

bool KalmanLocator::agree(const Record& earlier, const Record& later, double bias) const {
  Eigen::Vector2d place = earlier.tag - lever(earlier.reader, odometry_.at(earlier.at).heading - bias);
  odometry_.walk(earlier.at, later.at, [&](const Odometry::Sample& from, const Odometry::Sample& to) {
    const double heading = 0.5 * (from.heading + to.heading) - bias;
    place += (to.travel - from.travel) * Eigen::Vector2d{std::cos(heading), std::sin(heading)};
  });
  const Eigen::Vector2d expected = place + lever(later.reader, odometry_.at(later.at).heading - bias);
  return (expected - later.tag).norm() < 2.0 * model_.radius + kAgreement;
}

bool KalmanLocator::trusted(const State& state) const {
  Estimate estimate;
  estimate.covariance = state.filter.poseCovariance(options_);
  return state.rejectedInRow <= kDoubtAfter && estimate.positionSigma() < Metres{options_.largestSigma};
}

void KalmanLocator::findAnew(std::size_t latest) {
  const Record read = records_[latest];
  if (!read.after.filter.placed() || !trusted(read.after)) return startFrom(read);
  // Carried while it stood: its wheels have not turned since a read that was believed.
  // (Not while it turns: then a tag that lies elsewhere than the map says would look the same.)
  const Odometry::Sample now = odometry_.at(read.at);
  const Odometry::Sample before = odometry_.at(read.at - kStandingTime);
  const bool stands =
      std::abs(now.travel - before.travel) < kStanding && std::abs(now.heading - before.heading) < kStandingTurn;
  if (stands && std::abs(now.travel - read.after.evidenceTravel) < kStill) return startFrom(read);
  // Otherwise one read may be a tag that lies elsewhere than the map says; two different ones that agree are believed.
  const double bias = read.after.filter.state()(KalmanFilter::kBias);
  for (std::size_t i = latest; i-- > 0;) {
    const Record& other = records_[i];
    if (other.kind == Kind::Found || other.verdict == Verdict::Accepted) return;
    if (other.kind == Kind::Read && other.tag != read.tag && agree(other, read, bias)) return startFrom(read);
  }
}

void KalmanLocator::startFrom(const Record& read) {
  Record found;
  found.at = read.at;
  found.kind = Kind::Found;
  found.reader = read.reader;
  found.tag = read.tag;
  const auto place =
      std::lower_bound(records_.begin(), records_.end(), read.at, [](const Record& r, double at) { return r.at < at; });
  const auto index = static_cast<std::size_t>(std::distance(records_.begin(), records_.insert(place, found)));
  ++intake_.counters.reacquisitions;
  replay(index);
}

void KalmanLocator::prune() {
  if (records_.size() < kPruneRecordsAt) return;
  const double oldest = odometry_.last().value() - kHistory.value();
  std::size_t drop = 0;
  while (drop + 1 < records_.size() && records_[drop + 1].at < oldest) ++drop;
  if (records_.size() - drop >= kPruneRecordsAt) drop = records_.size() - kPruneRecordsAt / 2;
  if (drop == 0) return;
  base_ = records_[drop - 1].after;
  baseAt_ = records_[drop - 1].at;
  records_.erase(records_.begin(), records_.begin() + static_cast<std::ptrdiff_t>(drop));
}

Estimate KalmanLocator::at(Seconds now) const {
  Estimate estimate;
  estimate.at = now;
  if (odometry_.empty() || !std::isfinite(now.value())) return estimate;
  const auto after = std::upper_bound(records_.begin(), records_.end(), now.value(),
                                      [](double at, const Record& r) { return at < r.at; });
  const bool any = after != records_.begin();
  const State& from = any ? std::prev(after)->after : base_;
  const double since = any ? std::prev(after)->at : (std::isfinite(baseAt_) ? baseAt_ : now.value());
  KalmanFilter filter = from.filter;
  odometry_.walk(since, now.value(),
                 [&](const Odometry::Sample& a, const Odometry::Sample& b) { filter.predict(options_, a, b); });
  const Odometry::Sample sample = odometry_.at(now.value());
  const KalmanFilter::Vector& x = filter.state();
  estimate.headingBias = wrapped(Radians{x(KalmanFilter::kBias)});
  estimate.pose.heading = wrapped(Radians{sample.heading - x(KalmanFilter::kBias)});
  estimate.pose.position = {Metres{x(KalmanFilter::kX)}, Metres{x(KalmanFilter::kY)}};
  estimate.covariance = filter.poseCovariance(options_);
  estimate.scale = filter.covariance().col(KalmanFilter::kScale) / x(KalmanFilter::kScale);
  estimate.scale(KalmanFilter::kBias) *= -1.0;
  estimate.scale(KalmanFilter::kScale) /= x(KalmanFilter::kScale);
  estimate.speed = MetresPerSecond{sample.speed * x(KalmanFilter::kScale)};
  estimate.turnRate = RadiansPerSecond{sample.turnRate};
  estimate.located = filter.placed() && !from.doubted && estimate.positionSigma() < Metres{options_.largestSigma};
  return estimate;
}

}  // namespace tessera::locate
