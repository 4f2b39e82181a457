// A fleet that is what the test says, and keeps the orders that it was given.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "ui/base/fleet_link.h"

namespace tessera::ui {

class FakeLink : public FleetLink {
public:
  [[nodiscard]] std::shared_ptr<const supervisor::Snapshot> latest() const override { return picture; }
  bool post(supervisor::Order order) override {
    if (!takes) return false;
    orders.push_back(std::move(order));
    return true;
  }

  void show(supervisor::Snapshot snapshot) {
    picture = std::make_shared<const supervisor::Snapshot>(std::move(snapshot));
    Q_EMIT snapshotChanged();
  }
  void vanish() {
    picture = nullptr;
    Q_EMIT snapshotChanged();
  }
  void tell(const supervisor::Event& event) { Q_EMIT eventsArrived({event}); }
  /// The vehicle answers the last Ask.
  void answer(wire::Outcome outcome, std::int32_t value) {
    const auto* ask = std::get_if<supervisor::Ask>(&orders.back());
    if (ask == nullptr) throw std::runtime_error{"nothing was asked"};
    supervisor::Event event;
    event.kind = supervisor::EventKind::Answer;
    event.vehicle = ask->vehicle;
    event.sentence = "answered";
    event.answer = supervisor::AskAnswer{
        ask->request, wire::Value{.ack = 0, .parameter = ask->request.parameter, .outcome = outcome, .value = value}};
    tell(event);
  }
  template <class Order>
  [[nodiscard]] std::size_t count() const {
    std::size_t n = 0;
    for (const auto& o : orders) n += std::holds_alternative<Order>(o) ? 1 : 0;
    return n;
  }
  template <class Order>
  [[nodiscard]] const Order& last() const {
    return std::get<Order>(orders.back());
  }

  std::shared_ptr<const supervisor::Snapshot> picture;
  std::vector<supervisor::Order> orders;
  bool takes = true;
};

/// An open port and vehicles in contact.
inline supervisor::Snapshot seenVehicles(std::vector<std::uint8_t> ids, Seconds time = Seconds{10.0}) {
  supervisor::Snapshot snapshot;
  snapshot.time = time;
  snapshot.port = {supervisor::PortState::Open, "/dev/ttyUSB0", "The port is open."};
  for (const std::uint8_t id : ids) {
    supervisor::VehicleView v;
    v.id = VehicleId{id};
    v.name = "AGV " + std::to_string(id);
    v.contact = supervisor::Contact::Connected;
    v.firmware = "1.0.0 on lm3s6965";
    v.batteryVolts = 12.4;
    v.readersAnswering = 0x07;
    snapshot.vehicles.push_back(v);
  }
  return snapshot;
}

}  // namespace tessera::ui
