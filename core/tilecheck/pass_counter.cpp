#include "tilecheck/pass_counter.h"

#include <algorithm>
#include <cmath>

namespace tessera::tilecheck {
namespace {

constexpr Metres kAside{0.03};   // by which a vehicle may be beside where it is believed to be
constexpr double kWell = 0.75;   // of a reader's radius: farther out a good tag is missed as well
constexpr Metres kFarStep{0.2};  // farther between two instants nobody knows what lay between
constexpr Seconds kLongStep{1.0};
constexpr Seconds kSlack{0.4};  // between the believed instant of a pass and its read
constexpr Seconds kLate{3.0};   // reports are younger when they come

// Under a reader, well inside, even if the vehicle is a little more to the left or right than believed.
bool isSeen(const floor::VehicleSetup& vehicle, Offset tag) {
  const double well = kWell * vehicle.readerRadius.value();
  for (const double aside : {-kAside.value(), 0.0, kAside.value()}) {
    const bool any = std::any_of(vehicle.readers.begin(), vehicle.readers.end(), [&](const Offset& reader) {
      return std::abs((tag.y - reader.y).value() + aside) <= well && std::abs((tag.x - reader.x).value()) <= well;
    });
    if (!any) return false;
  }
  return true;
}

}  // namespace

void PassCounter::moved(const floor::SiteMap& map, const floor::VehicleSetup& setup, Seconds at, const Pose& pose) {
  const auto known = vehicles_.find(setup.id);
  if (known != vehicles_.end() && (at < known->second.at || at - known->second.at > kLongStep ||
                                   distance(pose.position, known->second.pose.position) > kFarStep))
    lost(setup.id);
  Vehicle& vehicle = vehicles_[setup.id];
  vehicle.at = at;
  vehicle.pose = pose;
  Metres reach;
  for (const Offset& reader : setup.readers) reach = std::max(reach, length(reader) + setup.readerRadius);
  std::vector<floor::TagUid> over;
  map.forEachNear(pose.position, reach, [&](const floor::PlacedTag& tag) {
    if (isSeen(setup, turned(tag.place - pose.position, -pose.heading))) over.push_back(tag.uid);
  });
  for (const floor::TagUid& uid : over) {
    OfTag& of = ofTag_.try_emplace(uid, OfTag{ofTag_.size(), {}, {}, {}}).first->second;
    const auto open =
        std::find_if(of.open.begin(), of.open.end(), [&](const Pass& p) { return p.vehicle == setup.id; });
    if (open != of.open.end()) {
      open->to = at;
    } else {
      of.open.push_back({setup.id, at, at, of.lastRead && abs(at - *of.lastRead) <= kSlack});
    }
  }
  for (const floor::TagUid& uid : vehicle.over) {
    if (std::find(over.begin(), over.end(), uid) != over.end()) continue;
    OfTag& of = ofTag_[uid];
    const auto open =
        std::find_if(of.open.begin(), of.open.end(), [&](const Pass& p) { return p.vehicle == setup.id; });
    if (open == of.open.end()) continue;
    if (of.over.size() == kMostOfATag) of.over.erase(of.over.begin());
    of.over.push_back(*open);
    of.open.erase(open);
  }
  vehicle.over = std::move(over);
}

void PassCounter::lost(VehicleId id) {
  const auto vehicle = vehicles_.find(id);
  if (vehicle == vehicles_.end()) return;
  for (const floor::TagUid& uid : vehicle->second.over)
    std::erase_if(ofTag_[uid].open, [id](const Pass& pass) { return pass.vehicle == id; });
  vehicles_.erase(vehicle);
}

void PassCounter::read(VehicleId vehicle, const floor::TagUid& uid, Seconds at) {
  const auto found = ofTag_.find(uid);
  if (found == ofTag_.end()) {
    ofTag_.try_emplace(uid, OfTag{ofTag_.size(), {}, {}, at});
    return;
  }
  found->second.lastRead = at;
  for (auto* passes : {&found->second.open, &found->second.over})
    for (Pass& pass : *passes)
      if (pass.vehicle == vehicle && at >= pass.from - kSlack && at <= pass.to + kSlack) pass.hit = true;
}

void PassCounter::clear() {
  vehicles_.clear();
  ofTag_.clear();
}

std::vector<TagPasses> PassCounter::passes(Seconds now) const {
  std::vector<std::pair<std::size_t, TagPasses>> all;
  for (const auto& [uid, of] : ofTag_) {
    TagPasses passes{uid, 0, 0};
    for (const Pass& pass : of.over) {
      if (now - pass.to < kLate) continue;
      ++passes.passes;
      passes.hits += pass.hit ? 1 : 0;
    }
    if (passes.passes > 0) all.emplace_back(of.order, passes);
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TagPasses> ordered;
  ordered.reserve(all.size());
  for (auto& [order, passes] : all) ordered.push_back(passes);
  return ordered;
}

}  // namespace tessera::tilecheck
