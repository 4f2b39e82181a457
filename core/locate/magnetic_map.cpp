#include "locate/magnetic_map.h"

#include <algorithm>
#include <cmath>

namespace tessera::locate {
namespace {

constexpr double kPrior = MagneticMap::kPriorSigma * MagneticMap::kPriorSigma;
constexpr double kLeast = MagneticMap::kLeastSigma * MagneticMap::kLeastSigma;
constexpr double kContradiction = 2.5;  // deviations beyond which a visit contradicts, and counts the less the farther
constexpr double kDoubt = 2.0;          // times the variance of a node that was contradicted
constexpr double kMostDeviation = 3.2;  // rad

std::int32_t floorDivided(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

bool within(MagneticNode node) {
  return std::abs(node.column) <= MagneticMap::kFarthest && std::abs(node.row) <= MagneticMap::kFarthest;
}

}  // namespace

double MagneticValue::known() const { return std::clamp(1.0 - variance / kPrior, 0.0, 1.0); }

std::array<MagneticMap::Share, 4> MagneticMap::sharesAt(Point place) {
  constexpr double kFar = kFarthest;
  const double x = std::clamp(place.x / kSpacing, -kFar, kFar);
  const double y = std::clamp(place.y / kSpacing, -kFar, kFar);
  const double left = std::floor(x);
  const double below = std::floor(y);
  const double right = x - left;
  const double up = y - below;
  const auto c = static_cast<std::int32_t>(left);
  const auto r = static_cast<std::int32_t>(below);
  return {Share{{c, r}, (1.0 - right) * (1.0 - up)}, Share{{c + 1, r}, right * (1.0 - up)},
          Share{{c, r + 1}, (1.0 - right) * up}, Share{{c + 1, r + 1}, right * up}};
}

Point MagneticMap::placeOf(MagneticNode node) {
  return {static_cast<double>(node.column) * kSpacing, static_cast<double>(node.row) * kSpacing};
}

std::size_t MagneticMap::find(MagneticNode corner) const {
  const auto it = std::lower_bound(blocks_.begin(), blocks_.end(), corner,
                                   [](const Entry& e, MagneticNode wanted) { return e.corner < wanted; });
  return static_cast<std::size_t>(std::distance(blocks_.begin(), it));
}

MagneticValue MagneticMap::at(MagneticNode node) const {
  const MagneticNode corner{floorDivided(node.column, kSide), floorDivided(node.row, kSide)};
  const std::size_t i = find(corner);
  if (i < blocks_.size() && blocks_[i].corner == corner) {
    const std::int32_t within = (node.row - corner.row * kSide) * kSide + node.column - corner.column * kSide;
    const MagneticValue& value = blocks_[i].block->values[static_cast<std::size_t>(within)];
    if (value.visits > 0) return value;
  }
  return {0.0, kPrior, 0};
}

MagneticValue MagneticMap::at(Point place) const {
  MagneticValue sum;
  if (!std::isfinite(place.x.value() + place.y.value())) return {0.0, kPrior, 0};
  double nearest = -1.0;
  for (const Share& share : sharesAt(place)) {
    const MagneticValue value = at(share.node);
    sum.deviation += share.weight * value.deviation;
    // Neighbours were mostly taught by the same visits: their errors are alike and do not average out.
    sum.variance += share.weight * value.variance;
    if (share.weight > nearest) sum.visits = value.visits;
    nearest = std::max(nearest, share.weight);
  }
  return sum;
}

bool MagneticMap::learn(MagneticNode node, double deviation, double variance) {
  if (!(std::abs(deviation) <= kMostDeviation && variance > 0.0 && std::isfinite(variance)) || !within(node))
    return false;
  MagneticValue value = at(node);
  const double off = deviation - value.deviation;
  const double tooFar = off * off / (value.variance + variance) / (kContradiction * kContradiction);
  const double gain = value.variance / (value.variance + variance * std::max(1.0, tooFar));
  value.deviation += gain * off;
  value.variance = std::max(kLeast, (1.0 - gain) * value.variance);
  if (tooFar > 1.0) value.variance = std::min(kPrior, kDoubt * value.variance);
  ++value.visits;
  return put(node, value);
}

bool MagneticMap::put(MagneticNode node, const MagneticValue& value) {
  if (!within(node) || value.visits == 0 || !(std::abs(value.deviation) <= kMostDeviation) ||
      !(value.variance > 0.0 && value.variance <= kPrior * (1.0 + 1e-6)))
    return false;
  const MagneticNode corner{floorDivided(node.column, kSide), floorDivided(node.row, kSide)};
  const std::size_t i = find(corner);
  const bool there = i < blocks_.size() && blocks_[i].corner == corner;
  if (!there && blocks_.size() >= kMostBlocks) return false;
  auto block = there ? std::make_shared<Block>(*blocks_[i].block) : std::make_shared<Block>();
  const std::int32_t place = (node.row - corner.row * kSide) * kSide + node.column - corner.column * kSide;
  block->values[static_cast<std::size_t>(place)] = value;
  if (there)
    blocks_[i].block = std::move(block);
  else
    blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(i), Entry{corner, std::move(block)});
  return true;
}

std::size_t MagneticMap::nodeCount() const {
  std::size_t count = 0;
  forEach([&](MagneticNode, const MagneticValue&) { ++count; });
  return count;
}

}  // namespace tessera::locate
