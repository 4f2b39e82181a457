#include "traffic/zone_guard.h"

#include <algorithm>
#include <limits>

namespace tessera::traffic {
namespace {

constexpr Metres kBefore{0.03};      // of a zone's clearance, where it waits: it may stop a little late
constexpr Metres kRoomToWait{0.05};  // between two zones, beyond that, for it to wait there

}  // namespace

ZoneGuard::ZoneGuard(VehicleId vehicle, const BodyBox& body, std::shared_ptr<Traffic> traffic)
    : vehicle_{vehicle}, body_{body}, traffic_{std::move(traffic)} {}

void ZoneGuard::laid(const Polyline& way) {
  way_ = way;
  limits_ = traffic_->zones.slowStretches(way, body_);
  blocks_.clear();
  next_ = allowed_ = 0;
  along_ = Metres{};
  for (const Crossing& crossing : traffic_->zones.crossings(way, body_)) {
    if (blocks_.empty() || crossing.from - kBefore - kRoomToWait > blocks_.back().to)
      blocks_.push_back({{}, crossing.from, crossing.to});
    blocks_.back().crossings.push_back(crossing);
    blocks_.back().to = std::max(blocks_.back().to, crossing.to);
  }
}

RightOfWay::Zones ZoneGuard::ahead(const Block& block) const {
  RightOfWay::Zones zones;
  for (const Crossing& crossing : block.crossings)
    if (crossing.to >= along_) zones.push_back(crossing.zone);
  std::sort(zones.begin(), zones.end());
  zones.erase(std::unique(zones.begin(), zones.end()), zones.end());
  return zones;
}

RightOfWay::Zones ZoneGuard::needed() const {
  RightOfWay::Zones zones;
  for (std::size_t i = next_; i < allowed_; ++i)
    for (const std::size_t zone : ahead(blocks_[i])) zones.push_back(zone);
  return zones;
}

Metres ZoneGuard::mayGoTo(Metres along, Metres ahead) {
  along_ = std::max(along_, along);
  while (next_ < blocks_.size() && blocks_[next_].to < along_) ++next_;
  allowed_ = std::max(allowed_, next_);
  for (std::size_t i = next_; i < blocks_.size(); ++i) {
    const Metres stop = blocks_[i].from - kBefore;
    if (stop > along_ + ahead + kRoomToWait) break;
    if (i < allowed_) continue;
    if (!traffic_->rights.ask(vehicle_, this->ahead(blocks_[i]))) return stop;
    allowed_ = i + 1;
  }
  return Metres{std::numeric_limits<double>::infinity()};
}

}  // namespace tessera::traffic
