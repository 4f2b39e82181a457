// The colours of the floor, light or dark after the window's palette. Chosen to be told apart by colour-blind eyes.
#pragma once

#include <QColor>
#include <QPalette>

#include "floor/site.h"

namespace tessera::ui {

struct CanvasTheme {
  explicit CanvasTheme(const QPalette& palette);

  bool dark = false;
  QColor background;  ///< beyond the floor
  QColor grid;
  QColor tile;
  QColor seam;  ///< between tiles
  QColor serial;
  QColor tag;
  QColor missingTag;  ///< a place of the tile's type without a registered tag
  QColor text;
  QColor quietText;
  QColor halo;   ///< behind text and thin lines
  QColor panel;  ///< behind small tables of text
  QColor route;
  QColor selectedRoute;
  QColor onRoute;  ///< on top of a route's line: numbers, arrows
  QColor accent;   ///< handles, snapping, selection
  QColor fault;
  QColor waiting;
  QColor silent;

  [[nodiscard]] QColor zone(floor::ZoneKind kind) const;
};

}  // namespace tessera::ui
