#include "ui/tilecheck/read_collector.h"

#include <algorithm>

namespace tessera::ui {
namespace {

constexpr Seconds kPast{5.0};    // reports are younger when they come
constexpr Seconds kBeyond{0.3};  // a vehicle goes straight on for so long
constexpr Metres kJump{0.2};     // no vehicle goes, and no good read moves it, so far between two pictures
constexpr Metres kBack{0.15};
constexpr Metres kBelieved{2.5};  // further than any wrong tile reaches

}  // namespace

void ReadCollector::take(const supervisor::Snapshot& snapshot, const floor::SiteMap& map) {
  const floor::Site& site = map.site();
  if (last_ && snapshot.time < *last_) {  // another run
    vehicles_.clear();
    passes_.clear();
  }
  last_ = snapshot.time;
  for (const supervisor::VehicleView& view : snapshot.vehicles) {
    Vehicle& vehicle = vehicles_[view.id];
    const auto setup = std::find_if(site.vehicles.begin(), site.vehicles.end(),
                                    [&](const floor::VehicleSetup& v) { return v.id == view.id; });
    for (const supervisor::ReadView& read : view.recentReads) {
      if (vehicle.lastRead && read.at <= *vehicle.lastRead) continue;
      if (setup == site.vehicles.end() || read.reader >= setup->readers.size()) continue;
      passes_.read(view.id, read.uid, read.at);
      if (const auto pose = poseAt(vehicle.past, read.at)) add({read.uid, placeOf(*pose, setup->readers[read.reader])});
    }
    if (!view.recentReads.empty()) vehicle.lastRead = view.recentReads.back().at;
    // Only now: this pose knows of the reads.
    if (view.located) {
      follow(vehicle, {snapshot.time, view.pose, view.speed});
      // A place that jumped is not good enough to say that a tag was missed.
      if (setup != site.vehicles.end() && length(vehicle.aside) == Metres{})
        passes_.moved(map, *setup, snapshot.time, view.pose);
      else
        passes_.lost(view.id);
    } else {
      passes_.lost(view.id);
      vehicle = Vehicle{{}, {}, {}, {}, vehicle.lastRead};
    }
    while (!vehicle.past.empty() && snapshot.time - vehicle.past.front().at > kPast) vehicle.past.pop_front();
  }
}

// A tile that lies elsewhere draws the locator to where the site has it, after which its own reads would seem to be
// right. So a place that jumps is not followed: wheels and heading lead on from before. It is believed when it jumps
// back, or after a way on which other tiles would have called it back.
void ReadCollector::follow(Vehicle& vehicle, const Known& now) {
  if (vehicle.last) {
    const Seconds passed = now.at - vehicle.last->at;
    const Metres way = vehicle.last->speed * passed;
    vehicle.sinceJump += abs(way);
    const Offset jump = now.pose.position - placeOf(vehicle.last->pose, {way, Metres{}});
    if (length(jump) > kJump) {
      vehicle.aside = vehicle.aside + -1.0 * jump;
      vehicle.sinceJump = {};
    }
    if (length(vehicle.aside) < kBack || vehicle.sinceJump > kBelieved) vehicle.aside = {};
  }
  vehicle.last = now;
  vehicle.past.push_back({now.at, {now.pose.position + vehicle.aside, now.pose.heading}, now.speed});
}

std::optional<Pose> ReadCollector::poseAt(const std::deque<Known>& past, Seconds at) {
  const auto after = std::find_if(past.begin(), past.end(), [at](const Known& known) { return known.at >= at; });
  if (after == past.end()) {
    if (past.empty() || at - past.back().at > kBeyond) return std::nullopt;
    const Known& last = past.back();
    return Pose{placeOf(last.pose, {last.speed * (at - last.at), Metres{}}), last.pose.heading};
  }
  if (after == past.begin()) return std::nullopt;
  const Known& before = *(after - 1);
  const double share = (at - before.at) / (after->at - before.at);
  return Pose{before.pose.position + share * (after->pose.position - before.pose.position),
              before.pose.heading + share * turnBetween(before.pose.heading, after->pose.heading)};
}

void ReadCollector::add(const tilecheck::PlacedRead& read) {
  ++taken_;
  OfTag& known = ofTag_[read.uid];
  if (known.reads.size() < kMostOfATag) {
    known.reads.push_back(reads_.size());
    reads_.push_back(read);
    return;
  }
  reads_[known.reads[known.next]] = read;
  known.next = (known.next + 1) % kMostOfATag;
}

void ReadCollector::clear() {
  reads_.clear();
  ofTag_.clear();
  passes_.clear();
}

}  // namespace tessera::ui
