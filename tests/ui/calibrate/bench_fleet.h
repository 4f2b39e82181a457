// A fleet of one simulated vehicle on a cable: it runs the firmware's own sources in virtual time, as fast as it can.
#pragma once

#include <QTimer>
#include <deque>
#include <memory>

#include "sim/commission.h"
#include "sim/commission_bench.h"
#include "sim/native_host.h"
#include "ui/base/fleet_link.h"

namespace tessera::ui {

class BenchFleet final : public FleetLink {
public:
  BenchFleet(const floor::VehicleSetup& setup, const sim::BodyParameters& parameters) : setup_{setup} {
    const auto settings = sim::settingsFor(setup, {}, parameters);
    sim::VehicleWorldConfig config;
    config.setup = setup;
    config.body = parameters;
    auto owned = std::make_unique<sim::NativeHost>(firmware::makeEepromImage(settings.value()));
    host = owned.get();
    body = std::make_unique<sim::VehicleBody>(config, std::move(owned));
    (void)body->start(Seconds{});
    bench_ = std::make_unique<sim::CommissionBench>(*body, setup.key, Seconds{});
    (void)bench_->open();
    QObject::connect(&clock_, &QTimer::timeout, this, &BenchFleet::step);
    clock_.start(0);
  }

  [[nodiscard]] std::shared_ptr<const supervisor::Snapshot> latest() const override { return picture_; }
  bool post(supervisor::Order order) override {
    orders_.push_back(std::move(order));
    return true;
  }
  [[nodiscard]] firmware::Settings kept() const { return firmware::settingsFromImage(host->eeprom()).value(); }

  std::unique_ptr<sim::VehicleBody> body;
  sim::NativeHost* host = nullptr;
  bool old = false;  ///< its program knows nothing of surveys
  int asks = 0;

private:
  void step() {
    if (!orders_.empty()) {
      const supervisor::Order order = orders_.front();
      orders_.pop_front();
      if (const auto* ask = std::get_if<supervisor::Ask>(&order)) answer(ask->request);
      if (std::holds_alternative<supervisor::Stop>(order)) {
        wire::CycleEntry stop;
        stop.mode = wire::CommandMode::Stop;
        bench_->command(stop);
      }
      return;
    }
    bench_->run(Seconds{0.02});
    const auto report = bench_->poll();
    if (!report) return;
    supervisor::Snapshot snapshot;
    snapshot.time = bench_->now();
    snapshot.port.state = supervisor::PortState::Open;
    supervisor::VehicleView v;
    v.id = setup_.id;
    v.name = setup_.name;
    v.contact = supervisor::Contact::Connected;
    v.state = report->state;
    v.faults = report->faults;
    snapshot.vehicles.push_back(v);
    picture_ = std::make_shared<const supervisor::Snapshot>(std::move(snapshot));
    Q_EMIT snapshotChanged();
  }
  void answer(const wire::Request& request) {
    ++asks;
    const bool survey = request.type == wire::MessageType::Do || request.parameter >= 128;
    supervisor::Event event;
    event.kind = supervisor::EventKind::Answer;
    event.vehicle = setup_.id;
    event.sentence = "answered";
    event.answer =
        supervisor::AskAnswer{request, old && survey ? wire::Value{0, request.parameter, wire::Outcome::Unknown, 0}
                                                     : bench_->request(request)};
    Q_EMIT eventsArrived({event});
  }

  floor::VehicleSetup setup_;
  std::unique_ptr<sim::CommissionBench> bench_;
  std::shared_ptr<const supervisor::Snapshot> picture_;
  std::deque<supervisor::Order> orders_;
  QTimer clock_;
};

}  // namespace tessera::ui
