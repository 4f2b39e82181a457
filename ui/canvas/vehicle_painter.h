// Draws vehicles: footprint and heading, name, state by shape as well as by colour, doubt, trail, what it just read.
#pragma once

#include <QPainter>
#include <QPolygonF>

#include "ui/canvas/fleet_layer.h"
#include "ui/canvas/layers.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

/// One vehicle as it is to be drawn in one frame.
struct VehicleMark {
  const supervisor::VehicleView* vehicle = nullptr;
  const floor::VehicleSetup* setup = nullptr;  ///< nullptr: the site does not have it (any more)
  Pose pose;                                   ///< smoothed
  QColor colour;
  bool chosen = false;
  VehicleLook look = VehicleLook::Fine;
};

/// Outline in pixels, never smaller than can be seen.
[[nodiscard]] QPolygonF footprintOf(const VehicleMark& mark, const View& view, const Pose& at);
/// Everything of the mark but its trail lies in here.
[[nodiscard]] QRectF extentOf(const VehicleMark& mark, const View& view, const QFont& font, const CanvasLayers& layers);

/// Fades towards `under`, the colour of the floor.
void paintTrail(QPainter& painter, const View& view, const Trail& trail, Seconds now, QColor colour, QColor under);
/// Where a command that is sent now will find it.
void paintGhost(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
void paintVehicle(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark,
                  const CanvasLayers& layers);
void paintVehicleLabel(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
/// age: 0 just read, 1 about to vanish.
void paintFlash(QPainter& painter, const View& view, Point place, QColor colour, double age);

/// Half axes (pixels) and turn (degrees, counter-clockwise) of the ellipse that holds the place with 95 %.
struct Ellipse95 {
  double longAxis = 0.0;
  double shortAxis = 0.0;
  double degrees = 0.0;
};
[[nodiscard]] Ellipse95 ellipseOf(const std::array<double, 9>& covariance, double pixelsPerMetre);

}  // namespace tessera::ui
