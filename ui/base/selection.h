// Which vehicle, route and zone the operator means: one choice that floor, lists, charts and buttons share.
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "base/ids.h"

namespace tessera::ui {

class Selection : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  [[nodiscard]] std::optional<VehicleId> vehicle() const { return vehicle_; }
  /// Name of a route of the site; empty: none.
  [[nodiscard]] const QString& route() const { return route_; }
  /// Name of a zone of the site; empty: none.
  [[nodiscard]] const QString& zone() const { return zone_; }

  void setVehicle(std::optional<VehicleId> vehicle);
  void setRoute(const QString& route);
  void setZone(const QString& zone);

Q_SIGNALS:
  void vehicleChanged();
  void routeChanged();
  void zoneChanged();

private:
  std::optional<VehicleId> vehicle_;
  QString route_;
  QString zone_;
};

}  // namespace tessera::ui
