#include "ui/canvas/still_layer.h"

#include <gtest/gtest.h>

#include <QPainter>
#include <random>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

FloorScene sceneOf(const std::shared_ptr<const floor::SiteMap>& map) {
  FloorScene scene;
  scene.map = map;
  scene.index = std::make_shared<FloorIndex>(map->site());
  scene.mip = std::make_shared<FloorMip>(*scene.index);
  return scene;
}

QImage shown(StillLayer& layer, const View& view, const FloorScene& scene, const CanvasTheme& theme) {
  const double ratio = view.devicePixelRatio();
  QImage image{(view.size() * ratio).toSize(), QImage::Format_RGB32};
  image.setDevicePixelRatio(ratio);
  layer.prepare(view, scene, theme);
  QPainter painter{&image};
  layer.blit(painter, QRect{QPoint{}, view.size().toSize()});
  return image;
}

// How many pixels differ by more than a hair between two pictures of one size.
int differences(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int most =
          std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
      if (most > 24) ++count;
    }
  }
  return count;
}

TEST(StillLayer, ShiftsToWhatItWouldDrawAnew) {
  const CanvasTheme theme{QPalette{}};
  const FloorScene scene = sceneOf(tiledMap(30, 20));
  for (const double ratio : {1.0, 2.0}) {
    for (const double scale : {9.0, 40.0, 220.0}) {
      View view{{400, 300}, ratio};
      view.setScale(scale);
      view.centreOn({Metres{6}, Metres{4}});
      StillLayer kept;
      shown(kept, view, scene, theme);
      std::mt19937 random{3};
      std::uniform_int_distribution<int> step{-90, 90};
      for (int n = 0; n < 12; ++n) {
        view.panBy({static_cast<double>(step(random)), static_cast<double>(step(random))});
        StillLayer fresh;
        const QImage a = shown(kept, view, scene, theme);
        const QImage b = shown(fresh, view, scene, theme);
        EXPECT_LT(differences(a, b), a.width() * a.height() / 500) << ratio << " " << scale << " " << n;
      }
      EXPECT_EQ(kept.redraws(), 1);
    }
  }
}

TEST(StillLayer, DrawsAnewOnlyWhenScaleSizeOrContentChange) {
  const CanvasTheme theme{QPalette{}};
  const FloorScene scene = sceneOf(tiledMap(5, 5));
  View view{{300, 200}, 1.0};
  StillLayer layer;
  layer.prepare(view, scene, theme);
  layer.prepare(view, scene, theme);
  EXPECT_EQ(layer.redraws(), 1);
  view.zoomAbout({10, 10}, 1.1);
  layer.prepare(view, scene, theme);
  EXPECT_EQ(layer.redraws(), 2);
  view.resize({320, 200}, 1.0);
  layer.prepare(view, scene, theme);
  EXPECT_EQ(layer.redraws(), 3);
  layer.invalidate();
  layer.prepare(view, scene, theme);
  EXPECT_EQ(layer.redraws(), 4);
}

TEST(StillLayer, ShowsRegisteredAndMissingTagsDifferently) {
  floor::Site site = tiledSite(1, 1);
  site.routes.clear();
  site.tiles[0].uids[0] = {};
  const FloorScene scene = sceneOf(floor::SiteMap::build(site).value());
  const CanvasTheme theme{QPalette{}};
  View view{{600, 600}, 1.0};
  view.setScale(900);
  view.centreOn({Metres{0.3}, Metres{0.3}});
  StillLayer layer;
  const QImage image = shown(layer, view, scene, theme);
  const auto colourAt = [&](double x, double y) {
    return image.pixelColor(view.toPixel({Metres{x}, Metres{y}}).toPoint());
  };
  EXPECT_EQ(colourAt(0.075 + 0.30, 0.075), theme.tag);
  EXPECT_EQ(colourAt(0.075, 0.075), theme.tile);  // a hollow ring
  EXPECT_EQ(colourAt(0.075 + 0.15, 0.075), theme.tile);
}

}  // namespace
}  // namespace tessera::ui
