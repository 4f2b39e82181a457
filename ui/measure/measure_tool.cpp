#include "ui/measure/measure_tool.h"

#include <QLocale>
#include <cmath>

#include "ui/canvas/furniture.h"
#include "ui/canvas/readout.h"

namespace tessera::ui {
namespace {

constexpr double kDragFrom = 6.0;
constexpr double kTextFrom = 46.0;

Metres lengthOf(const std::vector<Point>& way) {
  Metres sum{};
  for (std::size_t n = 1; n < way.size(); ++n) sum = sum + distance(way[n - 1], way[n]);
  return sum;
}

// The shoelace formula.
double areaOf(const std::vector<Point>& way) {
  double twice = 0.0;
  for (std::size_t n = 0; n < way.size(); ++n) {
    const Point a = way[n];
    const Point b = way[(n + 1) % way.size()];
    twice += a.x.value() * b.y.value() - b.x.value() * a.y.value();
  }
  return std::abs(twice) / 2.0;
}

QString metresText(Metres length) {
  return MeasureTool::tr("%1 m", "a length").arg(QLocale().toString(length.value(), 'f', 3));
}

}  // namespace

Metres MeasureTool::length() const { return lengthOf(points_); }
double MeasureTool::area() const { return areaOf(points_); }

Snap MeasureTool::snapAt(const ToolMouse& mouse, const CanvasScene& scene) const {
  SnapWish wish;
  wish.off = mouse.modifiers.testFlag(Qt::AltModifier);
  if (mouse.modifiers.testFlag(Qt::ShiftModifier) && !points_.empty() && !complete_) wish.from = points_.back();
  wish.vertices = points_;
  return snapped(scene, mouse.pixel, wish);
}

bool MeasureTool::mousePressed(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.button == Qt::RightButton && !points_.empty()) {
    complete();
    return true;
  }
  if (mouse.button != Qt::LeftButton) return false;
  pressed_ = mouse.pixel;
  add(snapAt(mouse, scene).place);
  return true;
}

bool MeasureTool::mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.buttons.testFlag(Qt::MiddleButton)) return false;
  pointer_ = snapAt(mouse, scene);
  touch();
  return mouse.buttons.testFlag(Qt::LeftButton);
}

bool MeasureTool::mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.button != Qt::LeftButton || !pressed_) return false;
  const QPointF way = mouse.pixel - *pressed_;
  pressed_.reset();
  if (std::hypot(way.x(), way.y()) < kDragFrom) return true;
  add(snapAt(mouse, scene).place);
  if (points_.size() == 2) complete();
  return true;
}

bool MeasureTool::mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& /*scene*/) {
  if (mouse.button != Qt::LeftButton) return false;
  complete();
  return true;
}

void MeasureTool::add(Point place) {
  if (complete_) points_.clear();
  complete_ = false;
  if (points_.empty() || distance(points_.back(), place) > Metres{1e-6}) points_.push_back(place);
  touch();
}

void MeasureTool::complete() {
  if (points_.size() < 2) points_.clear();
  complete_ = !points_.empty();
  touch();
}

bool MeasureTool::keyPressed(QKeyEvent& event, const CanvasScene& /*scene*/) {
  if (!wantsShortcut(event)) return false;
  if (event.key() == Qt::Key_Backspace) return undo();
  complete();
  return true;
}

bool MeasureTool::keyReleased(QKeyEvent& /*event*/, const CanvasScene& /*scene*/) { return false; }

bool MeasureTool::wantsShortcut(const QKeyEvent& event) const {
  if (points_.empty() || complete_ || event.modifiers() != Qt::NoModifier) return false;
  return event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

void MeasureTool::mouseLeft() {
  pointer_.reset();
  touch();
}

bool MeasureTool::cancel() {
  pressed_.reset();
  if (points_.empty()) return false;
  points_.clear();
  complete_ = false;
  touch();
  return true;
}

bool MeasureTool::undo() {
  if (points_.empty() || complete_) return false;
  points_.pop_back();
  touch();
  return true;
}

void MeasureTool::touch() {
  Q_EMIT changed();
  Q_EMIT hintChanged(hint());
}

QString MeasureTool::hint() const {
  if (points_.empty()) return tr("Measure: click where it begins, or drag from end to end.");
  if (complete_) return tr("Click to measure anew. Esc ends.");
  return tr("Click to go on, double-click or Enter to end. Shift: 45° steps. Alt: without snapping. Backspace: back.");
}

std::vector<Point> MeasureTool::shown() const {
  std::vector<Point> way = points_;
  if (!complete_ && !way.empty() && pointer_) way.push_back(pointer_->place);
  return way;
}

void MeasureTool::paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  const std::vector<Point> way = shown();
  painter.setRenderHint(QPainter::Antialiasing);
  QPolygonF line;
  for (const Point& p : way) line.push_back(scene.view.toPixel(p));
  painter.setBrush(Qt::NoBrush);
  for (const auto& [colour, width] : {std::pair{theme.halo, 4.0}, std::pair{theme.accent, 2.0}}) {
    painter.setPen(QPen{colour, width});
    painter.drawPolyline(line);
  }
  for (const QPointF& at : line) paintHandle(painter, at, 3.5, theme.halo, theme.accent);
  if (pointer_ && !complete_) paintSnap(painter, scene.view, theme, *pointer_);
}

void MeasureTool::paintAbove(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  const std::vector<Point> way = shown();
  if (way.empty()) return;
  for (std::size_t n = 1; n < way.size(); ++n) {
    const QPointF a = scene.view.toPixel(way[n - 1]);
    const QPointF b = scene.view.toPixel(way[n]);
    if (std::hypot(b.x() - a.x(), b.y() - a.y()) < kTextFrom) continue;
    paintHaloText(painter, (a + b) / 2 + QPointF{6, -6}, metresText(distance(way[n - 1], way[n])), theme.text,
                  theme.halo);
  }
  QStringList lines;
  if (way.size() >= 2) {
    const QLocale locale;
    lines << legText(way[way.size() - 2], way.back(), scene.map.site().northToY);
    if (way.size() > 2) {
      lines << tr("together %1").arg(metresText(lengthOf(way)));
      lines << tr("area %1 m²").arg(locale.toString(areaOf(way), 'f', 2));
    }
  }
  lines << placeText(way.back());
  paintReadout(painter, scene.view, theme, scene.view.toPixel(way.back()), lines);
}

}  // namespace tessera::ui
