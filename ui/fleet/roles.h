// What the fleet's list models say of a cell beside its text; VehicleDelegate paints it.
#pragma once

#include <qnamespace.h>

namespace tessera::ui {

enum FleetRole {
  SortRole = Qt::UserRole,
  VehicleRole,   ///< int: address of the vehicle; absent: none
  SeverityRole,  ///< int(supervisor::Severity)
  IconRole,      ///< name of an icon
  ToneRole,      ///< int(Tone)
  DotRole,       ///< QColor of the vehicle
  PermilleRole,  ///< int, drawn as a bar
  TimeRole,      ///< QDateTime of an event
};

}  // namespace tessera::ui
