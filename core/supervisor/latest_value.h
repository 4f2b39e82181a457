// The newest of many values, handed from one writer to any number of readers. The writer never waits for a reader: if
// one is just taking its copy, the value is passed over, for the next one comes soon. Readers wait for the length of
// one exchange of pointers at most. (std::atomic<std::shared_ptr> would do, but the one of libstdc++ 12 unlocks with
// relaxed order, which is a data race.)
#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <utility>

namespace tessera::supervisor {

template <class T>
class LatestValue {
public:
  /// False: a reader was in the way and the value was not taken.
  bool tryStore(std::shared_ptr<const T> value) {
    if (busy_.test_and_set(std::memory_order_acquire)) return false;
    value_.swap(value);
    busy_.clear(std::memory_order_release);
    return true;  // the old value dies here, outside
  }
  /// Null before the first.
  [[nodiscard]] std::shared_ptr<const T> load() const {
    while (busy_.test_and_set(std::memory_order_acquire)) std::this_thread::yield();
    std::shared_ptr<const T> copy = value_;
    busy_.clear(std::memory_order_release);
    return copy;
  }

private:
  mutable std::atomic_flag busy_;
  std::shared_ptr<const T> value_;
};

}  // namespace tessera::supervisor
