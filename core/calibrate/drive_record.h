// A drive as a calibration sees it: what the vehicle told of its motion, and the tags that its readers read.
#pragma once

#include <cstddef>
#include <vector>

#include "base/pose.h"
#include "locate/observation.h"

namespace tessera::calibrate {

/// A tag that was read, with its place on the floor.
struct PlacedRead {
  int reader = 0;
  Point tag;
  Seconds at;
};

/// Between two instants, by odometer and reported heading.
struct Movement {
  Offset way;     ///< in the site's directions as the reported headings have them
  Metres length;  ///< driven, forwards or backwards
  Radians turn;   ///< net
};

class DriveRecord {
public:
  static constexpr std::size_t kMost = 200'000;  ///< motions; some hours

  /// In the order of their instants; one that is not newer than the last is passed over.
  void add(const locate::Motion& motion);
  /// In any order. Reads from before the first motion or after the last are not used.
  void add(const PlacedRead& read);
  void clear();

  [[nodiscard]] const std::vector<locate::Motion>& motions() const { return motions_; }
  [[nodiscard]] const std::vector<PlacedRead>& reads() const { return reads_; }
  /// Driven since the first motion.
  [[nodiscard]] Metres length() const;
  /// Turned since the first motion, both ways added up; what the compass trembles does not count.
  [[nodiscard]] Radians turned() const { return turned_; }

  [[nodiscard]] bool covers(Seconds at) const;
  /// Requires covers(at). The heading is unwrapped, as all headings in here are.
  [[nodiscard]] locate::Motion at(Seconds at) const;
  /// Requires covers() of both, from <= until.
  [[nodiscard]] Movement between(Seconds from, Seconds until) const;

private:
  std::vector<locate::Motion> motions_;  ///< headings unwrapped
  std::vector<PlacedRead> reads_;
  Radians turned_;
  Radians counted_;  ///< heading up to which turned_ counts
};

}  // namespace tessera::calibrate
