// Draws what lies still under the vehicles: tiles, tags, zones, routes that are not chosen.
#pragma once

#include <QFont>
#include <QImage>
#include <QString>
#include <QVector>

#include "ui/canvas/backdrop_picture.h"
#include "ui/canvas/floor_index.h"
#include "ui/canvas/floor_mip.h"
#include "ui/canvas/layers.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

/// Beneath everything.
struct SceneBackdrop {
  floor::Backdrop place;
  std::shared_ptr<const BackdropPicture> picture;
};

struct FloorScene {
  std::shared_ptr<const floor::SiteMap> map;
  std::shared_ptr<const FloorIndex> index;
  std::shared_ptr<const FloorMip> mip;
  CanvasLayers layers;
  QString chosenRoute;
  bool withChosen = true;  ///< false: it is drawn elsewhere, as it is being changed
  QFont font;
  std::optional<SceneBackdrop> backdrop = {};
};

/// Below this many pixels between places tags are colours of cells, from it on dots.
inline constexpr double kDotPitch = 3.0;

/// Into an RGB32 image of the view's size and device pixel ratio; nothing outside `clip` (device pixels) changes.
void paintFloor(QImage& image, const View& view, const FloorScene& scene, const CanvasTheme& theme, const QRect& clip);

void paintZones(QPainter& painter, const View& view, const std::vector<floor::Zone>& zones, const CanvasTheme& theme);

}  // namespace tessera::ui
