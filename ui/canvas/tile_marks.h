// Marks on tiles that were driven over: how far each is checked. Told apart by shape as well as by colour.
#pragma once

#include <QPainter>
#include <vector>

#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

struct TileMark {
  enum class Kind { Seen, Confirmed, Suspect };
  SiteBox place;
  Kind kind = Kind::Seen;
  bool operator==(const TileMark& o) const {
    return place.low == o.place.low && place.high == o.place.high && kind == o.kind;
  }
};

/// Those that touch `seen` (logical pixels).
void paintTileMarks(QPainter& painter, const View& view, const CanvasTheme& theme, const std::vector<TileMark>& marks,
                    const QRectF& seen);

}  // namespace tessera::ui
