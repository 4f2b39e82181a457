#include "ui/canvas/vehicle_sprites.h"

#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr double kLargest = 64.0;    // pixels of a vehicle that is kept as a picture
constexpr double kHeadings = 180.0;  // pictures round the circle: two degrees are less than a pixel at that size
constexpr double kRoom = 26.0;       // around the body: badge, chosen one's rim
constexpr int kFlashAges = 8;
constexpr qsizetype kMostPictures = 4000;
constexpr quint64 kFlashKey = quint64{1} << 62U;

QPixmap emptyPixmap(QSizeF size, double ratio) {
  QPixmap pixmap{(size * ratio).toSize()};
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  return pixmap;
}

// On whole device pixels: nothing is interpolated.
void put(QPainter& painter, const View& view, QPointF corner, const QPixmap& pixmap) {
  const double ratio = view.devicePixelRatio();
  painter.drawPixmap(QPointF{std::round(corner.x() * ratio) / ratio, std::round(corner.y() * ratio) / ratio}, pixmap);
}

}  // namespace

void VehicleSprites::clear() {
  bodies_.clear();
  labels_.clear();
}

void VehicleSprites::useScale(const View& view) {
  if (view.scale() == scale_ && view.devicePixelRatio() == ratio_) return;
  if (view.devicePixelRatio() != ratio_) labels_.clear();
  bodies_.clear();
  scale_ = view.scale();
  ratio_ = view.devicePixelRatio();
}

template <class Draw>
const QPixmap& VehicleSprites::made(quint64 key, QSizeF size, double ratio, Draw draw) {
  auto found = bodies_.find(key);
  if (found == bodies_.end()) {
    if (bodies_.size() > kMostPictures) bodies_.clear();
    QPixmap pixmap = emptyPixmap(size, ratio);
    QPainter painter{&pixmap};
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
    painter.end();
    found = bodies_.insert(key, pixmap);
  }
  return *found;
}

void VehicleSprites::paintBody(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark) {
  useScale(view);
  const QRectF box = footprintOf(mark, view, mark.pose).boundingRect();
  if (std::max(box.width(), box.height()) > kLargest || !std::isfinite(mark.pose.heading.value()))
    return paintVehicle(painter, view, theme, mark);
  const double step = 2 * kPi / kHeadings;
  const double turn = std::round(wrapped(mark.pose.heading).value() / step);
  const auto key = static_cast<quint64>(mark.vehicle->id.value) | static_cast<quint64>(mark.look) << 8U |
                   static_cast<quint64>(mark.chosen) << 16U | static_cast<quint64>(turn + kHeadings) << 20U |
                   static_cast<quint64>(mark.colour.rgb() & 0xFFFFFFU) << 32U;
  // As far as the body can reach when it turns about its place.
  const QPointF at = view.toPixel(mark.pose.position);
  double reach = 0.0;
  for (const QPointF& p : footprintOf(mark, view, mark.pose))
    reach = std::max(reach, std::hypot(p.x() - at.x(), p.y() - at.y()));
  const double half = std::ceil(reach + kRoom);
  const QPixmap& picture = made(key, {2 * half, 2 * half}, view.devicePixelRatio(), [&](QPainter& to) {
    View stage{{2 * half, 2 * half}, view.devicePixelRatio()};
    stage.setScale(view.scale());
    stage.centreOn({});
    VehicleMark posed = mark;
    posed.pose = {{}, Radians{turn * step}};
    paintVehicle(to, stage, theme, posed);
  });
  const double side = picture.width() / picture.devicePixelRatio();
  put(painter, view, at - QPointF{side / 2, side / 2}, picture);
}

void VehicleSprites::paintLabel(QPainter& painter, const View& view, const CanvasTheme& theme,
                                const VehicleMark& mark) {
  useScale(view);
  const QString text = labelOf(mark);
  const QString key =
      QStringLiteral("%1 %2 %3 ").arg(mark.colour.rgb()).arg(mark.chosen).arg(static_cast<int>(mark.look)) + text;
  auto found = labels_.find(key);
  if (found == labels_.end()) {
    if (labels_.size() > kMostPictures) labels_.clear();
    QPixmap pixmap = emptyPixmap(labelSize(text, painter.font()), view.devicePixelRatio());
    QPainter to{&pixmap};
    to.setRenderHint(QPainter::Antialiasing);
    to.setFont(painter.font());
    paintVehicleLabel(to, theme, mark);
    to.end();
    found = labels_.insert(key, pixmap);
  }
  const QRectF box = footprintOf(mark, view, mark.pose).boundingRect();
  put(painter, view, {box.center().x() - found->width() / found->devicePixelRatio() / 2, box.bottom() + 4}, *found);
}

void VehicleSprites::paintFlash(QPainter& painter, const View& view, Point place, QColor colour, double age) {
  useScale(view);
  const int step = std::clamp(static_cast<int>(age * kFlashAges), 0, kFlashAges - 1);
  const quint64 key = kFlashKey | static_cast<quint64>(step) << 32U | (colour.rgb() & 0xFFFFFFU);
  const QPixmap& picture = made(key, {32, 32}, view.devicePixelRatio(), [&](QPainter& to) {
    ui::paintFlash(to, {16, 16}, colour, (step + 0.5) / kFlashAges);
  });
  put(painter, view, view.toPixel(place) - QPointF{16, 16}, picture);
}

}  // namespace tessera::ui
