// What differs becomes shapes and signs on the floor, at the places where it is.
#include "ui/history/comparison.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <functional>

#include "canvas_site.h"
#include "ui/history/comparer.h"

namespace tessera::ui {
namespace {

std::shared_ptr<const floor::SiteMap> mapOf(const floor::Site& site) { return floor::SiteMap::build(site).value(); }

template <class Edit>
Comparison after(Edit edit) {
  floor::Site site = tiledSite(6, 5);
  edit(site);
  return compare(tiledMap(6, 5), mapOf(site));
}

Point xy(double x, double y) { return {Metres{x}, Metres{y}}; }

// Where the signs of this look are, without those that have no place.
std::vector<Point> signs(const Comparison& c, ChangeLook look) {
  std::vector<Point> places;
  for (const auto& sign : c.marks.signs)
    if (sign.look == look && !sign.place.empty()) places.push_back(sign.place.centre());
  return places;
}

TEST(Differences, areNoneBetweenOneSiteAndItself) {
  const auto same = after([](floor::Site&) {});
  EXPECT_TRUE(same.changes.empty());
  EXPECT_TRUE(same.marks.empty());
}

TEST(Differences, haveASignEach) {
  const auto c = after([](floor::Site& s) {
    s.name = "else";
    s.routes.erase(s.routes.begin());
    s.placements.pop_back();
  });
  ASSERT_EQ(c.changes.size(), 3U);
  ASSERT_EQ(c.marks.signs.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(c.marks.signs[n].place.empty(), !c.changes[n].place) << n;
}

TEST(Differences, joinTilesThatLieSideBySideToOneArea) {
  const auto c = after([](floor::Site& s) { s.placements.resize(s.placements.size() - 6); });
  ASSERT_EQ(c.marks.shapes.size(), 1U);
  EXPECT_EQ(c.marks.shapes[0].look, ChangeLook::Removed);
  ASSERT_EQ(c.marks.shapes[0].lines.size(), 1U) << "the whole upper row, in one piece";
  EXPECT_EQ(c.marks.shapes[0].lines[0].size(), 4U);
  EXPECT_EQ(signs(c, ChangeLook::Removed).size(), 6U);
}

TEST(Differences, showAMovedTileWhereItIsAndWhereItWas) {
  const auto c = after([](floor::Site& s) { s.placements[0].origin = xy(-3.0, 0.0); });
  ASSERT_EQ(c.marks.signs.size(), 1U);
  EXPECT_EQ(c.marks.signs[0].look, ChangeLook::Moved);
  EXPECT_NEAR(c.marks.signs[0].place.centre().x.value(), -2.7, 1e-9);
  ASSERT_TRUE(c.marks.signs[0].from);
  EXPECT_NEAR(c.marks.signs[0].from->x.value(), 0.3, 1e-9);
  EXPECT_EQ(c.marks.shapes.size(), 2U);
}

TEST(Differences, showBothWaysOfARouteThatGoesElsewhere) {
  const auto c = after([](floor::Site& s) { s.routes[1].vertices[1] = xy(2.5, 2.5); });
  ASSERT_EQ(c.marks.shapes.size(), 2U);
  EXPECT_FALSE(c.marks.shapes[0].closed);
  EXPECT_EQ(c.marks.shapes[0].lines[0], tiledSite(6, 5).routes[1].vertices);
  EXPECT_EQ(c.marks.shapes[1].lines[0].back(), xy(2.5, 2.5));
}

TEST(Differences, areFoundBesideTheWindowAndTheNewestWins) {
  Comparer comparer;
  QSignalSpy done{&comparer, &Comparer::compared};
  const auto before = tiledMap(40, 50);
  std::shared_ptr<const floor::SiteMap> last;
  for (int n = 1; n <= 5; ++n) {
    floor::Site site = tiledSite(40, 50);
    site.placements.resize(site.placements.size() - static_cast<std::size_t>(n));
    last = mapOf(site);
    comparer.compare(before, last);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return done.count() > 0; }, 60'000));
  EXPECT_EQ(done.count(), 1) << "what was overtaken is not told";
  EXPECT_EQ(done[0][0].value<std::shared_ptr<const Comparison>>()->after, last);
  EXPECT_FALSE(comparer.isComparing());
}

QImage painted(const std::function<void(QPainter&)>& paint) {
  QImage picture{300, 200, QImage::Format_ARGB32_Premultiplied};
  picture.fill(Qt::white);
  QPainter painter{&picture};
  paint(painter);
  return picture;
}

TEST(DifferenceLayer, isAsIfPaintedAnewWhereverTheViewGoesAndWhateverDiffers) {
  const CanvasTheme light{QPalette{Qt::white}};
  const CanvasTheme dark{QPalette{Qt::black}};
  const auto some = after([](floor::Site& s) { s.placements.pop_back(); });
  const auto others = after([](floor::Site& s) { s.placements.erase(s.placements.begin()); });
  View view{{300, 200}, 1.0};
  view.fit({{}, xy(3.6, 3.0)}, 10.0);
  ChangeLayer layer;
  layer.set(some.marks);
  const auto expectLike = [&](const ChangeMarks& marks, const CanvasTheme& theme) {
    const QImage fresh = painted([&](QPainter& p) { paintChanges(p, view, theme, marks); });
    const QImage kept = painted([&](QPainter& p) { layer.paint(p, view, theme); });
    int apart = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 300; ++x) {
        const QColor a = fresh.pixelColor(x, y);
        const QColor b = kept.pixelColor(x, y);
        apart += static_cast<int>(std::abs(a.red() - b.red()) > 12 || std::abs(a.green() - b.green()) > 12);
      }
    EXPECT_EQ(apart, 0) << "pixels";
    EXPECT_NE(fresh, painted([](QPainter&) {})) << "there is something to see";
    return kept;
  };
  const QImage first = expectLike(some.marks, light);
  view.panBy({-20, 10});
  const QImage second = expectLike(some.marks, light);
  EXPECT_NE(first, second);
  EXPECT_NE(expectLike(some.marks, dark), second);
  layer.set(others.marks);
  expectLike(others.marks, dark);
}

// Colours alone do not tell: the shapes differ as well.
TEST(DifferenceSigns, haveShapesOfTheirOwn) {
  const CanvasTheme theme{QPalette{}};
  QList<QImage> shapes;
  for (const ChangeLook look : {ChangeLook::Added, ChangeLook::Removed, ChangeLook::Moved, ChangeLook::Changed}) {
    QImage picture{24, 24, QImage::Format_ARGB32};
    picture.fill(Qt::transparent);
    QPainter painter{&picture};
    paintChangeSign(painter, theme, look, {12, 12}, 8);
    painter.end();
    const QImage shape = picture.createAlphaMask();
    EXPECT_FALSE(shapes.contains(shape));
    shapes << shape;
  }
}

}  // namespace
}  // namespace tessera::ui
