// What the lay tool shows: tiles about to be laid, the chosen ones, and the gesture's numbers.
#include <QLocale>
#include <algorithm>
#include <limits>

#include "floor/laid_tile.h"
#include "ui/canvas/furniture.h"
#include "ui/lay/lay_tool.h"

namespace tessera::ui {
namespace {

constexpr double kTooSmall = 3.0;          // pixels of a tile that is no longer drawn on its own
constexpr double kOutlinedFrom = 14.0;     // pixels of a tile that is marked by an outline
constexpr double kDotsFrom = 7.0;          // pixels from place to place
constexpr std::size_t kMostDots = 20'000;  // of a preview, all tiles together

QRectF pixelBox(const View& view, const Box& box) {
  return QRectF{view.toPixel({box.low.x, box.high.y}), view.toPixel({box.high.x, box.low.y})};
}

QColor faint(QColor colour, int alpha) {
  colour.setAlpha(alpha);
  return colour;
}

// Tiles that are not laid yet, as they will look.
class GhostPainter {
public:
  GhostPainter(QPainter& painter, const View& view, const CanvasTheme& theme)
      : painter_{painter}, view_{view}, theme_{theme} {
    seen_ = QRectF{QPointF{}, view.size()}.adjusted(-10, -10, 10, 10);
  }

  void add(const floor::TileType& type, const Box& box, int turns, bool free) {
    const QRectF pixels = pixelBox(view_, box);
    if (!pixels.intersects(seen_)) return;
    if (std::min(pixels.width(), pixels.height()) < kTooSmall) {
      (free ? small_ : smallTaken_) |= pixels;
      return;
    }
    const QColor colour = free ? theme_.accent : theme_.fault;
    if (std::min(pixels.width(), pixels.height()) < kOutlinedFrom) {
      painter_.setRenderHint(QPainter::Antialiasing, false);
      painter_.fillRect(pixels, faint(colour, 110));
      painter_.setRenderHint(QPainter::Antialiasing);
      return;
    }
    painter_.setPen(QPen{colour, 1.5});
    painter_.setBrush(faint(colour, 60));
    painter_.drawRect(pixels);
    if (view_.pixels(type.pitch) < kDotsFrom || dots_ > kMostDots) return;
    const Point origin = floor::originFor(box.low, type, turns);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(free ? theme_.tag : theme_.fault);
    const double radius = std::clamp(view_.pixels(type.pitch) * 0.12, 1.5, 5.0);
    for (const Offset& place : floor::tagOffsets(type)) {
      painter_.drawEllipse(view_.toPixel(origin + floor::quarterTurned(place, turns)), radius, radius);
      ++dots_;
    }
  }
  // From afar the tiles are one area.
  void finish() {
    for (const bool free : {true, false}) {
      const QRectF& area = free ? small_ : smallTaken_;
      if (area.isNull()) continue;
      const QColor colour = free ? theme_.accent : theme_.fault;
      painter_.setPen(QPen{colour, 1.5});
      painter_.setBrush(faint(colour, 60));
      painter_.drawRect(area);
    }
  }

private:
  QPainter& painter_;
  const View& view_;
  const CanvasTheme& theme_;
  QRectF seen_;
  QRectF small_;
  QRectF smallTaken_;
  std::size_t dots_ = 0;
};

// Laid tiles that are meant: an outline each, and from afar no more than a colour, which ten thousands of them can have
// in every frame.
class TileMarks {
public:
  TileMarks(QPainter& painter, const View& view, QColor colour, int alpha)
      : painter_{painter}, view_{view}, colour_{colour}, fill_{faint(colour, alpha)} {
    seen_ = QRectF{QPointF{}, view.size()}.adjusted(-10, -10, 10, 10);
    painter_.setRenderHint(QPainter::Antialiasing, false);
  }
  ~TileMarks() {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setPen(QPen{colour_, 2.0});
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRects(outlined_);
  }
  TileMarks(const TileMarks&) = delete;
  TileMarks& operator=(const TileMarks&) = delete;

