// A cell in which one thread leaves values for another; only the newest waits. Neither side ever waits for the other:
// putting and taking exchange one pointer.
#pragma once

#include <atomic>
#include <memory>

namespace tessera::sitecheck {

template <class T>
class Newest {
public:
  Newest() = default;
  Newest(const Newest&) = delete;
  Newest& operator=(const Newest&) = delete;
  ~Newest() { delete value_.load(); }

  /// What waited there is dropped.
  void put(std::unique_ptr<T> value) {
    const std::unique_ptr<T> old{value_.exchange(value.release(), std::memory_order_acq_rel)};
  }
  /// Null: nothing was put since the last taking.
  [[nodiscard]] std::unique_ptr<T> take() {
    return std::unique_ptr<T>{value_.exchange(nullptr, std::memory_order_acq_rel)};
  }

private:
  std::atomic<T*> value_{nullptr};
};

}  // namespace tessera::sitecheck
