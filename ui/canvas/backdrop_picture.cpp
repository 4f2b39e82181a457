#include "ui/canvas/backdrop_picture.h"

#include <QBuffer>
#include <QImageReader>
#include <QTransform>
#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr int kSmallestLevel = 64;
constexpr double kSharpFrom = 4.0;  // magnified so much, pixels are shown as what they are

}  // namespace

std::shared_ptr<const BackdropPicture> BackdropPicture::of(const std::shared_ptr<const std::string>& bytes) {
  // Canvas and panel ask for the same one; nobody asks for two in turn.
  thread_local std::weak_ptr<const std::string> knownBytes;
  thread_local std::weak_ptr<const BackdropPicture> known;
  if (auto picture = known.lock(); picture && bytes && knownBytes.lock() == bytes) return picture;
  static const std::string none;
  auto picture = std::make_shared<const BackdropPicture>(bytes ? *bytes : none);
  knownBytes = bytes;
  known = picture;
  return picture;
}

BackdropPicture::BackdropPicture(const std::string& bytes) {
  QByteArray raw = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
  QBuffer buffer{&raw};
  buffer.open(QIODevice::ReadOnly);
  QImageReader reader{&buffer};
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (qint64{size.width()} * size.height() > qint64{kMostMegapixels} * 1'000'000) {
    fault_ = phrase("Core", "The picture has %1 × %2 pixels. Save it smaller: up to %3 million pixels can be shown.")
                 .with(size.width(), size.height(), kMostMegapixels);
    return;
  }
  QImage whole = reader.read();
  if (whole.isNull()) {
    fault_ = phrase("Core", "The picture is damaged or of a kind that cannot be shown.");
    return;
  }
  whole.setDevicePixelRatio(1.0);
  whole.convertTo(whole.hasAlphaChannel() ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
  levels_.push_back(std::move(whole));
  while (std::min(levels_.back().width(), levels_.back().height()) > kSmallestLevel) {
    const QSize half{(levels_.back().width() + 1) / 2, (levels_.back().height() + 1) / 2};
    levels_.push_back(levels_.back().scaled(half, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }
}

const QImage& BackdropPicture::level(double scale) const {
  std::size_t n = 0;
  while (n + 1 < levels_.size() && scale <= 0.5) {
    scale *= 2.0;
    ++n;
  }
  return levels_[n];
}

std::array<Point, 4> cornersOf(const floor::Backdrop& place, QSize pixels) {
  const Metres width = pixels.width() * place.pixel;
  const Metres height = pixels.height() * place.pixel;
  const auto corner = [&](Metres x, Metres y) { return place.origin + turned(Offset{x, y}, place.turn); };
  return {place.origin, corner(width, Metres{}), corner(width, height), corner(Metres{}, height)};
}

void paintBackdrop(QPainter& painter, const View& view, const floor::Backdrop& place, const BackdropPicture& picture,
                   const QRectF& seen) {
  if (picture.fault()) return;
  const double scale = view.pixels(place.pixel);
  const QPointF corner = view.toPixel(place.origin);
  QTransform onFloor;
  onFloor.translate(corner.x(), corner.y());
  onFloor.rotate(-degrees(place.turn));
  onFloor.scale(scale, scale);
  const QSizeF whole = picture.size();
  onFloor.translate(0.0, -whole.height());
  const QImage& level = picture.level(scale * view.devicePixelRatio());
  onFloor.scale(whole.width() / level.width(), whole.height() / level.height());
  // Only what is seen is handed over, with some pixels around it for smoothing.
  const QRectF wanted = onFloor.inverted().mapRect(seen).adjusted(-3, -3, 3, 3);
  const QRect part = wanted.toAlignedRect() & level.rect();
  if (part.isEmpty()) return;
  painter.save();
  painter.setTransform(onFloor, true);
  painter.setOpacity(place.opacity);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, scale * view.devicePixelRatio() < kSharpFrom);
  painter.drawImage(QRectF{part}, level, QRectF{part});
  painter.restore();
}

}  // namespace tessera::ui
