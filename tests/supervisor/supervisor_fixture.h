// A supervisor with its site, its air and moving vehicles, run from event to event.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "floor/site_json.h"
#include "link/fake_air.h"
#include "supervisor/driven_vehicle.h"
#include "supervisor/supervisor.h"

namespace tessera::test {

inline std::shared_ptr<const floor::SiteMap> siteMap(const std::string& file) {
  auto site = floor::loadSite(std::string{TESSERA_SITES} + "/" + file);
  if (!site) throw std::runtime_error{site.error().sentence};
  return floor::SiteMap::build(std::move(*site)).value();
}

class SupervisorRig {
public:
  explicit SupervisorRig(const std::string& site = "paper.tessera.json", FakeAir::Options options = defaults())
      : SupervisorRig{siteMap(site), options} {}
  explicit SupervisorRig(std::shared_ptr<const floor::SiteMap> site, FakeAir::Options options = defaults(),
                         const supervisor::Config& config = {})
      : map{std::move(site)}, supervisor{supervisor::Supervisor::create(map, config).value()} {
    std::vector<FakeVehicle*> fakes;
    for (const floor::VehicleSetup& v : map->site().vehicles) {
      vehicles.push_back(std::make_unique<DrivenVehicle>(map, v.id, options.seed + v.id.value));
      fakes.push_back(&vehicles.back()->fake);
    }
    air = std::make_unique<FakeAir>(fakes, options);
    host.ingest = [this](wire::Bytes b, Seconds t) {
      if (plugged) supervisor.ingest(b, t);
    };
    host.poll = [this](Seconds t) {
      supervisor::TickOutput out = supervisor.tick(t);
      for (auto& v : vehicles) v->advance(t);
      for (auto& e : out.events) events.push_back(std::move(e));
      if (out.snapshot) last = out.snapshot;
      wrote.insert(wrote.end(), out.bytes.begin(), out.bytes.end());
      return std::pair{out.bytes, out.wake};
    };
    supervisor.portOpened("/dev/radio", air->now);
  }
  static FakeAir::Options defaults() {
    FakeAir::Options o;
    o.loss = 0.02;
    o.jitter = Seconds{0.003};
    return o;
  }

  void run(Seconds span) { air->run(host, air->now + span); }
  bool runUntil(const std::function<bool()>& condition, Seconds limit) {
    air->run(host, air->now + limit, [&](Seconds) { return condition(); });
    return condition();
  }
  void runRoute(std::uint8_t id, const std::string& route, double speed) {
    supervisor.post(supervisor::RunRoute{VehicleId{id}, route, MetresPerSecond{speed}});
  }
  [[nodiscard]] const supervisor::VehicleView& view(std::uint8_t id) const { return *last->find(VehicleId{id}); }
  [[nodiscard]] DrivenVehicle& vehicle(std::uint8_t id) { return *vehicles.at(id - 1U); }
  [[nodiscard]] std::vector<supervisor::Event> told(supervisor::EventKind kind, bool over = false) const {
    std::vector<supervisor::Event> found;
    for (const auto& e : events)
      if (e.kind == kind && e.over == over) found.push_back(e);
    return found;
  }
  void unplug() {
    plugged = false;
    supervisor.portLost("the other end is gone", air->now);
  }
  void plug() {
    plugged = true;
    supervisor.portOpened("/dev/radio", air->now);
  }

  std::shared_ptr<const floor::SiteMap> map;
  supervisor::Supervisor supervisor;
  std::vector<std::unique_ptr<DrivenVehicle>> vehicles;
  std::unique_ptr<FakeAir> air;
  FakeAir::Host host;
  std::vector<supervisor::Event> events;
  std::shared_ptr<const supervisor::Snapshot> last;
  std::vector<std::uint8_t> wrote;
  bool plugged = true;
};

}  // namespace tessera::test
