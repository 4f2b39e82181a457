// What a particle locator does with a read that contradicts it: a rival belief, or a new start.
#include <algorithm>
#include <cmath>

#include "locate/particle_locator.h"

namespace tessera::locate {
namespace {

constexpr int kCloudDoubtAfter = 4;          // contradicting reads in a row that agree on nothing
constexpr double kCloudStill = 0.02;         // m of travel that count as not having moved
constexpr double kCloudStandingTime = 0.5;   // s
constexpr double kCloudStanding = 0.005;     // m of travel within that time
constexpr double kCloudStandingTurn = 0.15;  // rad within that time
constexpr double kAdmitted = 1.0;            // s for which it says that it was wrong
constexpr double kStartLead = 2.3;           // log; one contradiction alone proves nothing ...
constexpr double kTakeOver = -2.0;           // ... a second one does that fits the first
constexpr double kDoubtful = 0.05;           // chance of the rival from which on it says that it is in doubt
constexpr double kDismiss = 6.0;             // and a rival that explains nothing is forgotten
constexpr double kRivalBias = 0.35;          // rad; after being carried the compass settles again
constexpr double kLeastChance = 2e-3;        // of a read under a belief: tags lie elsewhere than the map says

}  // namespace

double ParticleLocator::leadOf(double chance, double other) {
  return std::log(std::max(chance, kLeastChance)) - std::log(std::max(other, kLeastChance));
}

bool ParticleLocator::standsSinceBelieved(double at) const {
  // Not while it turns: then a tag that lies elsewhere than the map says would look the same.
  const Odometry::Sample now = odometry_.at(at);
  const Odometry::Sample before = odometry_.at(at - kCloudStandingTime);
  return std::abs(now.travel - before.travel) < kCloudStanding &&
         std::abs(now.heading - before.heading) < kCloudStandingTurn &&
         std::abs(now.travel - evidenceTravel_) < kCloudStill;
}

void ParticleLocator::contradicted(int reader, const Eigen::Vector2d& tag, double at) {
  ++intake_.counters.rejected;
  ++rejectedInRow_;
  const double sigma = std::sqrt(std::max(moments_.covariance(0, 0), moments_.covariance(1, 1)));
  // Wrong for certain: that is said, and the vehicle stands while it is. Not longer, as standing still in doubt would
  // teach it nothing; the next read soon shows whether this start was right.
  if (rejectedInRow_ >= kCloudDoubtAfter) lostUntil_ = std::min(at, odometry_.last().value()) + kAdmitted;
  // The same start where it was carried while it stood, or is known no better than by this one read.
  if (standsSinceBelieved(at) || sigma > options_.largestSigma || rejectedInRow_ >= kCloudDoubtAfter)
    return startFrom(reader, tag, at);
  const ReaderThen then = readerThen(reader, at);
  const double radius = vehicle_.readerRadius.value();
  const double other = rivals_ ? rival_.chanceOf(then, tag, radius) : 0.0;
  if (other >= options_.gate) {
    rival_.weighSeen(static_cast<std::size_t>(reader));
    rival_.resampleIfNeeded();
    drawIn();
    // One tag that lies elsewhere than the map says is read by one reader after the other: that proves nothing.
    if (tag == rivalTag_) return;
    ++rivalReads_;
    lead_ += leadOf(0.0, other);
    return judgeRival();
  }
  rival_.moved(wayBetween(cloudFrom_, odometry_.last().value()));
  rival_.scatterUnder(tag, then.lever - then.way, radius, moments_.mean(2), kRivalBias);
  rivals_ = true;
  rivalMoments_ = rival_.moments();
  rivalReads_ = 1;
  rivalTag_ = tag;
  lead_ = kStartLead;
}

void ParticleLocator::judgeRival() {
  if (lead_ > kDismiss) {
    rivals_ = false;
  } else if (lead_ < kTakeOver && rivalReads_ > 1) {
    std::swap(cloud_, rival_);
    cloud_.resampleIfNeeded();
    rivals_ = false;
    rejectedInRow_ = 0;
    for (Watch& watch : watches_) watch.trusted = false;
    ++intake_.counters.reacquisitions;
    drawIn();
  }
}

// The claim is that of both beliefs together, about the place that the first of them tells. It goes on driving, more
// slowly the farther they lie apart: standing would not tell it which is right.
void ParticleLocator::doubt(Estimate& estimate) const {
  const double share = 1.0 / (1.0 + std::exp(lead_));
  const Eigen::Vector2d apart = rivalMoments_.mean.head<2>() - moments_.mean.head<2>();
  const Eigen::Matrix2d there = rivalMoments_.covariance.topLeftCorner<2, 2>() + apart * apart.transpose();
  // Added to what its own cloud says and not in place of a share of it, so that it stays a covariance with the
  // heading's.
  estimate.covariance.topLeftCorner<2, 2>() += 0.5 * share * (there + there.transpose());
  estimate.doubted = estimate.located && share > kDoubtful;
}

void ParticleLocator::startFrom(int reader, const Eigen::Vector2d& tag, double at) {
  const ReaderThen then = readerThen(reader, at);
  cloud_.moved(wayBetween(cloudFrom_, odometry_.last().value()));
  cloud_.scatterUnder(tag, then.lever - then.way, vehicle_.readerRadius.value(), moments_.mean(2),
                      placed_ ? kRivalBias : options_.biasSigma);
  placed_ = true;
  rivals_ = false;
  rejectedInRow_ = 0;
  evidenceTravel_ = odometry_.at(at).travel;
  for (Watch& watch : watches_) watch.trusted = false;
  Watch& watch = watches_[static_cast<std::size_t>(reader)];
  watch.holds = watch.trusted = true;
  watch.tag = tag;
  watch.came = at;
  ++intake_.counters.reacquisitions;
  drawIn();
}

}  // namespace tessera::locate
