#include "firmware/vehicle/rangers.h"

#include <algorithm>

namespace tessera::firmware {
namespace {

constexpr Micros kStep = 35ms;  // two rangers: 70 ms each
constexpr float kMetresPerMicro = 1e-2F / 58.0F;
constexpr std::uint32_t kShortest = 116;    // µs, 2 cm
constexpr std::uint32_t kLongest = 23'200;  // µs, 4 m; without an echo the sensor ends its pulse by itself after 38 ms
constexpr int kTooShortToFault = 10;
constexpr float kHysteresis = 0.05F;
constexpr Micros kClearTime = 1s;

}  // namespace

void Rangers::tick(Micros now) {
  if (now < next_) return;
  next_ = now + kStep;
  if (pinged_) collect(rangers_[turn_], board_.echo(turn_));
  turn_ = (turn_ + 1) % rangers_.size();
  board_.ping(turn_);
  pinged_ = true;
  judge(now);
}

// The median of five bears two outliers, which late interrupts make in either direction.
void Rangers::collect(Ranger& ranger, std::uint32_t echo) {
  const bool tooShort = echo > 0 && echo < kShortest;
  ranger.tooShort = tooShort ? std::min(ranger.tooShort + 1, kTooShortToFault) : 0;
  const bool free = echo == 0 || echo > kLongest || tooShort;
  ranger.last[ranger.next] = free ? kFree : static_cast<float>(echo) * kMetresPerMicro;
  ranger.next = (ranger.next + 1) % kWindow;
  auto sorted = ranger.last;
  std::sort(sorted.begin(), sorted.end());
  ranger.distance = sorted[kWindow / 2];
}

float Rangers::nearest() const {
  float distance = kFree;
  for (const Ranger& r : rangers_) distance = std::min(distance, r.distance);
  return distance;
}

void Rangers::judge(Micros now) {
  const float distance = nearest();
  if (distance < stopDistance_) obstacle_ = true;
  if (distance < stopDistance_ + kHysteresis) seen_ = now;
  if (stopDistance_ <= 0.0F || now - seen_ >= kClearTime) obstacle_ = false;
}

std::uint8_t Rangers::nearestCm() const {
  const float distance = nearest();
  if (distance >= kFree) return 255;
  return static_cast<std::uint8_t>(std::min(distance * 100.0F, 254.0F));
}

bool Rangers::faulty() const {
  return std::any_of(rangers_.begin(), rangers_.end(), [](const Ranger& r) { return r.tooShort >= kTooShortToFault; });
}

}  // namespace tessera::firmware
