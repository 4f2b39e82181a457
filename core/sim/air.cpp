#include "sim/air.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "wire/airtime.h"

namespace tessera::sim {

namespace {

constexpr std::array<double, kAirRates> kBitRates{300, 1200, 2400, 4800, 9600, 19200};
constexpr std::size_t kPacketBytes = 58;

bool overlap(const Packet& a, const Packet& b) { return a.start < b.end && b.start < a.end; }

}  // namespace

double bitRateOf(int airRate) { return kBitRates[static_cast<std::size_t>(std::clamp(airRate, 0, kAirRates - 1))]; }

std::optional<int> airRateOf(double bitsPerSecond) {
  for (int i = 0; i < kAirRates; ++i)
    if (std::abs(bitRateOf(i) - bitsPerSecond) < 0.5) return i;
  return std::nullopt;
}

Seconds timeOnAir(int airRate, std::size_t bytes) { return Seconds{wire::loRaAirtime(bytes, bitRateOf(airRate))}; }

std::size_t Air::join() {
  modules_.emplace_back();
  return modules_.size() - 1;
}

void Air::tune(std::size_t module, std::optional<Tuning> tuning, Seconds now) {
  Module& m = modules_.at(module);
  if (m.tuning == tuning) return;
  m.tuning = tuning;
  m.since = now;
}

Seconds Air::transmit(std::size_t module, const Tuning& tuning, std::uint16_t address,
                      std::span<const std::uint8_t> bytes, Seconds start) {
  const Seconds length = settings_.factor * timeOnAir(tuning.airRate, bytes.size());
  Packet packet{{bytes.begin(), bytes.end()}, tuning, address, module, start, start + length, false};
  ++counters_.packets;
  modules_.at(module).sending += length;
  if (module != stranger_) packet.destroyed = !tap_.pass(packet.bytes);
  bool met = false;
  for (Packet& other : under_) {
    if (other.tuning.channel != tuning.channel || !overlap(other, packet)) continue;
    other.destroyed = true;
    packet.destroyed = true;
    met = true;
  }
  if (met) ++counters_.collided;
  under_.push_back(std::move(packet));
  for (auto& replay : tap_.takeReplays()) foreign_.push_back({tuning, std::move(replay)});
  return start + length;
}

void Air::breakOff(std::size_t module) {
  for (Packet& packet : under_)
    if (packet.sender == module) packet.destroyed = true;
}

void Air::inject(const Tuning& tuning, std::span<const std::uint8_t> bytes) {
  for (std::size_t at = 0; at < bytes.size(); at += kPacketBytes) {
    const auto piece = bytes.subspan(at, std::min(kPacketBytes, bytes.size() - at));
    foreign_.push_back({tuning, {piece.begin(), piece.end()}});
  }
}

bool Air::busy(int channel, Seconds now) const {
  return std::any_of(under_.begin(), under_.end(),
                     [&](const Packet& p) { return p.tuning.channel == channel && p.end > now; });
}

void Air::sendForeign(Seconds now) {
  if (foreign_.empty() || busy(foreign_.front().tuning.channel, now)) return;
  if (!stranger_) stranger_ = join();
  const Foreign next = std::move(foreign_.front());
  foreign_.pop_front();
  transmit(*stranger_, next.tuning, 0, next.bytes, now);
}

void Air::deliver(const Packet& packet, std::vector<Delivery>& out) {
  for (std::size_t i = 0; i < modules_.size(); ++i) {
    const Module& m = modules_[i];
    if (i == packet.sender || m.tuning != packet.tuning || m.since > packet.start) continue;
    // The draw comes before the question whether the packet is whole: one collision must not shift later draws.
    const bool missed = random_.chance(settings_.loss);
    if (packet.destroyed) continue;
    ++(missed ? counters_.lost : counters_.delivered);
    if (!missed) out.push_back({i, packet, packet.end + settings_.delay});
  }
}

std::vector<Air::Delivery> Air::settle(Seconds now) {
  std::vector<Packet> over;
  for (auto it = under_.begin(); it != under_.end();) {
    if (it->end + settings_.delay <= now) {
      over.push_back(std::move(*it));
      it = under_.erase(it);
    } else {
      ++it;
    }
  }
  std::sort(over.begin(), over.end(),
            [](const Packet& a, const Packet& b) { return a.end != b.end ? a.end < b.end : a.sender < b.sender; });
  std::vector<Delivery> out;
  for (const Packet& packet : over) deliver(packet, out);
  sendForeign(now);
  return out;
}

double Air::dutyCycle(std::size_t module, Seconds now) const {
  return now > Seconds{} ? modules_.at(module).sending / now : 0.0;
}

}  // namespace tessera::sim
