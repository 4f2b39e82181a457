#include "sim/reader_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace tessera::sim {
namespace {

constexpr std::uint8_t kPoll = 0xB0;
constexpr std::uint8_t kAnswer = 0xD0;
constexpr double kEdgeReach = 6.0;  // widths beyond the edge where a read is as good as impossible (0.25 %)

}  // namespace

ReaderRow::ReaderRow(const ReaderParameters& parameters, std::vector<Offset> heads,
                     std::shared_ptr<const floor::SiteMap> map, std::uint64_t seed, std::uint64_t vehicle)
    : parameters_{parameters}, map_{std::move(map)} {
  for (std::size_t i = 0; i < heads.size() && i < kBatteryNode; ++i) {
    Head head{heads[i], RandomStream{seed, "reader", vehicle * 16 + i}, {}, {}, false, false, {}, {}, 0};
    head.next = Seconds{head.random.between(0.0, parameters_.pollPeriod.value())};
    heads_.push_back(std::move(head));
  }
}

void ReaderRow::setDeadTag(const floor::TagUid& uid, bool dead) {
  if (dead)
    deadTags_.insert(uid);
  else
    deadTags_.erase(uid);
}

floor::TagUid ReaderRow::attempt(Head& head, Point place) const {
  floor::TagUid nearest;
  if (!map_) return nearest;
  double best = 0.0;
  const Metres reach = parameters_.radius + kEdgeReach * parameters_.edgeWidth;
  map_->forEachNear(place, reach, [&](const floor::PlacedTag& tag) {
    const double away = distance(place, tag.place).value();
    const double beyond = (away - parameters_.radius.value()) / parameters_.edgeWidth.value();
    const bool answers = head.random.chance(parameters_.detection / (1.0 + std::exp(beyond)));
    if (!answers || deadTags_.contains(tag.uid)) return;
    // Of several tags that answer at once the nearest drowns the others.
    if (nearest.empty() || away < best) {
      nearest = tag.uid;
      best = away;
    }
  });
  return nearest;
}

void ReaderRow::stepHead(Head& head, Seconds now, const Pose& vehicle) {
  if (head.trying && now >= head.finish) {
    head.trying = false;
    head.result = std::exchange(head.found, {});
    ++head.attempts;
  }
  if (head.trying || now < head.next) return;
  head.trying = true;
  head.found = attempt(head, placeOf(vehicle, head.place));
  head.finish = now + parameters_.readTime;
  const double factor = 1.0 + head.random.between(-parameters_.jitter, parameters_.jitter);
  head.next = std::max(now + parameters_.pollPeriod * factor, head.finish);
}

void ReaderRow::step(Seconds now, const Pose& vehicle, double volts) {
  const auto millivolts = static_cast<std::uint16_t>(std::clamp(std::lround(volts * 1000.0), 0L, 65535L));
  if (millivolts != millivolts_) ++gaugeCounter_;
  millivolts_ = millivolts;
  for (Head& head : heads_) stepHead(head, now, vehicle);
}

void ReaderRow::receive(std::span<const std::uint8_t> bytes, Seconds now) {
  const Seconds byteTime{10.0 / parameters_.baud};
  for (const std::uint8_t byte : bytes) {
    // A byte may come from a UART that paces already (then it ends now) or from one that does not (then it is paced
    // here): it started no later than one byte time ago, and not before the one ahead of it had passed.
    lineEnd_ = std::max(lineEnd_, now - byteTime) + byteTime;
    const std::uint8_t first = std::exchange(address_, std::uint8_t{0});
    if ((byte & 0xF0U) == kPoll && first == 0)
      address_ = byte;
    else if (first != 0 && byte == static_cast<std::uint8_t>(~first))
      poll(first & 0x0FU, lineEnd_);
  }
}

void ReaderRow::poll(std::uint8_t node, Seconds at) {
  // Two talk at once: what is left of the earlier answer is spoilt, and its reader did not hear the poll.
  if (!answers_.empty() && answers_.back().end > at) {
    std::erase_if(answers_, [at](const TimedByte& b) { return b.end > at; });
    return;
  }
  if (node == kBatteryNode) {
    const std::array<std::uint8_t, 2> data{static_cast<std::uint8_t>(millivolts_),
                                           static_cast<std::uint8_t>(millivolts_ >> 8U)};
    answer(node, gaugeCounter_, data, at);
    return;
  }
  if (node >= heads_.size() || heads_[node].dead) return;
  answer(node, static_cast<std::uint8_t>(heads_[node].attempts), heads_[node].result.bytes(), at);
}

void ReaderRow::answer(std::uint8_t node, std::uint8_t counter, std::span<const std::uint8_t> data, Seconds at) {
  const Seconds byteTime{10.0 / parameters_.baud};
  Seconds end = at + parameters_.turnRound;
  std::uint8_t sum = 0;
  const auto put = [&](std::uint8_t byte) {
    sum ^= byte;
    end += byteTime;
    answers_.push_back({end, byte});
  };
  put(static_cast<std::uint8_t>(kAnswer | node));
  put(static_cast<std::uint8_t>(data.size()));
  put(counter);
  for (const std::uint8_t byte : data) put(byte);
  put(sum);
}

std::vector<std::uint8_t> ReaderRow::take(Seconds now) {
  std::vector<std::uint8_t> bytes;
  while (!answers_.empty() && answers_.front().end <= now) {
    bytes.push_back(answers_.front().value);
    answers_.pop_front();
  }
  return bytes;
}

}  // namespace tessera::sim
