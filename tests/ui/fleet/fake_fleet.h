// A fleet of values: tests say what the supervision would, and read what it was told.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ui/base/fleet_link.h"
#include "ui/base/site_document.h"

namespace tessera::ui {

class FakeFleet : public FleetLink {
public:
  using FleetLink::FleetLink;

  [[nodiscard]] std::shared_ptr<const supervisor::Snapshot> latest() const override { return latest_; }
  bool post(supervisor::Order order) override {
    if (!takesOrders) return false;
    orders.push_back(std::move(order));
    return true;
  }

  void show(const supervisor::Snapshot& snapshot) {
    latest_ = std::make_shared<const supervisor::Snapshot>(snapshot);
    Q_EMIT snapshotChanged();
  }
  void showNothing() {
    latest_.reset();
    Q_EMIT snapshotChanged();
  }
  void tell(const std::vector<supervisor::Event>& events) { Q_EMIT eventsArrived(events); }

  /// The orders of one kind, oldest first.
  template <class Order>
  [[nodiscard]] std::vector<Order> all() const {
    std::vector<Order> found;
    for (const auto& order : orders)
      if (const auto* one = std::get_if<Order>(&order)) found.push_back(*one);
    return found;
  }

  std::vector<supervisor::Order> orders;
  bool takesOrders = true;

private:
  std::shared_ptr<const supervisor::Snapshot> latest_;
};

/// A site with so many vehicles, "AGV 1" and so on, and these routes, each 3 m along x and 1 m along y.
inline floor::Site fakeSite(int vehicles, const std::vector<std::string>& routes) {
  floor::Site site;
  site.name = "Test";
  for (int i = 1; i <= vehicles; ++i) {
    floor::VehicleSetup setup;
    setup.id = VehicleId{static_cast<std::uint8_t>(i)};
    setup.name = "AGV " + std::to_string(i);
    setup.maxSpeed = MetresPerSecond{0.5};
    site.vehicles.push_back(setup);
  }
  for (const std::string& name : routes) {
    floor::Route route;
    route.name = name;
    route.vertices = {{Metres{0.0}, Metres{0.0}}, {Metres{3.0}, Metres{0.0}}, {Metres{3.0}, Metres{1.0}}};
    site.routes.push_back(route);
  }
  return site;
}

/// The document shows that site.
inline void openFakeSite(SiteDocument& document, int vehicles, const std::vector<std::string>& routes) {
  document.replace(floor::SiteMap::build(fakeSite(vehicles, routes)).value(), QString{});
}

/// Connected, located, heard a moment ago, without a task.
inline supervisor::VehicleView fakeVehicle(int id) {
  supervisor::VehicleView v;
  v.id = VehicleId{static_cast<std::uint8_t>(id)};
  v.name = "AGV " + std::to_string(id);
  v.contact = supervisor::Contact::Connected;
  v.located = true;
  v.batteryVolts = 24.6;
  v.link.lastHeard = Seconds{10.0};
  v.link.age = Seconds{0.2};
  v.link.roundTrip = Seconds{0.048};
  v.link.loss = 0.02;
  v.covariance = {2.5e-5, 0.0, 0.0, 0.0, 2.5e-5, 0.0, 0.0, 0.0, 1e-4};
  return v;
}

/// The port is open and every vehicle stands ready.
inline supervisor::Snapshot fakeSnapshot(int vehicles, double time = 10.0) {
  supervisor::Snapshot snapshot;
  snapshot.time = Seconds{time};
  snapshot.port.state = supervisor::PortState::Open;
  snapshot.port.name = "/dev/ttyUSB0";
  for (int i = 1; i <= vehicles; ++i) snapshot.vehicles.push_back(fakeVehicle(i));
  return snapshot;
}

inline void setRunning(supervisor::VehicleView& v, const std::string& route, double progress, double length) {
  v.task = supervisor::Task::Running;
  v.state = wire::VehicleState::Driving;
  v.route = route;
  v.progress = Metres{progress};
  v.length = Metres{length};
  v.speed = MetresPerSecond{0.3};
  v.command = supervisor::CommandView{wire::CommandMode::Drive, MetresPerSecond{0.3}, {}, {}, {}, {}};
}

}  // namespace tessera::ui
