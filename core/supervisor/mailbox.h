// What passes between the supervisor's thread and all others: orders in, events and the latest snapshot out. Values
// only; nobody waits for anybody.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "supervisor/bounded_queue.h"
#include "supervisor/event.h"
#include "supervisor/latest_value.h"
#include "supervisor/order.h"
#include "supervisor/snapshot.h"

namespace tessera::supervisor {

class Mailbox {
public:
  // From any thread.

  /// False: too many orders wait already; this one is not taken.
  bool post(Order order) { return orders_.tryPush(std::move(order)); }
  /// Null before the first one.
  [[nodiscard]] std::shared_ptr<const Snapshot> latest() const { return snapshot_.load(); }
  /// The events since the last call, oldest first.
  [[nodiscard]] std::vector<Event> takeEvents() {
    std::vector<Event> taken;
    while (auto event = events_.tryPop()) taken.push_back(std::move(*event));
    return taken;
  }
  /// Events that nobody fetched while there was room.
  [[nodiscard]] std::uint64_t eventsDropped() const { return dropped_.load(); }

  // From the supervisor's thread.

  [[nodiscard]] std::optional<Order> nextOrder() { return orders_.tryPop(); }
  /// False: it was passed over; the next one will do.
  bool publish(std::shared_ptr<const Snapshot> snapshot) { return snapshot_.tryStore(std::move(snapshot)); }
  void publish(Event event) {
    if (!events_.tryPush(std::move(event))) ++dropped_;
  }

private:
  BoundedQueue<Order, 256> orders_;
  BoundedQueue<Event, 4096> events_;
  LatestValue<Snapshot> snapshot_;
  std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace tessera::supervisor
