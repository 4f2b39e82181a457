// Out of the pictures of the fleet: which tag was read, and where the reader was believed to be at that instant before
// anything was known of that read.
#pragma once

#include <deque>
#include <unordered_map>
#include <vector>

#include "supervisor/snapshot.h"
#include "tilecheck/tag_check.h"

namespace tessera::ui {

class ReadCollector {
public:
  /// Of one tag, the latest: a vehicle that stands on a tag says nothing new.
  static constexpr std::size_t kMostOfATag = 6;

  /// Each picture once, in their order.
  void take(const supervisor::Snapshot& snapshot, const floor::SiteMap& map);
  /// Forgets the reads; where the vehicles are is still known.
  void clear();
  [[nodiscard]] const std::vector<tilecheck::PlacedRead>& reads() const { return reads_; }
  /// How often each tag was passed over and read.
  [[nodiscard]] std::vector<tilecheck::TagPasses> passes() const {
    return last_ ? passes_.passes(*last_) : std::vector<tilecheck::TagPasses>{};
  }
  /// How many were ever taken.
  [[nodiscard]] std::size_t taken() const { return taken_; }

private:
  struct Known {
    Seconds at;
    Pose pose;
    MetresPerSecond speed;
  };
  struct OfTag {
    std::vector<std::size_t> reads;  ///< indices, the oldest at `next` once there are enough
    std::size_t next = 0;
  };
  struct Vehicle {
    std::deque<Known> past;     ///< with `aside` taken into account
    std::optional<Known> last;  ///< as the picture has it
    Offset aside;               ///< by which the picture is not believed
    Metres sinceJump;
    std::optional<Seconds> lastRead;
  };

  static void follow(Vehicle& vehicle, const Known& now);
  [[nodiscard]] static std::optional<Pose> poseAt(const std::deque<Known>& past, Seconds at);
  void add(const tilecheck::PlacedRead& read);

  std::unordered_map<VehicleId, Vehicle> vehicles_;
  std::vector<tilecheck::PlacedRead> reads_;
  std::unordered_map<floor::TagUid, OfTag> ofTag_;
  tilecheck::PassCounter passes_;
  std::optional<Seconds> last_;
  std::size_t taken_ = 0;
};

}  // namespace tessera::ui
