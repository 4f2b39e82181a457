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

/// Fades towards `under`, the colour of the floor. Pieces that do not reach `within` (pixels) are left out.
void paintTrail(QPainter& painter, const View& view, const Trail& trail, Seconds now, QColor colour, QColor under,
                const QRectF& within);
/// What came to the trail after that time.
void paintTrailEnd(QPainter& painter, const View& view, const Trail& trail, Seconds since, QColor colour, QColor under);
/// Where a command that is sent now will find it: as an outline, when it is seen to be another place.
[[nodiscard]] bool hasGhost(const View& view, const VehicleMark& mark);
void paintGhost(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark, const Pose& at);
/// Body, heading, badge.
void paintVehicle(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
/// What it sees ahead.
void paintObstacle(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark);
/// Grey when nothing is heard of it.
[[nodiscard]] QColor bodyColour(const VehicleMark& mark, const CanvasTheme& theme);
/// Its name, and how long it has been silent.
[[nodiscard]] QString labelOf(const VehicleMark& mark);
[[nodiscard]] QSizeF labelSize(const QString& text, const QFont& font);
/// At the upper left corner of the painter.
void paintVehicleLabel(QPainter& painter, const CanvasTheme& theme, const VehicleMark& mark);
/// age: 0 just read, 1 about to vanish.
void paintFlash(QPainter& painter, QPointF at, QColor colour, double age);

/// Half axes (pixels) and turn (degrees, counter-clockwise) of the ellipse that holds the place with 95 %.
struct Ellipse95 {
  double longAxis = 0.0;
  double shortAxis = 0.0;
  double degrees = 0.0;
};
[[nodiscard]] Ellipse95 ellipseOf(const std::array<double, 9>& covariance, double pixelsPerMetre);
/// Large enough to be seen, and not beyond all measure.
[[nodiscard]] bool isDrawn(const Ellipse95& ellipse);
/// The doubt about a vehicle's place, over its body, about the painter's origin.
void paintDoubt(QPainter& painter, const CanvasTheme& theme, const Ellipse95& ellipse, QColor colour);

}  // namespace tessera::ui
