#include "ui/canvas/vehicle_sprites.h"

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr double kLargest = 128.0;   // pixels of a vehicle that is kept as a picture
constexpr double kHeadings = 180.0;  // pictures round the circle: two degrees are some pixel at that size
constexpr double kRoom = 26.0;       // around the body: badge, chosen one's rim
constexpr double kSmallDoubt = 40.0;
constexpr int kFlashAges = 8;
constexpr qsizetype kMostBytes = 128 << 20;
constexpr qsizetype kMostLabels = 1000;
constexpr qint64 kMaking = 3'000'000;  // nanoseconds for new pictures in one painting

QPixmap emptyPixmap(QSizeF size, double ratio) {
  QPixmap pixmap{(size * ratio).toSize()};
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  return pixmap;
}

// The middle of the picture at that place, on whole device pixels: nothing is interpolated.
void put(QPainter& painter, QPointF middle, const QPixmap& pixmap) {
  const double ratio = pixmap.devicePixelRatio();
  const QPointF corner = middle - QPointF{pixmap.width() / ratio / 2, pixmap.height() / ratio / 2};
  painter.drawPixmap(QPointF{std::round(corner.x() * ratio) / ratio, std::round(corner.y() * ratio) / ratio}, pixmap);
}

void put(QPainter& painter, QPointF middle, const QPixmap& pixmap, double factor) {
  if (factor == 1.0) return put(painter, middle, pixmap);
  const QSizeF size = QSizeF{pixmap.size()} / pixmap.devicePixelRatio() * factor;
  painter.drawPixmap(QRectF{middle - QPointF{size.width() / 2, size.height() / 2}, size}, pixmap,
                     QRectF{QPointF{}, QSizeF{pixmap.size()}});
}

}  // namespace

void VehicleSprites::clear() {
  pictures_.clear();
  bytes_ = 0;
  labels_.clear();
  shapes_.clear();
}

void VehicleSprites::begin(const View& view, bool all) {
  if (view.devicePixelRatio() != ratio_) {
    labels_.clear();
    pictures_.clear();
    bytes_ = 0;
  }
  scale_ = view.scale();
  ratio_ = view.devicePixelRatio();
  all_ = all;
  pending_ = false;
  made_ = 0;
}

quint64 VehicleSprites::shapeOf(const VehicleMark& mark) {
  static const std::vector<Point> kUnknown;
  const std::vector<Point>& outline = mark.setup != nullptr ? mark.setup->footprint : kUnknown;
  const auto found = std::find(shapes_.begin(), shapes_.end(), outline);
  const auto index = static_cast<quint64>(found - shapes_.begin());
  if (found == shapes_.end()) shapes_.push_back(outline);
  return index;
}

template <class Draw>
const VehicleSprites::Picture* VehicleSprites::made(quint64 key, bool needed, QSizeF size, Draw draw) {
  const auto found = pictures_.find(key);
  if (found != pictures_.end() && found->scale == scale_) return &*found;
  const bool late = !all_ && made_ >= kMaking;
  if (late && (found != pictures_.end() || !needed)) {
    pending_ = true;
    return found != pictures_.end() ? &*found : nullptr;
  }
  if (bytes_ > kMostBytes) {
    pictures_.clear();
    bytes_ = 0;
  }
  QElapsedTimer clock;
  clock.start();
  QPixmap pixmap = emptyPixmap(size, ratio_);
  QPainter painter{&pixmap};
  painter.setRenderHint(QPainter::Antialiasing);
  draw(painter);
  painter.end();
  const auto bytesOf = [](const QPixmap& p) { return qsizetype{4} * p.width() * p.height(); };
  bytes_ += bytesOf(pixmap) - (pictures_.contains(key) ? bytesOf(pictures_.value(key).pixmap) : 0);
  made_ += clock.nsecsElapsed();
  return &*pictures_.insert(key, {pixmap, scale_});
}

// False: it is too large, or its heading is no number.
template <class Draw>
bool VehicleSprites::paintTurned(QPainter& painter, const View& view, Kind kind, const VehicleMark& mark,
                                 const Pose& pose, Draw draw) {
  const QPolygonF outline = footprintOf(mark, view, pose);
  const QRectF box = outline.boundingRect();
  const quint64 shape = shapeOf(mark);
  if (std::max(box.width(), box.height()) > kLargest || !std::isfinite(pose.heading.value()) || shape > 0xFFU)
    return false;
  const double step = 2 * kPi / kHeadings;
  const double turn = std::round(wrapped(pose.heading).value() / step);
  const quint64 key = shape | static_cast<quint64>(mark.look) << 8U | static_cast<quint64>(mark.chosen) << 16U |
                      static_cast<quint64>(turn + kHeadings) << 20U |
                      static_cast<quint64>(mark.colour.rgb() & 0xFFFFFFU) << 32U | static_cast<quint64>(kind) << 60U;
  // As far as the body can reach when it turns about its place.
  const QPointF at = view.toPixel(pose.position);
  double reach = 0.0;
  for (const QPointF& p : outline) reach = std::max(reach, std::hypot(p.x() - at.x(), p.y() - at.y()));
  const double half = std::ceil(reach + kRoom);
  const Picture* picture = made(key, kind == Kind::Body, {2 * half, 2 * half}, [&](QPainter& to) {
    View stage{{2 * half, 2 * half}, view.devicePixelRatio()};
    stage.setScale(view.scale());
    stage.centreOn({});
    draw(to, stage, Pose{{}, Radians{turn * step}});
  });
  if (picture != nullptr) put(painter, at, picture->pixmap, scale_ / picture->scale);
  return true;
}