  void add(const Box& box) {
    const QRectF pixels = pixelBox(view_, box);
    if (!pixels.intersects(seen_)) return;
    painter_.fillRect(pixels, fill_);
    if (std::min(pixels.width(), pixels.height()) >= kOutlinedFrom) outlined_.push_back(pixels.adjusted(1, 1, -1, -1));
  }

private:
  QPainter& painter_;
  const View& view_;
  QColor colour_;
  QColor fill_;
  QRectF seen_;
  QVector<QRectF> outlined_;
};

QString cornerText(Point p) {
  const QLocale locale;
  return LayTool::tr("x %1 cm, y %2 cm")
      .arg(locale.toString(p.x.value() * 100.0, 'f', 1), locale.toString(p.y.value() * 100.0, 'f', 1));
}

}  // namespace

void LayTool::paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (!std::holds_alternative<LayDrag>(gesture_)) paintChosen(painter, scene, theme);
  paintGesture(painter, scene, theme);
}

void LayTool::paintChosen(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  if (chosen_.empty()) return;
  TileMarks marks{painter, scene.view, theme.accent, 45};
  if (!chosenBoxes_) {
    chosenBoxes_.emplace();
    for (const FloorIndex::Tile& tile : scene.floor.tiles())
      if (chosen_.contains(scene.floor.serial(tile))) chosenBoxes_->push_back(boxOf(tile.box));
  }
  for (const Box& box : *chosenBoxes_) marks.add(box);
}

void LayTool::paintGesture(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) const {
  GhostPainter ghosts{painter, scene.view, theme};
  const floor::TileType* type = edits_.type(brush_);
  QString says;
  Point at;
  if (const auto* stroke = std::get_if<LayStroke>(&gesture_); stroke != nullptr && type != nullptr) {
    for (const Box& box : stroke->boxes()) ghosts.add(*type, box, brushTurns_, true);
    says = tr("%n tile(s)", nullptr, static_cast<int>(stroke->boxes().size()));
    at = mouse_.place;
  } else if (const auto* fill = std::get_if<LayFill>(&gesture_); fill != nullptr && type != nullptr) {
    const SiteBox seen = scene.view.visible(10.0);
    const bool small = scene.view.pixels(std::min(fill->lattice.size.x, fill->lattice.size.y)) < kTooSmall;
    if (small || fill->tooMany()) {
      ghosts.add(*type, fill->box(), 0, !fill->tooMany());
    } else {
      for (const Box& box : fill->freeBoxes(scene.floor, boxOf(seen))) ghosts.add(*type, box, brushTurns_, true);
    }
    says = tr("%1 × %2 tiles").arg(fill->columns()).arg(fill->rows());
    at = mouse_.place;
  } else if (const auto* drag = std::get_if<LayDrag>(&gesture_); drag != nullptr) {
    TileMarks marks{painter, scene.view, drag->free ? theme.accent : theme.fault, 60};
    for (const Box& box : drag->boxes) marks.add({box.low + drag->by, box.high + drag->by});
    if (drag->moved) says = cornerText(drag->grabbedBox.low + drag->by);
    at = mouse_.place;
  } else if (const auto* band = std::get_if<LayBand>(&gesture_); band != nullptr) {
    painter.setPen(QPen{theme.accent, 1.5, Qt::DashLine});
    painter.setBrush(faint(theme.accent, 30));
    painter.drawRect(QRectF{band->from, band->to}.normalized());
  } else if (stamp_ && ghost_) {
    for (const NewTile& tile : stamp_->tiles)
      ghosts.add(stamp_->typeOf(tile), stamp_->boxOf(tile, *ghost_), tile.quarterTurns, ghostFree_);
    says = cornerText(*ghost_);
    at = mouse_.place;
  } else if (ghost_ && ghostFree_ && type != nullptr) {
    ghosts.add(*type, boxOf(*ghost_, *brushSize()), brushTurns_, true);
    says = cornerText(*ghost_);
    at = mouse_.place;
  }
  ghosts.finish();
  if (says.isEmpty()) return;
  paintHaloText(painter, scene.view.toPixel(at) + QPointF{16, 28}, says, theme.text, theme.halo);
}

}  // namespace tessera::ui
