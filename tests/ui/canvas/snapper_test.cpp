#include "ui/canvas/snapper.h"

#include <gtest/gtest.h>

#include <cmath>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

Point spotAt(double x, double y) { return {Metres{x}, Metres{y}}; }

class Snapping : public testing::Test {
protected:
  Snapping() { near(200); }
  void near(double scale) {
    view.setScale(scale);
    view.centreOn(spotAt(1.5, 1.2));
  }
  [[nodiscard]] Snap at(double x, double y, SnapWish wish = {}) const {
    return snapped({view, *map, index}, view.toPixel(spotAt(x, y)), wish);
  }
  View view{{1000, 800}, 1.0};
  std::shared_ptr<const floor::SiteMap> map = tiledMap(5, 4);
  FloorIndex index{map->site()};
};

TEST_F(Snapping, PrefersVerticesToTagsToTiles) {
  EXPECT_EQ(at(2.01, 0.49).kind, Snap::Kind::Vertex);
  EXPECT_EQ(at(2.01, 0.49).place, spotAt(2.0, 0.5));
  EXPECT_EQ(at(0.08, 0.08).kind, Snap::Kind::Tag);
  EXPECT_EQ(at(1.21, 1.79).kind, Snap::Kind::TileCorner);
  EXPECT_EQ(at(0.91, 1.49).kind, Snap::Kind::TileMiddle);
  EXPECT_EQ(at(1.21, 1.355).kind, Snap::Kind::TileEdge);
  EXPECT_NEAR(at(1.21, 1.355).place.x.value(), 1.2, 1e-9);
}

TEST_F(Snapping, RoundsToWholeCentimetresElsewhere) {
  const Snap snap = at(1.1234, 1.3456);
  ASSERT_EQ(snap.kind, Snap::Kind::None);
  EXPECT_NEAR(snap.place.x.value() * 100, std::round(snap.place.x.value() * 100), 1e-6);
  EXPECT_LT(distance(snap.place, spotAt(1.1234, 1.3456)).value(), 0.011);
}

TEST_F(Snapping, IsOffWithAlt) {
  SnapWish wish;
  wish.off = true;
  const Snap snap = at(2.01, 0.49, wish);
  EXPECT_EQ(snap.kind, Snap::Kind::None);
  EXPECT_NEAR(snap.place.x.value(), 2.01, 0.003);
}

TEST_F(Snapping, HoldsTheDirectionFromAPoint) {
  SnapWish wish;
  wish.from = spotAt(1.0, 1.0);
  for (int eighth = 0; eighth < 8; ++eighth) {
    const Radians way{eighth * kPi / 4 + 0.2};
    const Point aim = spotAt(1.0, 1.0) + turned({Metres{0.7}, {}}, way);
    const Snap snap = at(aim.x.value(), aim.y.value(), wish);
    EXPECT_EQ(snap.kind, Snap::Kind::Direction);
    EXPECT_LT(std::abs(turnBetween(direction(snap.place - spotAt(1.0, 1.0)), Radians{eighth * kPi / 4}).value()),
              0.002);
  }
}

TEST_F(Snapping, DoesNotCatchEveryPointWhenFarAway) {
  near(20);
  EXPECT_EQ(at(2.81, 1.23).kind, Snap::Kind::None);
}

}  // namespace
}  // namespace tessera::ui
