// A byte queue between an interrupt handler and the main loop: one side only puts, the other only takes.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tessera::firmware::lm3s6965 {

/// Holds up to N bytes; N is a power of two. Neither side waits and neither needs a lock (Lamport, 1983).
template <std::size_t N>
class Ring {
  static_assert(N > 0 && (N & (N - 1)) == 0);

public:
  /// False when it is full; the byte is not taken.
  bool put(std::uint8_t byte) {
    const std::uint32_t in = in_.load(std::memory_order_relaxed);
    if (in - out_.load(std::memory_order_acquire) == N) return false;
    bytes_[in % N] = byte;
    in_.store(in + 1, std::memory_order_release);
    return true;
  }
  /// False when it is empty; `byte` keeps its value.
  bool take(std::uint8_t& byte) {
    const std::uint32_t out = out_.load(std::memory_order_relaxed);
    if (in_.load(std::memory_order_acquire) == out) return false;
    byte = bytes_[out % N];
    out_.store(out + 1, std::memory_order_release);
    return true;
  }
  [[nodiscard]] bool empty() const {
    return in_.load(std::memory_order_acquire) == out_.load(std::memory_order_acquire);
  }
  /// For moments when the other side stands still only.
  void clear() { out_.store(in_.load(std::memory_order_relaxed), std::memory_order_relaxed); }

private:
  std::array<std::uint8_t, N> bytes_{};
  std::atomic<std::uint32_t> in_{0};
  std::atomic<std::uint32_t> out_{0};
};

}  // namespace tessera::firmware::lm3s6965
