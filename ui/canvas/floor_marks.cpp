#include "ui/canvas/floor_marks.h"

#include <QSet>
#include <algorithm>
#include <cmath>

#include "ui/canvas/clip.h"

namespace tessera::ui {
namespace {

constexpr double kFrameFrom = 14.0;  // pixels of a place that is large enough for a frame of its own
constexpr double kRing = 14.0;       // pixels, around a smaller one
constexpr double kBeside = 20.0;  // pixels to the right and up from a handle, or where there is no room left and down

// A triangle for a warning, an octagon for an error, an exclamation mark in both: told apart without colours too.
void paintSign(QPainter& painter, QPointF at, bool severe, double size, const CanvasTheme& theme) {
  QPolygonF shape;
  if (severe) {
    for (int n = 0; n < 8; ++n) {
      const double turn = (n + 0.5) * kPi / 4;
      shape << at + size * QPointF{std::cos(turn), std::sin(turn)};
    }
  } else {
    shape << at + size * QPointF{0, -1.05} << at + size * QPointF{1.1, 0.85} << at + size * QPointF{-1.1, 0.85};
  }
  painter.setPen(QPen{theme.halo, 2.0, Qt::SolidLine, Qt::SquareCap, Qt::RoundJoin});
  painter.setBrush(severe ? theme.fault : theme.waiting);
  painter.drawPolygon(shape);
  painter.setPen(QPen{theme.dark ? QColor{Qt::black} : QColor{Qt::white}, 2.0, Qt::SolidLine, Qt::RoundCap});
  painter.drawLine(at + size * QPointF{0, -0.45}, at + size * QPointF{0, 0.12});
  painter.drawPoint(at + size * QPointF{0, 0.52});
}

void paintFrame(QPainter& painter, const View& view, const SiteBox& place, QPen pen) {
  QRectF frame = QRectF{view.toPixel({place.low.x, place.high.y}), view.toPixel({place.high.x, place.low.y})};
  // Beyond the window a frame may be larger than a painter bears.
  frame = frame.adjusted(-6, -6, 6, 6) & QRectF{QPointF{-20, -20}, view.size() + QSizeF{40, 40}};
  if (frame.isEmpty()) return;
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(frame, 5, 5);
}

// From where it is to its sign, where that stands beside it.
void paintTie(QPainter& painter, QPointF from, QPointF to, const CanvasTheme& theme, QColor colour) {
  if (from == to) return;
  for (const QPen& pen : {QPen{theme.halo, 4.0}, QPen{colour, 1.8}}) {
    painter.setPen(pen);
    painter.drawLine(from + 0.3 * (to - from), to);
  }
}

}  // namespace

QPointF signAt(const View& view, const FloorMark& mark, const HandleAt& handle) {
  const QPointF middle = view.toPixel(mark.place.centre());
  if (!handle || !handle(middle)) return middle;
  const bool right = middle.x() + kBeside + kMarkReach < view.size().width();
  const bool up = middle.y() - kBeside - kMarkReach > 0.0;
  return middle + QPointF{right ? kBeside : -kBeside, up ? -kBeside : kBeside};
}

void paintMarks(QPainter& painter, const View& view, const CanvasTheme& theme, const std::vector<FloorMark>& marks,
                std::optional<std::size_t> chosen, const HandleAt& handle) {
  painter.setRenderHint(QPainter::Antialiasing);
  const SiteBox seen = view.visible(20.0);
  QSet<QPair<int, int>> taken;
  for (const bool severe : {true, false}) {
    for (const FloorMark& mark : marks) {
      if (mark.severe != severe || !mark.place.touches(seen)) continue;
      const QPointF at = signAt(view, mark, handle);
      const QPair<int, int> cell{static_cast<int>(at.x() / (2 * kMarkReach)),
                                 static_cast<int>(at.y() / (2 * kMarkReach))};
      if (taken.contains(cell)) continue;
      taken.insert(cell);
      QColor colour = severe ? theme.fault : theme.waiting;
      colour.setAlpha(150);
      if (view.pixels(std::max(mark.place.width(), mark.place.height())) >= kFrameFrom)
        paintFrame(painter, view, mark.place, QPen{colour, 1.5, Qt::DashLine});
      paintTie(painter, view.toPixel(mark.place.centre()), at, theme, severe ? theme.fault : theme.waiting);
      paintSign(painter, at, severe, kMarkReach - 1, theme);
    }
  }
  if (!chosen || *chosen >= marks.size() || !marks[*chosen].place.touches(seen)) return;
  const FloorMark& mark = marks[*chosen];
  paintFrame(painter, view, mark.place, QPen{theme.halo, 5.0});
  paintFrame(painter, view, mark.place, QPen{theme.accent, 2.5});
  const QPointF at = signAt(view, mark, handle);
  paintTie(painter, view.toPixel(mark.place.centre()), at, theme, theme.accent);
  paintSign(painter, at, mark.severe, kMarkReach + 2, theme);
}

void paintRing(QPainter& painter, const View& view, const CanvasTheme& theme, const SiteBox& place) {
  if (!place.touches(view.visible(20.0))) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const bool framed = view.pixels(std::max(place.width(), place.height())) >= kFrameFrom;
  for (const QPen& pen : {QPen{theme.halo, 6.0}, QPen{theme.accent, 3.0}}) {
    if (framed) {
      paintFrame(painter, view, place, pen);
      continue;
    }
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(view.toPixel(place.centre()), kRing, kRing);
  }
}

const FloorMark* markAt(std::span<const FloorMark> marks, const View& view, QPointF pixel, const HandleAt& handle) {
  const FloorMark* found = nullptr;
  for (const FloorMark& mark : marks) {
    // Asked of few: handles cost more to find than a distance.
    const QPointF middle = view.toPixel(mark.place.centre()) - pixel;
    if (std::hypot(middle.x(), middle.y()) > kMarkReach + 1.5 * kBeside) continue;
    const QPointF away = signAt(view, mark, handle) - pixel;
    if (std::hypot(away.x(), away.y()) > kMarkReach || (found != nullptr && (found->severe || !mark.severe))) continue;
    found = &mark;
  }
  return found;
}

}  // namespace tessera::ui
