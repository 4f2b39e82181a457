#include "ui/base/selection.h"

namespace tessera::ui {

void Selection::setVehicle(std::optional<VehicleId> vehicle) {
  if (vehicle == vehicle_) return;
  vehicle_ = vehicle;
  Q_EMIT vehicleChanged();
}

void Selection::setRoute(const QString& route) {
  if (route == route_) return;
  route_ = route;
  Q_EMIT routeChanged();
}

void Selection::setZone(const QString& zone) {
  if (zone == zone_) return;
  zone_ = zone;
  Q_EMIT zoneChanged();
}

}  // namespace tessera::ui
