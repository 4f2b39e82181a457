#include "ui/fleet/tone.h"

#include <QPainter>
#include <QPixmapCache>

#include "ui/base/icon.h"

namespace tessera::ui {
namespace {

template <class Draw>
QIcon keptIcon(const QString& key, int side, qreal pixelRatio, Draw&& draw) {
  QPixmap pixmap;
  if (!QPixmapCache::find(key, &pixmap)) {
    pixmap = QPixmap{QSize{side, side} * pixelRatio};
    pixmap.setDevicePixelRatio(pixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter{&pixmap};
    draw(painter);
    painter.end();
    QPixmapCache::insert(key, pixmap);
  }
  QIcon icon;
  for (const auto mode : {QIcon::Normal, QIcon::Selected, QIcon::Active, QIcon::Disabled}) icon.addPixmap(pixmap, mode);
  return icon;
}

QString keyOf(const QString& name, const QColor& colour, int side, qreal pixelRatio) {
  return QStringLiteral("tessera/%1/%2/%3/%4").arg(name, colour.name()).arg(side).arg(pixelRatio);
}

}  // namespace

QColor toneColour(Tone tone, const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightness() < 128;
  const auto pick = [dark](QRgb light, QRgb night) { return QColor::fromRgb(dark ? night : light); };
  switch (tone) {
    case Tone::Plain:
      break;
    case Tone::Quiet:
      return pick(0x5B6673, 0x9AA5B1);
    case Tone::Good:
      return pick(0x17713F, 0x55C98A);
    case Tone::Busy:
      return pick(0x1F5FBF, 0x7DB1FF);
    case Tone::Warning:
      return pick(0x8F5A00, 0xF2B632);
    case Tone::Bad:
      return pick(0xC62828, 0xFF7B70);
  }
  return palette.color(QPalette::Text);
}

QIcon tintedIcon(const QString& name, const QColor& colour, int side, qreal pixelRatio) {
  return keptIcon(keyOf(name, colour, side, pixelRatio), side, pixelRatio, [&](QPainter& painter) {
    const QRect all{0, 0, side, side};
    icon(name).paint(&painter, all);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(all, colour);
  });
}

QIcon dotIcon(const QColor& colour, const QColor& rim, int side, qreal pixelRatio) {
  return keptIcon(keyOf(QStringLiteral("dot") + rim.name(), colour, side, pixelRatio), side, pixelRatio,
                  [&](QPainter& painter) {
                    painter.setRenderHint(QPainter::Antialiasing);
                    painter.setPen(QPen{rim, 1});
                    painter.setBrush(colour);
                    const qreal edge = side / 5.0;
                    painter.drawEllipse(QRectF{edge, edge, side - 2 * edge, side - 2 * edge});
                  });
}

}  // namespace tessera::ui
