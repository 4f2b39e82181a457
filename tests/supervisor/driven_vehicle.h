// A scripted vehicle that moves: a point that obeys the last command with a plain heading loop and speed ramp, and
// reads the site's tags. Far simpler than the simulated world; it is here to close the supervisor's loop, not to judge
// it.
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "floor/bearing.h"
#include "floor/site_map.h"
#include "link/fake_vehicle.h"

namespace tessera::test {

class DrivenVehicle {
public:
  DrivenVehicle(std::shared_ptr<const floor::SiteMap> map, VehicleId id, std::uint32_t seed)
      : fake{id.value, map->vehicle(id)->key}, setup_{*map->vehicle(id)}, map_{std::move(map)}, random_{seed} {
    pose = setup_.start.value_or(Pose{});
    seen_.resize(setup_.readers.size());
    fake.onCommand = [this](const wire::CycleEntry& e, Seconds at) { obey(e, at); };
    fake.beforeReport = [this](Seconds at) { advance(at); };
    fake.report.battery = 120;
  }
  DrivenVehicle(const DrivenVehicle&) = delete;
  DrivenVehicle& operator=(const DrivenVehicle&) = delete;

  void restart() {
    fake.restart();
    stand(wire::VehicleState::Standing);
    speed = 0;
    travel_ = 0;
  }
  void advance(Seconds now) {
    if (!at_) at_ = now;
    while (*at_ + Seconds{0.001} <= now) step();
    fake.report.travel = static_cast<std::uint16_t>(std::llround(travel_ * 1000.0));
    fake.report.speed = static_cast<std::int16_t>(std::lround(speed * 1000));
    fake.report.bearing = floor::toBinaryAngle(floor::bearingOfHeading(pose.heading, map_->site().northToY));
    fake.report.range = blocked ? 23 : range;
  }

  FakeVehicle fake;
  std::uint8_t range = 255;  ///< cm, as it is reported while nothing blocks the way
  Pose pose;
  double speed = 0;  // m/s
  bool blocked = false;

private:
  void obey(const wire::CycleEntry& e, Seconds at) {
    if (e.mode == wire::CommandMode::Poll) return;
    if (e.mode != wire::CommandMode::Drive) return stand(wire::VehicleState::Standing);
    wanted_ = e.speed / 1000.0;
    heading_ = floor::headingOfBearing(floor::fromBinaryAngle(e.bearing), map_->site().northToY);
    until_ = at + Seconds{e.expiry * wire::kExpiryUnitMs / 1000.0};
  }
  void stand(wire::VehicleState state) {
    until_.reset();
    fake.report.state = state;
  }
  void step() {
    constexpr double dt = 0.001;
    at_ = *at_ + Seconds{dt};
    if (until_ && *at_ >= *until_) stand(wire::VehicleState::Expired);
    const double target = until_ && !blocked ? wanted_ : 0.0;
    if (until_) fake.report.state = blocked ? wire::VehicleState::Obstacle : wire::VehicleState::Driving;
    speed += std::clamp(target - speed, -0.5 * dt, 0.5 * dt);
    if (until_ && !blocked) {
      const double turn = std::clamp(3.0 * turnBetween(pose.heading, heading_).value(), -1.5, 1.5);
      pose.heading = wrapped(pose.heading + Radians{turn * dt});
    }
    travel_ += speed * dt;
    pose.position = pose.position + turned({Metres{speed * dt}, Metres{0}}, pose.heading);
    if (++steps_ % 100 == 0) readTags();
  }
  void readTags() {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const Point reader = placeOf(pose, setup_.readers[i]);
      std::optional<floor::TagUid> tag;
      map_->forEachNear(reader, setup_.readerRadius, [&](const floor::PlacedTag& t) { tag = t.uid; });
      if (std::bernoulli_distribution{0.1}(random_)) tag.reset();
      if (tag) lastRead_ = *at_;
      if (tag == seen_[i]) continue;
      wire::TagEvent e;
      e.reader = static_cast<std::uint8_t>(i);
      if (tag) {
        e.kind = wire::EventKind::Uid7;
        std::copy(tag->bytes().begin(), tag->bytes().end(), e.uid.begin());
      }
      fake.note(e, tag ? *at_ : lastRead_);
      seen_[i] = tag;
    }
  }

  floor::VehicleSetup setup_;
  std::shared_ptr<const floor::SiteMap> map_;
  std::mt19937 random_;
  std::vector<std::optional<floor::TagUid>> seen_;
  std::optional<Seconds> at_;
  std::optional<Seconds> until_;
  Seconds lastRead_;
  double wanted_ = 0;
  Radians heading_;
  double travel_ = 0;
  std::uint64_t steps_ = 0;
};

}  // namespace tessera::test
