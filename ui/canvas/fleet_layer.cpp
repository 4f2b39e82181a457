#include "ui/canvas/fleet_layer.h"

#include <algorithm>

namespace tessera::ui {

using supervisor::Contact;
using supervisor::Task;
using wire::VehicleState;

VehicleLook lookOf(const supervisor::VehicleView& v) {
  if (v.contact != Contact::Connected) return VehicleLook::Silent;
  if (v.state == VehicleState::Faulted) return VehicleLook::Fault;
  if (v.state == VehicleState::Obstacle) return VehicleLook::Obstacle;
  if (v.task == Task::Paused) return VehicleLook::Paused;
  if (!v.waits.empty()) return VehicleLook::Waiting;
  return VehicleLook::Fine;
}

bool isMoving(const supervisor::VehicleView& v) {
  return v.located && v.contact == Contact::Connected && v.link.age < kOldReport &&
         abs(v.speed) > MetresPerSecond{0.002};
}

Pose poseAfter(const supervisor::VehicleView& v, Seconds since) {
  if (!isMoving(v)) return v.pose;
  const Metres way = v.speed * std::clamp(since, Seconds{}, kSmoothing);
  return {placeOf(v.pose, {way, Metres{}}), v.pose.heading};
}

void FleetLayer::setSnapshot(std::shared_ptr<const supervisor::Snapshot> snapshot) {
  if (snapshot && snapshot_ && snapshot->time < snapshot_->time) clear();  // another run
  snapshot_ = std::move(snapshot);
  // Here as well as in advance(): nobody asks for frames of a window that is not shown.
  std::erase_if(flashes_, [&](const Flash& flash) { return !snapshot_ || snapshot_->time - flash.since > kFlash; });
  if (!snapshot_) return;
  for (const supervisor::VehicleView& vehicle : snapshot_->vehicles) {
    Trail& trail = trails_[vehicle.id];
    if (vehicle.located) {
      trail.add(vehicle.pose.position, snapshot_->time);
    } else {
      trail.interrupt();
    }
    takeReads(vehicle);
  }
}

void FleetLayer::clear() {
  snapshot_.reset();
  trails_.clear();
  lastRead_.clear();
  flashes_.clear();
}

const Trail* FleetLayer::trail(VehicleId id) const {
  const auto found = trails_.find(id);
  return found == trails_.end() ? nullptr : &found->second;
}

bool FleetLayer::advance(Seconds sinceSnapshot) {
  if (!snapshot_) return false;
  const Seconds now = snapshot_->time + sinceSnapshot;
  std::erase_if(flashes_, [&](const Flash& flash) { return now - flash.since > kFlash; });
  if (!flashes_.empty()) return true;
  if (sinceSnapshot > kSmoothing) return false;
  return std::any_of(snapshot_->vehicles.begin(), snapshot_->vehicles.end(), isMoving);
}

void FleetLayer::takeReads(const supervisor::VehicleView& vehicle) {
  const auto last = lastRead_.try_emplace(vehicle.id, snapshot_->time - kFlash).first;
  for (const supervisor::ReadView& read : vehicle.recentReads) {
    if (read.at <= last->second) continue;
    last->second = read.at;
    if (read.place) flashes_.push_back({*read.place, read.at, vehicle.id});
  }
}

}  // namespace tessera::ui
