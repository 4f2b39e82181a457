// The polyline against a walk in small steps, which knows nothing of legs or projections.
#include "base/polyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace tessera {
namespace {

Point at(double x, double y) { return {Metres{x}, Metres{y}}; }

const Polyline& corner() {
  static const Polyline line{{at(0, 0), at(2, 0), at(2, 1)}};
  return line;
}

TEST(Polyline, measuresAlongItsLegs) {
  EXPECT_EQ(corner().length(), Metres{3});
  EXPECT_EQ(corner().at(Metres{0.5}), at(0.5, 0));
  EXPECT_EQ(corner().at(Metres{2.5}), at(2, 0.5));
  EXPECT_EQ(corner().startOf(2), Metres{3});
  EXPECT_DOUBLE_EQ(corner().headingOf(1).value(), kPi / 2);
}

TEST(Polyline, distancesAreClampedToTheLine) {
  EXPECT_EQ(corner().at(Metres{-1}), at(0, 0));
  EXPECT_EQ(corner().at(Metres{99}), at(2, 1));
  EXPECT_EQ(corner().legAt(Metres{-1}), 0U);
  EXPECT_EQ(corner().legAt(Metres{99}), 1U);
}

TEST(Polyline, aVertexBelongsToTheLegThatBeginsThere) {
  EXPECT_EQ(corner().legAt(Metres{2}), 1U);
  EXPECT_EQ(corner().legAt(Metres{3}), 1U) << "the end belongs to the last leg";
}

TEST(Polyline, leftIsPositive) {
  EXPECT_DOUBLE_EQ(corner().project(at(1, 0.3)).across.value(), 0.3);
  EXPECT_DOUBLE_EQ(corner().project(at(1, -0.3)).across.value(), -0.3);
  EXPECT_NEAR(corner().project(at(2.2, 0.5)).across.value(), -0.2, 1e-12);
}

TEST(Polyline, emptyAndSinglePointLinesHaveNoLength) {
  EXPECT_TRUE(Polyline{}.empty());
  EXPECT_EQ(Polyline{}.length(), Metres{});
  EXPECT_EQ(Polyline{}.at(Metres{1}), Point{});
  const Polyline dot{{at(1, 2), at(1, 2)}};
  EXPECT_EQ(dot.legCount(), 0U);
  EXPECT_EQ(dot.at(Metres{5}), at(1, 2));
  const auto p = dot.project(at(4, 6));
  EXPECT_EQ(p.along, Metres{});
  EXPECT_DOUBLE_EQ(p.across.value(), 5.0);
}

TEST(Polyline, dropsLegsOfZeroLength) {
  const Polyline line{{at(0, 0), at(0, 0), at(1, 0), at(1, 0), at(1, 0), at(1, 1)}};
  EXPECT_EQ(line.legCount(), 2U);
  EXPECT_EQ(line.length(), Metres{2});
}

TEST(Polyline, theEarlierOfTwoEquallyNearPlacesWins) {
  const Polyline hairpin{{at(0, 0), at(2, 0), at(2, 1), at(0, 1)}};
  EXPECT_DOUBLE_EQ(hairpin.project(at(1, 0.5)).along.value(), 1.0);
}

TEST(Polyline, aWindowKeepsTheProjectionOnItsOwnPass) {
  const Polyline thereAndBack{{at(0, 0), at(2, 0), at(0, 0.01)}};
  const auto back = thereAndBack.project(at(1, 0), Metres{2}, thereAndBack.length());
  EXPECT_NEAR(back.along.value(), 3.0, 0.01);
  EXPECT_EQ(back.leg, 1U);
}

class RandomLines : public ::testing::Test {
protected:
  double number(double low, double high) { return std::uniform_real_distribution<double>{low, high}(random_); }
  Point point() { return at(number(-3, 3), number(-3, 3)); }
  Polyline line() {
    std::vector<Point> vertices(static_cast<std::size_t>(number(2, 9)));
    for (auto& v : vertices) v = point();
    return Polyline{vertices};
  }

private:
  std::mt19937_64 random_{20};
};

TEST_F(RandomLines, projectionIsNoFartherThanAnyPointOfTheWindow) {
  for (int round = 0; round < 500; ++round) {
    const Polyline l = line();
    const Point p = point();
    double from = number(-0.5, l.length().value());
    double to = number(from, l.length().value() + 0.5);
    const auto found = l.project(p, Metres{from}, Metres{to});
    from = std::clamp(from, 0.0, l.length().value());
    to = std::clamp(to, from, l.length().value());
    double nearest = std::numeric_limits<double>::infinity();
    constexpr int steps = 4000;
    for (int i = 0; i <= steps; ++i) {
      nearest = std::min(nearest, distance(l.at(Metres{from + (to - from) * i / steps}), p).value());
    }
    ASSERT_LE(std::abs(found.across.value()), nearest + 1e-9);
    ASSERT_NEAR(std::abs(found.across.value()), nearest, (to - from) / steps);
    ASSERT_NEAR(distance(found.nearest, p).value(), std::abs(found.across.value()), 1e-9);
    ASSERT_NEAR(distance(l.at(found.along), found.nearest).value(), 0.0, 1e-9);
    ASSERT_GE(found.along.value(), from - 1e-12);
    ASSERT_LE(found.along.value(), to + 1e-12);
  }
}

TEST_F(RandomLines, aPointOnTheLineProjectsOntoItself) {
  for (int round = 0; round < 2000; ++round) {
    const Polyline l = line();
    const Metres along{number(0, l.length().value())};
    const auto found = l.project(l.at(along));
    ASSERT_NEAR(found.across.value(), 0.0, 1e-9);
    ASSERT_NEAR(distance(found.nearest, l.at(along)).value(), 0.0, 1e-9);
  }
}

TEST_F(RandomLines, walkingAddsUpToTheLength) {
  for (int round = 0; round < 200; ++round) {
    const Polyline l = line();
    double walked = 0.0;
    for (std::size_t v = 0; v + 1 < l.vertices().size(); ++v) {
      walked += distance(l.vertices()[v], l.vertices()[v + 1]).value();
      ASSERT_NEAR(l.startOf(v + 1).value(), walked, 1e-9);
    }
    ASSERT_NEAR(l.length().value(), walked, 1e-9);
  }
}

}  // namespace
}  // namespace tessera
