#include "firmware/vehicle/bend.h"

#include <algorithm>
#include <cmath>

#include "firmware/vehicle/angles.h"

namespace tessera::firmware {
namespace {

constexpr float kIron = kPi / 9.0F;       // 20 degrees: what the compass turns by between two spots of iron
constexpr float kMostDifference = 0.15F;  // between the tyres, a share of the way
constexpr float kStretch = 0.10F;         // m: long enough that the samples' noise is small beside the largest bend

}  // namespace

void Bend::configure(float length, float track) {
  length_ = length;
  most_ = kMostDifference / track;
  doubt_ = length > 0.0F ? kIron / length : 0.0F;
  if (length <= 0.0F) way_ = turned_ = learned_ = believed_ = 0.0F;
}

void Bend::learn(float way, float correction) {
  if (length_ <= 0.0F) return;
  way_ += way;
  turned_ += correction;
  if (std::fabs(way_) < kStretch) return;
  // No tyres bend the way more than this: what is above was a push, or the vehicle was carried.
  const float largest = most_ * std::fabs(way_);
  const float turned = std::clamp(turned_, -largest, largest);
  learned_ -= std::copysign(turned, turned * way_) / length_;
  learned_ = std::clamp(learned_, -most_, most_);
  way_ = turned_ = 0.0F;
  const float size = std::fabs(learned_);
  believed_ = std::copysign(std::clamp(2.0F * (size - doubt_), 0.0F, size), learned_);
}

}  // namespace tessera::firmware
