// Where a vehicle was in the last minute: few points, so that a hundred trails can be drawn every frame.
#pragma once

#include <QPolygonF>
#include <deque>
#include <vector>

#include "base/pose.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

class Trail {
public:
  static constexpr Seconds kSpan{60.0};
  static constexpr Metres kStep{0.03};  ///< points lie at least so far apart
  static constexpr Metres kLeap{1.0};   ///< farther at once is no drive: the vehicle was lifted, or found anew
  static constexpr std::size_t kMost = 2000;

  /// Time goes forward only; an earlier one begins anew.
  void add(Point place, Seconds time);
  /// The next point begins a new piece.
  void interrupt() { broken_ = true; }
  void clear();
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  /// When the last point was added; the trail must have one.
  [[nodiscard]] Seconds last() const { return points_.back().time; }

  struct Piece {
    QPolygonF line;    ///< pixels
    double age = 0.0;  ///< 0 just now, 1 about to vanish
  };
  /// Pieces of similar age, oldest first, without points that make less than half a pixel's difference.
  [[nodiscard]] std::vector<Piece> pieces(const View& view, Seconds now, int bands) const;
  /// The lines (pixels) to the points that are younger than `time`, from the last older one on.
  [[nodiscard]] std::vector<QPolygonF> since(const View& view, Seconds time) const;

private:
  struct Mark {
    Point place;
    Seconds time;
    bool begins;
  };
  std::deque<Mark> points_;
  bool broken_ = true;
};

}  // namespace tessera::ui
