// A queue between threads that neither grows nor locks: many may push, many may pop. A full queue refuses.
// D. Vyukov's bounded MPMC queue: each cell carries a ticket that says whose turn it is.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace tessera::supervisor {

template <class T, std::size_t Capacity>
class BoundedQueue {
  static_assert(Capacity >= 2 && (Capacity & (Capacity - 1)) == 0, "a power of two");

public:
  BoundedQueue() : cells_{std::make_unique<std::array<Cell, Capacity>>()} {
    for (std::size_t i = 0; i < Capacity; ++i) (*cells_)[i].ticket.store(i, std::memory_order_relaxed);
  }

  /// False: it is full, and `value` is untouched.
  bool tryPush(T&& value) {
    std::size_t at = head_.load(std::memory_order_relaxed);
    while (true) {
      Cell& cell = (*cells_)[at % Capacity];
      const auto ahead = static_cast<std::intptr_t>(cell.ticket.load(std::memory_order_acquire) - at);
      if (ahead < 0) return false;
      if (ahead == 0 && head_.compare_exchange_weak(at, at + 1, std::memory_order_relaxed)) {
        cell.value = std::move(value);
        cell.ticket.store(at + 1, std::memory_order_release);
        return true;
      }
      if (ahead > 0) at = head_.load(std::memory_order_relaxed);
    }
  }
  /// Nullopt: it is empty.
  std::optional<T> tryPop() {
    std::size_t at = tail_.load(std::memory_order_relaxed);
    while (true) {
      Cell& cell = (*cells_)[at % Capacity];
      const auto ahead = static_cast<std::intptr_t>(cell.ticket.load(std::memory_order_acquire) - (at + 1));
      if (ahead < 0) return std::nullopt;
      if (ahead == 0 && tail_.compare_exchange_weak(at, at + 1, std::memory_order_relaxed)) {
        std::optional<T> value{std::exchange(cell.value, T{})};
        cell.ticket.store(at + Capacity, std::memory_order_release);
        return value;
      }
      if (ahead > 0) at = tail_.load(std::memory_order_relaxed);
    }
  }

private:
  struct Cell {
    std::atomic<std::size_t> ticket{0};
    T value{};
  };
  std::unique_ptr<std::array<Cell, Capacity>> cells_;
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace tessera::supervisor