void VehicleSprites::paintBody(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark) {
  const auto draw = [&](QPainter& to, const View& stage, const Pose& pose) {
    VehicleMark posed = mark;
    posed.pose = pose;
    paintVehicle(to, stage, theme, posed);
  };
  if (!paintTurned(painter, view, Kind::Body, mark, mark.pose, draw)) draw(painter, view, mark.pose);
}

void VehicleSprites::paintGhost(QPainter& painter, const View& view, const CanvasTheme& theme,
                                const VehicleMark& mark) {
  if (!hasGhost(view, mark)) return;
  const auto draw = [&](QPainter& to, const View& stage, const Pose& pose) {
    ui::paintGhost(to, stage, theme, mark, pose);
  };
  const Pose& predicted = mark.vehicle->predicted;
  if (!paintTurned(painter, view, Kind::Ghost, mark, predicted, draw)) draw(painter, view, predicted);
}

void VehicleSprites::paintDoubt(QPainter& painter, const View& view, const CanvasTheme& theme,
                                const VehicleMark& mark) {
  Ellipse95 ellipse = ellipseOf(mark.vehicle->covariance, view.scale());
  if (!isDrawn(ellipse)) return;
  const QPointF at = view.toPixel(mark.pose.position);
  const QColor colour = bodyColour(mark, theme);
  if (ellipse.longAxis > kSmallDoubt) {
    painter.save();
    painter.translate(at);
    ui::paintDoubt(painter, theme, ellipse, colour);
    painter.restore();
    return;
  }
  // To a quarter pixel and four degrees: nobody sees the difference, and pictures are found again.
  ellipse.longAxis = std::round(ellipse.longAxis * 4) / 4;
  ellipse.shortAxis = std::round(ellipse.shortAxis * 4) / 4;
  ellipse.degrees = std::round(ellipse.degrees / 4) * 4;
  const quint64 key = static_cast<quint64>(Kind::Doubt) << 60U | static_cast<quint64>(colour.rgb() & 0xFFFFFFU) << 32U |
                      static_cast<quint64>(ellipse.longAxis * 4) << 20U |
                      static_cast<quint64>(ellipse.shortAxis * 4) << 8U |
                      static_cast<quint64>(ellipse.degrees / 4 + 50);
  const double half = std::ceil(ellipse.longAxis + 4);
  const Picture* picture = made(key, false, {2 * half, 2 * half}, [&](QPainter& to) {
    to.translate(half, half);
    ui::paintDoubt(to, theme, ellipse, colour);
  });
  if (picture != nullptr) put(painter, at, picture->pixmap);
}

void VehicleSprites::paintLabel(QPainter& painter, const View& view, const CanvasTheme& theme,
                                const VehicleMark& mark) {
  const QString text = labelOf(mark);
  const QString key =
      QStringLiteral("%1 %2 %3 ").arg(mark.colour.rgb()).arg(mark.chosen).arg(static_cast<int>(mark.look)) + text;
  auto found = labels_.find(key);
  if (found == labels_.end()) {
    if (labels_.size() > kMostLabels) labels_.clear();
    QPixmap pixmap = emptyPixmap(labelSize(text, painter.font()), view.devicePixelRatio());
    QPainter to{&pixmap};
    to.setRenderHint(QPainter::Antialiasing);
    to.setFont(painter.font());
    paintVehicleLabel(to, theme, mark);
    to.end();
    found = labels_.insert(key, pixmap);
  }
  const QRectF box = footprintOf(mark, view, mark.pose).boundingRect();
  put(painter, {box.center().x(), box.bottom() + 4 + found->height() / found->devicePixelRatio() / 2}, *found);
}

void VehicleSprites::paintFlash(QPainter& painter, const View& view, Point place, QColor colour, double age) {
  const int step = std::clamp(static_cast<int>(age * kFlashAges), 0, kFlashAges - 1);
  const quint64 key = static_cast<quint64>(Kind::Flash) << 60U | static_cast<quint64>(step) << 32U |
                      static_cast<quint64>(colour.rgb() & 0xFFFFFFU);
  const Picture* picture = made(key, false, {32, 32}, [&](QPainter& to) {
    ui::paintFlash(to, {16, 16}, colour, (step + 0.5) / kFlashAges);
  });
  if (picture != nullptr) put(painter, view.toPixel(place), picture->pixmap);
}

}  // namespace tessera::ui
