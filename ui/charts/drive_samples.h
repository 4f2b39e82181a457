// What the charts remember of every vehicle, in bounded memory: the last minute finely, the last quarter of an hour
// coarsely. No drawing here.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "supervisor/snapshot.h"

namespace tessera::ui {

/// Plain numbers, as single precision does for a chart. What is not known is NaN and leaves a gap.
struct DriveSample {
  double time = 0.0;        ///< s, of the supervisor
  float x = 0.0F;           ///< m, estimated place
  float y = 0.0F;           ///< m
  float heading = 0.0F;     ///< rad
  float crossTrack = 0.0F;  ///< m, positive to the left of the route
  float speed = 0.0F;       ///< m/s, reported
  float commanded = 0.0F;   ///< m/s
};

/// The newest `capacity` samples; the memory grows to that and no further.
class SampleRing {
public:
  explicit SampleRing(std::size_t capacity) : capacity_{capacity} {}

  void push(const DriveSample& sample);
  void clear();
  [[nodiscard]] std::size_t size() const { return samples_.size(); }
  [[nodiscard]] bool empty() const { return samples_.empty(); }
  /// 0 is the oldest.
  [[nodiscard]] const DriveSample& at(std::size_t i) const { return samples_[(first_ + i) % samples_.size()]; }
  [[nodiscard]] const DriveSample& back() const { return at(size() - 1); }

private:
  std::size_t capacity_;
  std::size_t first_ = 0;
  std::vector<DriveSample> samples_;
};

class DriveSamples {
public:
  static constexpr double kFineStep = 0.05;   ///< s, as often as charts are drawn
  static constexpr double kFineSpan = 60.0;   ///< s
  static constexpr double kCoarseStep = 0.5;  ///< s; the sample that lies farthest from the route stands for all
  static constexpr double kCoarseSpan = 900.0;

  /// Takes what is new in it. Time that runs backwards is another supervision's: everything before is forgotten.
  void take(const supervisor::Snapshot& snapshot);
  void clear();
  void clear(VehicleId vehicle);

  /// Those of the last `span` seconds before `until`, oldest first.
  [[nodiscard]] std::vector<DriveSample> window(VehicleId vehicle, double until, double span) const;
  /// Of the newest picture taken; negative: none yet.
  [[nodiscard]] double now() const { return now_; }

private:
  struct Track {
    SampleRing fine{static_cast<std::size_t>(kFineSpan / kFineStep) + 1};
    SampleRing coarse{static_cast<std::size_t>(kCoarseSpan / kCoarseStep) + 1};
    DriveSample extreme;        ///< of the coarse step under way
    double coarseSince = -1.0;  ///< negative: no step under way
  };
  static void push(Track& track, const DriveSample& sample);

  std::unordered_map<VehicleId, Track> tracks_;
  double now_ = -1.0;
};

}  // namespace tessera::ui
