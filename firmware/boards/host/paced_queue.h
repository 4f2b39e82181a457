// Bytes on a UART's wire: each takes ten bit times, one after the other, however fast they were handed over.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace tessera::firmware {

/// Instants are ns, so that the rounding of a byte time does not add up.
class PacedQueue {
public:
  explicit PacedQueue(std::size_t capacity) : capacity_{capacity} {}

  void setByteTime(std::uint64_t nanoseconds) { byteTime_ = nanoseconds; }
  /// A byte whose transmission starts now, or when the one before has ended. False when the queue is full.
  bool push(std::uint8_t byte, std::uint64_t now) {
    if (bytes_.size() >= capacity_) return false;
    end_ = std::max(end_, now) + byteTime_;
    bytes_.push_back({end_, byte});
    return true;
  }
  /// A byte that has just been received from a wire that paces already; one that does not is paced here.
  bool pushEnded(std::uint8_t byte, std::uint64_t now) { return push(byte, now < byteTime_ ? 0 : now - byteTime_); }
  /// The next byte whose last bit has passed.
  bool pop(std::uint8_t& byte, std::uint64_t now) {
    if (bytes_.empty() || bytes_.front().end > now) return false;
    byte = bytes_.front().value;
    bytes_.pop_front();
    return true;
  }
  [[nodiscard]] bool idle(std::uint64_t now) const { return bytes_.empty() || bytes_.back().end <= now; }
  void clear() {
    bytes_.clear();
    end_ = 0;
  }

private:
  struct Entry {
    std::uint64_t end;
    std::uint8_t value;
  };
  std::size_t capacity_;
  std::uint64_t byteTime_ = 0;
  std::uint64_t end_ = 0;
  std::deque<Entry> bytes_;
};

}  // namespace tessera::firmware
