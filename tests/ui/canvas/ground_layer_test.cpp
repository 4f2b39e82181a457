#include "ui/canvas/ground_layer.h"

#include <gtest/gtest.h>

#include <QPainter>
#include <cmath>
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

Ground groundOf(const View& view, const FloorScene& scene, const CanvasTheme& theme, const Trail* trail = nullptr) {
  Ground ground{view, scene, theme, {}, Seconds{30}};
  if (trail != nullptr) ground.trails.push_back({VehicleId{1}, trail, QColor{200, 0, 0}});
  return ground;
}

QImage shown(GroundLayer& layer, const Ground& ground) {
  const View& view = ground.view;
  const double ratio = view.devicePixelRatio();
  QImage image{(view.size() * ratio).toSize(), QImage::Format_RGB32};
  image.setDevicePixelRatio(ratio);
  layer.prepare(ground);
  QPainter painter{&image};
  layer.blit(painter, QRect{QPoint{}, view.size().toSize()}, ground.theme.background);
  return image;
}

// A zigzag over the middle of the floor, a point each tenth of a second.
Trail zigzag(int points) {
  Trail trail;
  for (int n = 0; n < points; ++n)
    trail.add({Metres{3.0 + 0.04 * n}, Metres{4.0 + 0.5 * std::sin(0.2 * n)}}, Seconds{0.1 * n});
  return trail;
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

TEST(GroundLayer, ShiftsToWhatItWouldDrawAnew) {
  const CanvasTheme theme{QPalette{}};
  const FloorScene scene = sceneOf(tiledMap(30, 20));
  const Trail trail = zigzag(200);
  for (const double ratio : {1.0, 2.0}) {
    for (const double scale : {9.0, 40.0, 220.0}) {
      View view{{400, 300}, ratio};
      view.setScale(scale);
      view.centreOn({Metres{6}, Metres{4}});
      GroundLayer kept;
      shown(kept, groundOf(view, scene, theme, &trail));
      std::mt19937 random{3};
      std::uniform_int_distribution<int> step{-90, 90};
      for (int n = 0; n < 12; ++n) {
        view.panBy({static_cast<double>(step(random)), static_cast<double>(step(random))});
        const Ground ground = groundOf(view, scene, theme, &trail);
        GroundLayer fresh;
        const QImage a = shown(kept, ground);
        const QImage b = shown(fresh, ground);
        EXPECT_LT(differences(a, b), a.width() * a.height() / 500) << ratio << " " << scale << " " << n;
      }
      EXPECT_EQ(kept.redraws(), 1);
    }
  }
}

TEST(GroundLayer, DrawsTheFloorAnewOnlyWhenScaleSizeOrContentChange) {
  const CanvasTheme theme{QPalette{}};
  const FloorScene scene = sceneOf(tiledMap(5, 5));
  View view{{300, 200}, 1.0};
  GroundLayer layer;
  const auto settle = [&] {
    const Ground ground = groundOf(view, scene, theme);
    layer.prepare(ground);
    layer.work(ground, GroundLayer::kForever);
    EXPECT_TRUE(layer.settled());
    return layer.redraws();
  };
  EXPECT_EQ(settle(), 1);
  EXPECT_EQ(settle(), 1);
  view.zoomAbout({10, 10}, 1.1);
  EXPECT_EQ(settle(), 2);
  view.resize({320, 200}, 1.0);
  EXPECT_EQ(settle(), 3);
  layer.invalidate();
  EXPECT_EQ(settle(), 4);
  layer.fade();
  EXPECT_EQ(settle(), 4);
}

TEST(GroundLayer, WorksInSlicesToWhatItWouldDrawAtOnce) {
  const CanvasTheme theme{QPalette{}};
  const FloorScene scene = sceneOf(tiledMap(60, 40));
  const Trail trail = zigzag(200);
  View view{{1200, 900}, 1.0};
  view.setScale(20.0);
  view.centreOn({Metres{6}, Metres{4}});
  GroundLayer layer;
  shown(layer, groundOf(view, scene, theme, &trail));
  view.zoomAbout({600, 450}, 2.0);
  const Ground ground = groundOf(view, scene, theme, &trail);
  GroundLayer fresh;
  const QImage wanted = shown(fresh, ground);
  int slices = 0;
  const QImage standIn = shown(layer, ground);
  while (!layer.work(ground, std::chrono::milliseconds{0})) {
    EXPECT_EQ(shown(layer, ground), standIn) << "nothing half drawn is shown";
    ASSERT_LT(++slices, 1000);
  }
  EXPECT_GT(slices, 3);
  EXPECT_TRUE(layer.settled());
  EXPECT_EQ(shown(layer, ground), wanted);
}

TEST(GroundLayer, ATrailThatGrowsLooksLikeOneThatWasThere) {
  const CanvasTheme theme{QPalette{}};
  const FloorScene scene = sceneOf(tiledMap(30, 20));
  View view{{600, 400}, 1.0};
  view.setScale(60.0);
  view.centreOn({Metres{6}, Metres{4}});
  GroundLayer grown;
  for (int n = 2; n <= 100; ++n) {
    const Trail trail = zigzag(n);
    shown(grown, groundOf(view, scene, theme, &trail));
  }
  const Trail trail = zigzag(100);
  const Ground ground = groundOf(view, scene, theme, &trail);
  GroundLayer whole;
  // Its colour may be another: it fades later.
  const QImage bare = [&] {
    GroundLayer none;
    return shown(none, groundOf(view, scene, theme));
  }();
  const int painted = differences(shown(whole, ground), bare);
  EXPECT_GT(painted, 300);
  EXPECT_NEAR(differences(shown(grown, ground), bare), painted, painted / 5);
}

TEST(GroundLayer, ShowsRegisteredAndMissingTagsDifferently) {
  floor::Site site = tiledSite(1, 1);
  site.routes.clear();
  site.tiles[0].uids[0] = {};
  const FloorScene scene = sceneOf(floor::SiteMap::build(site).value());
  const CanvasTheme theme{QPalette{}};
  View view{{600, 600}, 1.0};
  view.setScale(900);
  view.centreOn({Metres{0.3}, Metres{0.3}});
  GroundLayer layer;
  const QImage image = shown(layer, groundOf(view, scene, theme));
  const auto colourAt = [&](double x, double y) {
    return image.pixelColor(view.toPixel({Metres{x}, Metres{y}}).toPoint());
  };
  EXPECT_EQ(colourAt(0.075 + 0.30, 0.075), theme.tag);
  EXPECT_EQ(colourAt(0.075, 0.075), theme.tile);  // a hollow ring
  EXPECT_EQ(colourAt(0.075 + 0.15, 0.075), theme.tile);
}

}  // namespace
}  // namespace tessera::ui
