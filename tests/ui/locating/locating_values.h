// Pictures of a fleet whose first vehicle is watched, as a supervision would give them.
#pragma once

#include "supervisor/locating_view.h"
#include "tests/ui/fleet/fake_fleet.h"

namespace tessera::ui {

/// AGV 1 at x along the first tiles, its guesses within 2 cm about it, aiming 30 cm ahead.
inline supervisor::Snapshot watchedSnapshot(double time, double x, std::vector<locate::Innovation> innovations = {}) {
  supervisor::Snapshot snapshot = fakeSnapshot(1, time);
  supervisor::VehicleView& vehicle = snapshot.vehicles.front();
  vehicle.pose = {{Metres{x}, Metres{0.4}}, {}};
  vehicle.covariance = {1e-4, 0.0, 0.0, 0.0, 1e-4, 0.0, 0.0, 0.0, 1e-4};
  auto view = std::make_shared<supervisor::LocatingView>();
  view->vehicle = vehicle.id;
  view->locator = "particles";
  view->located = true;
  view->at = Seconds{time - 0.15};
  view->estimate = {{Metres{x - 0.02}, Metres{0.4}}, {}};
  view->covariance = vehicle.covariance;
  for (int i = 0; i < 200; ++i)
    view->guesses.push_back({Metres{x - 0.04 + 0.0002 * i}, Metres{0.38 + 0.0002 * ((i * 37) % 200)}});
  view->predicted = {{Metres{x + 0.05}, Metres{0.4}}, {}};
  view->way = {view->estimate, vehicle.pose, view->predicted};
  view->effectiveAt = Seconds{time + 0.2};
  view->hold = Seconds{0.25};
  view->aim = Point{Metres{x + 0.35}, Metres{0.42}};
  view->innovations = std::move(innovations);
  view->counters.reads = 12;
  view->counters.rejected = 1;
  snapshot.watched = std::move(view);
  return snapshot;
}

inline locate::Innovation innovationAt(double time, double nis) {
  locate::Innovation i;
  i.at = Seconds{time};
  i.nis = nis;
  return i;
}

}  // namespace tessera::ui
