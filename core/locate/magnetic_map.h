// By how much the floor's iron turns a compass, from place to place: a grid over the site, learned by vehicles that
// know where they are. An added horizontal field has a direction in the world, so it turns the field by the same angle
// whichever way the vehicle looks: one angle a place is all that a bearing tells of it.
//
// Between the nodes it is bilinear, as in Gutmann, Eade, Fong, Munich, "Vector Field SLAM - Localization by Learning
// the Spatial Variation of Continuous Signals", IEEE Transactions on Robotics 28(3), 2012. Unlike there the nodes'
// errors are kept apart from each other, as in a map that grows with the floor and not with its square.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/pose.h"

namespace tessera::locate {

/// A node of the grid lies at column · kSpacing, row · kSpacing of the site.
struct MagneticNode {
  std::int32_t column = 0;
  std::int32_t row = 0;
  auto operator<=>(const MagneticNode&) const = default;
};

/// What is known at a node or a place.
struct MagneticValue {
  double deviation = 0.0;    ///< rad, reported minus true heading, positive counter-clockwise
  double variance = 0.0;     ///< rad²; the prior's where nobody has driven
  std::uint32_t visits = 0;  ///< that taught it; of a place: of the nearest node

  /// 0: nothing is known, to nearly 1.
  [[nodiscard]] double known() const;
};

/// A value like any other: copies share what they have in common, so a picture for another thread costs a pointer for
/// each 1.4 m². Not to be changed and read at once.
class MagneticMap {
public:
  static constexpr Metres kSpacing{0.15};
  static constexpr double kPriorSigma = 0.06;   ///< rad, of a floor that nobody has driven over; its mean is zero
  static constexpr double kLeastSigma = 0.015;  ///< rad; nothing is known better, so that floors may change
  static constexpr std::int32_t kFarthest = 1'000'000;  ///< columns and rows beyond are not kept
  static constexpr std::size_t kMostBlocks = 40'000;    ///< 5.7 ha

  struct Share {
    MagneticNode node;
    double weight = 0.0;
  };
  /// The four nodes around a place, and how much each says there; they add up to 1.
  [[nodiscard]] static std::array<Share, 4> sharesAt(Point place);
  [[nodiscard]] static Point placeOf(MagneticNode node);

  [[nodiscard]] MagneticValue at(Point place) const;
  [[nodiscard]] MagneticValue at(MagneticNode node) const;
  [[nodiscard]] bool empty() const { return blocks_.empty(); }

  /// One visit measured `deviation` with this variance, apart from what was known. What contradicts is taken in with
  /// less weight and makes the node doubted, so that one wrong visit does little and a changed floor is followed.
  /// False: no number, or too far away.
  bool learn(MagneticNode node, double deviation, double variance);
  /// Puts a node as it was kept. False: what is no number or out of range.
  bool put(MagneticNode node, const MagneticValue& value);
  void clear() { blocks_.clear(); }

  /// All nodes that were visited, by block and within it by row.
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (const Entry& entry : blocks_)
      for (std::int32_t i = 0; i < kSide * kSide; ++i)
        if (const MagneticValue& v = entry.block->values[static_cast<std::size_t>(i)]; v.visits > 0)
          visit(MagneticNode{entry.corner.column * kSide + i % kSide, entry.corner.row * kSide + i / kSide}, v);
  }
  [[nodiscard]] std::size_t nodeCount() const;

private:
  static constexpr std::int32_t kSide = 8;
  struct Block {
    std::array<MagneticValue, static_cast<std::size_t>(kSide* kSide)> values;
  };
  struct Entry {
    MagneticNode corner;                 ///< in blocks
    std::shared_ptr<const Block> block;  ///< never changed: a new one takes its place
  };
  [[nodiscard]] std::size_t find(MagneticNode corner) const;

  std::vector<Entry> blocks_;  ///< sorted
};

/// Seconds over which a vehicle's heading follows its compass (the wheels tell the rest): a sample each 20 ms, of which
/// 3 % is believed, the default of wire::Parameter::CompassRatio.
inline constexpr double kCompassMemory = 0.667;

/// What a vehicle's compass is off by wherever it is: its mounting, and what its calibration has left.
struct OwnDeviation {
  double mean = 0.0;         ///< rad
  double variance = 0.0049;  ///< rad²
};

/// What a locator may expect of its vehicle's compass.
struct MagneticOutlook {
  std::shared_ptr<const MagneticMap> map;  ///< null: nothing
  OwnDeviation own;
};

}  // namespace tessera::locate
