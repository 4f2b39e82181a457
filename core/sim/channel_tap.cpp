#include "sim/channel_tap.h"

#include <utility>

namespace tessera::sim {

namespace {

std::size_t pick(RandomStream& random, std::size_t count) {
  return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
}

}  // namespace

void ChannelTap::disturb(const Rates& rates, std::uint64_t seed) {
  rates_ = rates;
  random_ = RandomStream{seed, "channel tap"};
}

void ChannelTap::corruptNext(std::size_t count, Filter which, std::size_t index) {
  corrupt_ = {count, std::move(which), index};
}

void ChannelTap::dropNext(std::size_t count, Filter which) { drop_ = {count, std::move(which), 0}; }

bool ChannelTap::Task::applies(std::span<const std::uint8_t> bytes) {
  if (count == 0 || (which && !which(bytes))) return false;
  --count;
  return true;
}

void ChannelTap::change(std::vector<std::uint8_t>& bytes, std::size_t index, std::uint8_t mask) {
  if (bytes.empty()) return;
  bytes[index % bytes.size()] ^= mask;
  ++counters_.corrupted;
}

bool ChannelTap::pass(std::vector<std::uint8_t>& bytes) {
  heard_.push_back(bytes);
  if (heard_.size() > kMemory) heard_.pop_front();
  // Always the same number of draws a packet, so that one rate does not shift what another one does.
  const bool corrupts = random_.chance(rates_.corrupt);
  const bool drops = random_.chance(rates_.drop);
  const bool replays = random_.chance(rates_.replay);
  const std::size_t place = pick(random_, bytes.empty() ? 1 : bytes.size());
  const auto mask = static_cast<std::uint8_t>(1 + pick(random_, 255));
  const std::size_t old = pick(random_, heard_.size());
  if (replays) {
    replays_.push_back(heard_[old]);
    ++counters_.replayed;
  }
  if (corrupt_.applies(bytes))
    change(bytes, corrupt_.index, mask);
  else if (corrupts)
    change(bytes, place, mask);
  if (drop_.applies(bytes) || drops) {
    ++counters_.dropped;
    return false;
  }
  return true;
}

std::vector<std::vector<std::uint8_t>> ChannelTap::takeReplays() { return std::exchange(replays_, {}); }

}  // namespace tessera::sim
