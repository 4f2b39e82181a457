// A hostile or faulty presence on the channel, for trying out adversity: it hears every packet, and may change,
// suppress or repeat it, at seeded random or as told. It acts below the module's own checksum, as somebody with a radio
// of his own can, so that the protocol has to notice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "sim/random_stream.h"

namespace tessera::sim {

class ChannelTap {
public:
  /// Probabilities for each packet that passes.
  struct Rates {
    double corrupt = 0.0;  ///< one byte changed
    double drop = 0.0;     ///< suppressed at every receiver
    double replay = 0.0;   ///< a packet heard before is sent once more, as soon as the channel is free
  };
  using Filter = std::function<bool(std::span<const std::uint8_t>)>;

  ChannelTap() : random_{0, "channel tap"} {}

  void disturb(const Rates& rates, std::uint64_t seed);
  /// The next `count` packets that the filter knows (empty: any) get one byte changed, at `index` modulo their length.
  void corruptNext(std::size_t count, Filter which = {}, std::size_t index = 0);
  void dropNext(std::size_t count, Filter which = {});
  /// The newest packets as they were sent, oldest first, at most kMemory.
  [[nodiscard]] const std::deque<std::vector<std::uint8_t>>& heard() const { return heard_; }

  struct Counters {
    std::uint64_t corrupted = 0;
    std::uint64_t dropped = 0;
    std::uint64_t replayed = 0;
  };
  [[nodiscard]] const Counters& counters() const { return counters_; }

  static constexpr std::size_t kMemory = 256;

  // For the air:
  /// May change the packet's bytes. False: suppressed.
  bool pass(std::vector<std::uint8_t>& bytes);
  [[nodiscard]] std::vector<std::vector<std::uint8_t>> takeReplays();

private:
  struct Task {
    std::size_t count = 0;
    Filter which;
    std::size_t index = 0;
    /// Counts down when the packet is one of those meant.
    bool applies(std::span<const std::uint8_t> bytes);
  };
  void change(std::vector<std::uint8_t>& bytes, std::size_t index, std::uint8_t mask);

  Rates rates_;
  RandomStream random_;
  Task corrupt_;
  Task drop_;
  std::deque<std::vector<std::uint8_t>> heard_;
  std::vector<std::vector<std::uint8_t>> replays_;
  Counters counters_;
};

}  // namespace tessera::sim
