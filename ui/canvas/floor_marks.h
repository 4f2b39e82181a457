// Marks on the floor that point at what is wrong there. Of marks that would cover one another one is drawn; where there
// is something to be grabbed the sign stands beside it, tied to it by a line.
#pragma once

#include <QPainter>
#include <QString>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

struct FloorMark {
  SiteBox place;        ///< empty: nowhere in particular, so that nothing is drawn
  bool severe = false;  ///< an error; else a warning
  QString sentence;     ///< under the mouse
  int row = -1;         ///< by which whoever made it knows it; -1: it has no menu
  bool operator==(const FloorMark& o) const {
    return place.low == o.place.low && place.high == o.place.high && severe == o.severe && sentence == o.sentence &&
           row == o.row;
  }
};

inline constexpr double kMarkReach = 9.0;  ///< pixels from a mark's middle

/// Whether a handle lies at a pixel; empty: there are none.
using HandleAt = std::function<bool(QPointF)>;

/// The middle of the mark's sign.
[[nodiscard]] QPointF signAt(const View& view, const FloorMark& mark, const HandleAt& handle = {});
/// chosen: index of the one that is looked at; it lies on top, with its place framed.
void paintMarks(QPainter& painter, const View& view, const CanvasTheme& theme, const std::vector<FloorMark>& marks,
                std::optional<std::size_t> chosen, const HandleAt& handle = {});
/// Around what was asked for.
void paintRing(QPainter& painter, const View& view, const CanvasTheme& theme, const SiteBox& place);
/// The mark whose sign lies under the pixel, errors first; nullptr: none.
[[nodiscard]] const FloorMark* markAt(std::span<const FloorMark> marks, const View& view, QPointF pixel,
                                      const HandleAt& handle = {});

}  // namespace tessera::ui
