#include "ui/canvas/ground_layer.h"

#include <QElapsedTimer>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "ui/canvas/vehicle_painter.h"

namespace tessera::ui {
namespace {

constexpr double kMargin = 128.0;     // logical pixels; whole device pixels at every usual ratio
constexpr int kStripPixels = 60'000;  // of the floor in one go: at most some two milliseconds of drawing

QPoint onDevicePixels(QPointF logical, double ratio) {
  return {static_cast<int>(std::lround(logical.x() * ratio)), static_cast<int>(std::lround(logical.y() * ratio))};
}

QRectF logicalOf(const QRect& device, double ratio) {
  return {device.left() / ratio, device.top() / ratio, device.width() / ratio, device.height() / ratio};
}

// Moves the picture's content; what comes in from outside is left as it was, to be drawn over.
void scroll(QImage& image, QPoint by) {
  const int width = image.width() - std::abs(by.x());
  const int height = image.height() - std::abs(by.y());
  const int fromX = std::max(0, -by.x());
  const int toX = std::max(0, by.x());
  const auto bytes = static_cast<std::size_t>(width) * 4;
  for (int n = 0; n < height; ++n) {
    const int row = by.y() > 0 ? height - 1 - n : n - std::min(0, by.y());
    std::memmove(image.scanLine(row + by.y()) + 4 * toX, image.constScanLine(row) + 4 * fromX, bytes);
  }
}

// How far the second view shows what the first one does, moved.
QPointF between(const View& from, const View& to) { return to.toPixel({}) - from.toPixel({}); }

bool sameScale(const View& a, const View& b) {
  return a.size() == b.size() && a.devicePixelRatio() == b.devicePixelRatio() && a.scale() == b.scale();
}

bool coversWindow(const View& picture, const View& window) {
  const QPointF origin = between(window, picture);
  return std::abs(origin.x() - kMargin) <= kMargin && std::abs(origin.y() - kMargin) <= kMargin;
}

}  // namespace

void GroundLayer::clear() {
  shown_.reset();
  job_.reset();
}

bool GroundLayer::wantsJob() const {
  return !shown_ || shown_->floorVersion != floorVersion_ || shown_->trailVersion != trailVersion_ ||
         !sameScale(shown_->view, wanted_) || !coversWindow(shown_->view, window_);
}

void GroundLayer::prepare(const Ground& ground) {
  window_ = ground.view;
  wanted_ = ground.view;
  wanted_.resize(ground.view.size() + QSizeF{2 * kMargin, 2 * kMargin}, ground.view.devicePixelRatio());
  if (!shown_) {
    job_.reset();
    work(ground, kForever);
    return;
  }
  if (sameScale(shown_->view, wanted_) && !coversWindow(shown_->view, window_)) {
    const QPoint by = onDevicePixels(between(shown_->view, wanted_), wanted_.devicePixelRatio());
    if (std::abs(by.x()) < shown_->floor.width() / 2 && std::abs(by.y()) < shown_->floor.height() / 2)
      shift(by, ground);
  }
  lengthenTrails(*shown_, ground);
}

void GroundLayer::begin(const Ground& ground) {
  Job job{{}, ground.floor, ground.theme, 0, {}, 0};
  Picture& picture = job.picture;
  picture.view = wanted_;
  picture.floorVersion = floorVersion_;
  picture.trailVersion = trailVersion_;
  for (const TrailMark& mark : ground.trails) job.trails.push_back(mark.vehicle);
  if (shown_ && shown_->floorVersion == floorVersion_ && sameScale(shown_->view, wanted_) &&
      coversWindow(shown_->view, window_)) {
    picture.view = shown_->view;
    picture.floor = shown_->floor;  // the trails alone are to be drawn
    picture.whole = picture.floor;
    job.rows = picture.floor.height();
  } else {
    const double ratio = wanted_.devicePixelRatio();
    picture.floor = QImage{static_cast<int>(std::ceil(wanted_.size().width() * ratio)),
                           static_cast<int>(std::ceil(wanted_.size().height() * ratio)), QImage::Format_RGB32};
    picture.floor.setDevicePixelRatio(ratio);
    ++redraws_;
  }
  job_ = std::move(job);
}

// One slice. True: there is nothing more to do.
bool GroundLayer::advance(const Ground& ground) {
  Picture& picture = job_->picture;
  if (const int height = picture.floor.height(); job_->rows < height) {
    const int rows = std::clamp(kStripPixels / std::max(1, picture.floor.width()), 1, height - job_->rows);
    paintFloor(picture.floor, picture.view, job_->scene, job_->theme, {0, job_->rows, picture.floor.width(), rows});
    job_->rows += rows;
    if (job_->rows == height) picture.whole = picture.floor;
    return false;
  }
  if (job_->trailsDrawn == job_->trails.size()) return true;
  const VehicleId vehicle = job_->trails[job_->trailsDrawn++];
  const auto mark = std::find_if(ground.trails.begin(), ground.trails.end(),
                                 [vehicle](const TrailMark& m) { return m.vehicle == vehicle; });
  if (mark == ground.trails.end() || mark->trail->size() == 0) return false;
  QPainter painter{&picture.whole};
  painter.setRenderHint(QPainter::Antialiasing);
  paintTrail(painter, picture.view, *mark->trail, ground.now, mark->colour, job_->theme.tile,
             QRectF{QPointF{}, picture.view.size()});
  picture.trailsUpTo[vehicle] = mark->trail->last();
  return false;
}

bool GroundLayer::work(const Ground& ground, std::chrono::milliseconds patience) {
  if (!job_) {
    if (!wantsJob()) return false;
    begin(ground);
  }
  QElapsedTimer clock;
  clock.start();
  while (!advance(ground)) {
    if (clock.elapsed() >= patience.count()) return false;
  }
  shown_ = std::move(job_->picture);
  job_.reset();
  lengthenTrails(*shown_, ground);
  return true;
}

// A trail that the picture does not have yet is drawn whole, the others from where they ended.
void GroundLayer::lengthenTrails(Picture& picture, const Ground& ground) {
  QPainter painter;
  for (const TrailMark& mark : ground.trails) {
    if (mark.trail->size() == 0) continue;
    const auto known = picture.trailsUpTo.find(mark.vehicle);
    if (known != picture.trailsUpTo.end() && known->second >= mark.trail->last()) continue;
    if (!painter.isActive()) {
      painter.begin(&picture.whole);
      painter.setRenderHint(QPainter::Antialiasing);
    }
    if (known == picture.trailsUpTo.end()) {
      paintTrail(painter, picture.view, *mark.trail, ground.now, mark.colour, ground.theme.tile,
                 QRectF{QPointF{}, picture.view.size()});
    } else {
      paintTrailEnd(painter, picture.view, *mark.trail, known->second, mark.colour, ground.theme.tile);
    }
    picture.trailsUpTo[mark.vehicle] = mark.trail->last();
  }
}

void GroundLayer::shift(QPoint by, const Ground& ground) {
  Picture& picture = *shown_;
  // Without trails both are one image in memory; writing to one of two would copy it.
  const bool bare = picture.trailsUpTo.empty();
  if (bare) picture.whole = QImage{};
  picture.view = wanted_;
  scroll(picture.floor, by);
  if (!bare) scroll(picture.whole, by);
  const int width = picture.floor.width();
  const int height = picture.floor.height();
  const std::array<QRect, 2> strips{QRect{by.x() > 0 ? 0 : width + by.x(), 0, std::abs(by.x()), height},
                                    QRect{0, by.y() > 0 ? 0 : height + by.y(), width, std::abs(by.y())}};
  for (const QRect& strip : strips) {
    if (strip.isEmpty()) continue;
    paintFloor(picture.floor, picture.view, ground.floor, ground.theme, strip);
    if (!bare) drawTrails(picture, strip, ground);
  }
  if (bare) picture.whole = picture.floor;
}

void GroundLayer::drawTrails(Picture& picture, const QRect& strip, const Ground& ground) {
  const QRectF logical = logicalOf(strip, picture.view.devicePixelRatio());
  QPainter painter{&picture.whole};
  painter.setClipRect(logical);
  painter.drawImage(logical.topLeft(), picture.floor, QRectF{strip});
  painter.setRenderHint(QPainter::Antialiasing);
  for (const TrailMark& mark : ground.trails)
    paintTrail(painter, picture.view, *mark.trail, ground.now, mark.colour, ground.theme.tile, logical);
}

void GroundLayer::blit(QPainter& painter, const QRect& rect, QColor outside) const {
  if (!shown_) return;
  const double ratio = window_.devicePixelRatio();
  if (sameScale(shown_->view, wanted_) && coversWindow(shown_->view, window_)) {
    const QPoint corner = onDevicePixels(between(window_, shown_->view), ratio);
    // Whole device pixels around the rectangle, so that fractional ratios do not blur.
    const QRectF source{std::floor(rect.left() * ratio) + corner.x(), std::floor(rect.top() * ratio) + corner.y(),
                        std::ceil(rect.width() * ratio) + 1, std::ceil(rect.height() * ratio) + 1};
    const QPointF at{std::floor(rect.left() * ratio) / ratio, std::floor(rect.top() * ratio) / ratio};
    painter.drawImage(at, shown_->whole, source);
    return;
  }
  // A picture of another scale stands in. Only what is seen of it is handed over: scaling costs by the pixel.
  painter.fillRect(rect, outside);
  const View& from = shown_->view;
  const double device = from.devicePixelRatio();
  const QRectF seen =
      QRectF{from.toPixel(window_.toSite(rect.topLeft())),
             from.toPixel(window_.toSite(QPointF{rect.topLeft()} + QPointF(rect.width(), rect.height())))} &
      QRectF{QPointF{}, from.size()};
  if (seen.isEmpty()) return;
  const QRectF to{window_.toPixel(from.toSite(seen.topLeft())), window_.toPixel(from.toSite(seen.bottomRight()))};
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.drawImage(to, shown_->whole, QRectF{seen.topLeft() * device, seen.size() * device});
}

}  // namespace tessera::ui
