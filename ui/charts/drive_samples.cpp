#include "ui/charts/drive_samples.h"

#include <cmath>
#include <limits>

namespace tessera::ui {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr double kSlack = 1e-3;  // s: pictures come a hair early or late

DriveSample sampleOf(double time, const supervisor::VehicleView& v) {
  DriveSample s{time, kNothing, kNothing, kNothing, kNothing, kNothing, kNothing};
  if (v.located) {
    s.x = static_cast<float>(v.pose.position.x.value());
    s.y = static_cast<float>(v.pose.position.y.value());
    s.heading = static_cast<float>(v.pose.heading.value());
    const bool onRoute = v.task == supervisor::Task::Running || v.task == supervisor::Task::Paused;
    if (onRoute && !v.route.empty()) s.crossTrack = static_cast<float>(v.crossTrack.value());
  }
  if (v.contact == supervisor::Contact::Connected && v.link.lastHeard) s.speed = static_cast<float>(v.speed.value());
  if (v.command && v.command->status != supervisor::CommandStatus::Expired)
    s.commanded = v.command->mode == wire::CommandMode::Drive ? static_cast<float>(v.command->speed.value()) : 0.0F;
  return s;
}

bool isFarther(const DriveSample& a, const DriveSample& b) {
  if (std::isnan(b.crossTrack)) return !std::isnan(a.crossTrack);
  return std::abs(a.crossTrack) > std::abs(b.crossTrack);
}

}  // namespace

void SampleRing::push(const DriveSample& sample) {
  if (samples_.size() < capacity_) {
    samples_.push_back(sample);
    return;
  }
  samples_[first_] = sample;
  first_ = (first_ + 1) % capacity_;
}

void SampleRing::clear() {
  samples_.clear();
  first_ = 0;
}

void DriveSamples::push(Track& track, const DriveSample& sample) {
  track.fine.push(sample);
  if (track.coarseSince < 0.0) {
    track.coarseSince = sample.time;
    track.extreme = sample;
    return;
  }
  if (sample.time - track.coarseSince >= kCoarseStep - kSlack) {
    track.coarse.push(track.extreme);
    track.coarseSince = sample.time;
    track.extreme = sample;
  } else if (isFarther(sample, track.extreme)) {
    track.extreme = sample;
  }
}

void DriveSamples::take(const supervisor::Snapshot& snapshot) {
  const double time = snapshot.time.value();
  if (time < now_) clear();
  now_ = time;
  for (const supervisor::VehicleView& v : snapshot.vehicles) {
    Track& track = tracks_[v.id];
    if (track.fine.empty() || time - track.fine.back().time >= kFineStep - kSlack) push(track, sampleOf(time, v));
  }
}

void DriveSamples::clear() {
  tracks_.clear();
  now_ = -1.0;
}

void DriveSamples::clear(VehicleId vehicle) { tracks_.erase(vehicle); }

std::vector<DriveSample> DriveSamples::window(VehicleId vehicle, double until, double span) const {
  std::vector<DriveSample> found;
  const auto known = tracks_.find(vehicle);
  if (known == tracks_.end()) return found;
  const Track& track = known->second;
  const double from = until - span;
  const double fineFrom = track.fine.empty() ? until : track.fine.at(0).time;
  for (std::size_t i = 0; i < track.coarse.size(); ++i) {
    const DriveSample& s = track.coarse.at(i);
    if (s.time >= from && s.time < fineFrom) found.push_back(s);
  }
  for (std::size_t i = 0; i < track.fine.size(); ++i) {
    const DriveSample& s = track.fine.at(i);
    if (s.time >= from && s.time <= until) found.push_back(s);
  }
  return found;
}

}  // namespace tessera::ui
