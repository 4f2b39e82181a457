#include "ui/canvas/floor_painter.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/canvas/dot_stamp.h"
#include "ui/canvas/furniture.h"
#include "ui/canvas/round_way_painter.h"
#include "ui/canvas/route_painter.h"

namespace tessera::ui {
namespace {

constexpr double kSerialPixels = 110.0;  // a tile of this width has room for its serial number
constexpr double kSeamPixels = 7.0;
constexpr double kGridSeams = 30.0;

QRectF pixelRect(const View& view, const SiteBox& box) {
  return QRectF{view.toPixel(box.low), view.toPixel(box.high)}.normalized();
}

SiteBox siteBox(const View& view, const QRectF& pixels) {
  SiteBox box;
  box.add(view.toSite(pixels.topLeft()));
  box.add(view.toSite(pixels.bottomRight()));
  return box;
}

void paintFarFloor(QPainter& painter, const View& view, const FloorScene& scene, const CanvasTheme& theme,
                   const SiteBox& box) {
  // A few cells more than in view: smooth edges of one strip must meet those of the next.
  const Metres margin = view.metres(16.0);
  const FloorMip::Picture picture = scene.mip->picture(box.grown(margin), view.scale(), theme);
  if (picture.image.isNull()) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.drawImage(pixelRect(view, picture.box), picture.image);
}

void paintTiles(QPainter& painter, const View& view, const FloorScene& scene, const CanvasTheme& theme,
                const SiteBox& box) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  std::vector<const FloorIndex::Tile*> tiles;
  scene.index->forEachTile(box, [&](const FloorIndex::Tile& tile) { tiles.push_back(&tile); });
  const double ratio = view.devicePixelRatio();
  const auto onDevice = [ratio](double v) { return std::round(v * ratio) / ratio; };
  const auto rectOf = [&](const FloorIndex::Tile& tile) {
    const QRectF r = pixelRect(view, tile.box);
    const QPointF from{onDevice(r.left()), onDevice(r.top())};
    return QRectF{from, QPointF{onDevice(r.right()), onDevice(r.bottom())}};
  };
  QVector<QRectF> rects;
  rects.reserve(static_cast<qsizetype>(tiles.size()));
  for (const FloorIndex::Tile* tile : tiles) rects.push_back(rectOf(*tile));
  for (const QRectF& rect : std::as_const(rects)) painter.fillRect(rect, theme.tile);
  const double width = view.pixels(scene.index->smallestTile());
  if (width >= kSeamPixels) {
    QColor seam = theme.seam;
    seam.setAlphaF(std::min(1.0F, static_cast<float>((width - kSeamPixels) / 20.0) + 0.25F));
    painter.setPen(QPen{seam, 0});
    painter.setBrush(Qt::NoBrush);
    painter.drawRects(rects);
  }
  if (width < kSerialPixels) return;
  QFont font = scene.font;
  font.setPointSizeF(font.pointSizeF() * 0.8);
  painter.setFont(font);
  const QFontMetricsF metrics{font};
  painter.setPen(theme.serial);
  for (qsizetype n = 0; n < rects.size(); ++n) {
    const QString serial = QString::fromStdString(scene.index->serial(*tiles[static_cast<std::size_t>(n)]));
    painter.drawText(QPointF{rects[n].left() + 5, rects[n].bottom() - metrics.descent() - 3},
                     metrics.elidedText(serial, Qt::ElideMiddle, rects[n].width() - 10));
  }
  painter.setFont(scene.font);
}

void stampTags(QImage& image, const View& view, const FloorScene& scene, const CanvasTheme& theme, const SiteBox& box,
               const QRect& clip) {
  const double ratio = view.devicePixelRatio();
  const double pitch = view.pixels(scene.index->pitch());
  // As large as a transponder of 3 cm across, but never so small that it cannot be seen nor so large that dots touch.
  const double radius = std::clamp(view.scale() * 0.015, std::min(0.16 * pitch, 1.3), 9.0) * ratio;
  const DotStamp dot{radius, theme.tag};
  const DotStamp gap{std::max(radius, 1.2 * ratio), theme.missingTag, true};
  const FloorIndex& index = *scene.index;
  const auto put = [&](const DotStamp& stamp, Point place) {
    const QPointF at = view.toPixel(place) * ratio;
    stamp.put(image, at.x(), at.y(), clip);
  };
  index.forEachTile(box, [&](const FloorIndex::Tile& tile) {
    const std::vector<Offset>& offsets = index.offsetsOf(tile.shape);
    for (std::size_t n = 0; n < offsets.size(); ++n)
      put(index.isRegistered(tile.firstPlace + n) ? dot : gap, tile.origin + offsets[n]);
  });
  for (const FloorIndex::Loose& tag : index.loose()) {
    if (box.contains(tag.place)) put(dot, tag.place);
  }
}

}  // namespace

void paintFloor(QImage& image, const View& view, const FloorScene& scene, const CanvasTheme& theme, const QRect& clip) {
  const double ratio = view.devicePixelRatio();
  const QRectF logical{clip.left() / ratio, clip.top() / ratio, clip.width() / ratio, clip.height() / ratio};
  // Dots on the edge reach in from outside.
  const SiteBox box = siteBox(view, logical.adjusted(-12, -12, 12, 12));
  const bool near = view.pixels(scene.index->pitch()) >= kDotPitch;
  const auto begin = [&](QPainter& painter) {
    painter.begin(&image);
    painter.setFont(scene.font);
    painter.setClipRect(logical);
  };
  QPainter painter;
  begin(painter);
  painter.fillRect(logical, theme.background);
  if (scene.layers.backdrop && scene.backdrop)
    paintBackdrop(painter, view, scene.backdrop->place, *scene.backdrop->picture, logical);
  if (scene.layers.grid) paintGrid(painter, view, theme, false);
  if (near || !scene.layers.tags) {
    paintTiles(painter, view, scene, theme, box);
  } else {
    paintFarFloor(painter, view, scene, theme, box);
  }
  if (scene.layers.zones && scene.map) paintZones(painter, view, scene.map->site().zones, theme);
  // Where seams show, they are the floor's grid.
  if (scene.layers.grid && view.pixels(scene.index->smallestTile()) < kGridSeams) paintGrid(painter, view, theme, true);
  painter.end();
  if (near && scene.layers.tags) stampTags(image, view, scene, theme, box, clip);
  if (!scene.layers.routes || !scene.map) return;
  begin(painter);
  const floor::Route* chosen = nullptr;
  for (const floor::Route& route : scene.map->site().routes) {
    if (QString::fromStdString(route.name) == scene.chosenRoute) {
      chosen = &route;
    } else {
      paintRoute(painter, view, theme, route, RouteLook::Quiet);
    }
  }
  if (chosen != nullptr && scene.withChosen) {
    paintRoundWays(painter, view, theme, *chosen, scene.map->site().vehicles);
    paintRoute(painter, view, theme, *chosen, RouteLook::Chosen);
  }
  painter.end();
}

}  // namespace tessera::ui
