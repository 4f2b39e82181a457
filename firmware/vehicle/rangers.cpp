#include "firmware/vehicle/rangers.h"

#include <algorithm>

namespace tessera::firmware {
namespace {

constexpr Micros kStep = 35ms;  // at least; on a tick of 10 ms that makes 40, and 80 for each of two rangers
constexpr float kMetresPerMicro = 1e-2F / 58.0F;
constexpr std::uint32_t kShortest = 116;    // µs, 2 cm
constexpr std::uint32_t kLongest = 25'000;  // µs; with nothing in reach the sensor ends its pulse by itself after 38 ms
constexpr int kTooShortToFault = 10;
constexpr int kSilentToFault = 5;
constexpr float kHysteresis = 0.05F;
constexpr Micros kClearTime = 1s;

}  // namespace

void Rangers::tick(Micros now) {
  if (now < next_) return;
  next_ = now + kStep;
  turn_ = (turn_ + 1) % rangers_.size();
  // The last ping's pulse had the time until now to come to its end.
  Ranger& ranger = rangers_[turn_];
  if (ranger.pinged) collect(ranger, board_.echo(turn_), now);
  board_.ping(turn_);
  ranger.pinged = true;
  judge(now);
}

// No pulse, or one that no distance makes, says nothing of the way: the distance stays until the ranger is given up.
void Rangers::collect(Ranger& ranger, std::uint32_t echo, Micros now) {
  ranger.silent = echo == 0 ? std::min(ranger.silent + 1, kSilentToFault) : 0;
  ranger.tooShort = echo > 0 && echo < kShortest ? std::min(ranger.tooShort + 1, kTooShortToFault) : 0;
  if (ranger.silent >= kSilentToFault || ranger.tooShort >= kTooShortToFault) ranger.faulty = true;
  if (echo < kShortest) {
    ranger.unanswered = now;
    return;
  }
  if (now - ranger.unanswered >= kClearTime) ranger.faulty = false;
  take(ranger, echo > kLongest ? kFree : static_cast<float>(echo) * kMetresPerMicro);
}

// The median of five bears two outliers, which late interrupts make in either direction.
void Rangers::take(Ranger& ranger, float distance) {
  ranger.last[ranger.next] = distance;
  ranger.next = (ranger.next + 1) % kWindow;
  auto sorted = ranger.last;
  std::sort(sorted.begin(), sorted.end());
  ranger.distance = sorted[kWindow / 2];
}

float Rangers::nearest() const {
  float distance = kFree;
  for (const Ranger& r : rangers_)
    if (!r.faulty) distance = std::min(distance, r.distance);
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
  return std::any_of(rangers_.begin(), rangers_.end(), [](const Ranger& r) { return r.faulty; });
}

}  // namespace tessera::firmware
