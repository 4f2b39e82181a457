#include "ui/canvas/trail.h"

#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

// Keeps a point only when the line from the last kept one to the next would miss it by half a pixel.
class Thinned {
public:
  void add(QPointF p) {
    if (line_.size() >= 2 && isBetween(line_[line_.size() - 2], line_.back(), p) && ++skipped_ < 8) {
      line_.back() = p;
      return;
    }
    if (line_.empty() || std::abs(p.x() - line_.back().x()) + std::abs(p.y() - line_.back().y()) > 0.7) {
      line_ << p;
      skipped_ = 0;
    }
  }
  [[nodiscard]] QPolygonF take() {
    skipped_ = 0;
    return std::exchange(line_, {});
  }

private:
  static bool isBetween(QPointF a, QPointF middle, QPointF b) {
    const QPointF ab = b - a;
    const QPointF am = middle - a;
    const double square = QPointF::dotProduct(ab, ab);
    if (square < 1e-9) return false;
    const double along = QPointF::dotProduct(am, ab) / square;
    const double across = (ab.x() * am.y() - ab.y() * am.x());
    return along > 0.0 && along < 1.0 && across * across < 0.25 * square;
  }

  QPolygonF line_;
  int skipped_ = 0;
};

}  // namespace

void Trail::add(Point place, Seconds time) {
  if (!points_.empty() && time < points_.back().time) clear();
  while (!points_.empty() && time - points_.front().time > kSpan) points_.pop_front();
  if (!points_.empty()) {
    const Metres gone = distance(points_.back().place, place);
    if (!broken_ && gone < kStep) return;
    if (gone > kLeap) broken_ = true;
  }
  points_.push_back({place, time, broken_});
  broken_ = false;
  if (points_.size() > kMost) points_.pop_front();
}

void Trail::clear() {
  points_.clear();
  broken_ = true;
}

std::vector<Trail::Piece> Trail::pieces(const View& view, Seconds now, int bands) const {
  std::vector<Piece> pieces;
  Thinned line;
  int band = -1;
  const auto finish = [&] {
    if (QPolygonF points = line.take(); points.size() >= 2)
      pieces.push_back({std::move(points), (static_cast<double>(band) + 0.5) / bands});
  };
  for (const Mark& mark : points_) {
    const double age = (now - mark.time) / kSpan;
    if (age > 1.0) continue;
    const int itsBand = std::clamp(static_cast<int>(age * bands), 0, bands - 1);
    const QPointF at = view.toPixel(mark.place);
    if (mark.begins) {
      finish();
    } else if (itsBand != band) {
      line.add(at);  // the older piece reaches up to the younger one
      finish();
    }
    band = itsBand;
    line.add(at);
  }
  finish();
  return pieces;
}

std::vector<QPolygonF> Trail::since(const View& view, Seconds time) const {
  auto first = points_.end();
  while (first != points_.begin() && (first == points_.end() || first->time > time)) --first;
  std::vector<QPolygonF> lines;
  for (; first != points_.end(); ++first) {
    if (first->begins || lines.empty()) lines.emplace_back();
    lines.back() << view.toPixel(first->place);
  }
  std::erase_if(lines, [](const QPolygonF& line) { return line.size() < 2; });
  return lines;
}

}  // namespace tessera::ui
