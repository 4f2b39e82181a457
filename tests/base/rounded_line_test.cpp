// Corners rounded by arcs: that they touch, keep within the cut and the legs, and that distances along both lines go
// together, on drawn corners and on thousands of random lines.
#include "base/rounded_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tessera {
namespace {

constexpr Radians kSharp{0.35};

Point pt(double x, double y) { return {Metres{x}, Metres{y}}; }

// Legs of any length, turns of any size; every now and then a point twice, a point on the leg, or the way back.
std::vector<Point> randomVertices(std::mt19937& random) {
  const auto number = [&](double low, double high) { return std::uniform_real_distribution{low, high}(random); };
  std::vector<Point> points{pt(number(-50, 50), number(-50, 50))};
  double heading = number(-kPi, kPi);
  const int count = std::uniform_int_distribution{1, 12}(random);
  for (int i = 0; i < count; ++i) {
    switch (std::uniform_int_distribution{0, 9}(random)) {
      case 0:
        points.push_back(points.back());
        break;
      case 1:
        heading += kPi;
        break;
      case 2:
        break;
      case 3:
        heading += std::copysign(kPi / 2, number(-1, 1));
        break;
      default:
        heading += number(-kPi, kPi);
    }
    const double leg = std::exp(number(std::log(0.002), std::log(3.0)));
    points.push_back(points.back() + turned({Metres{leg}, {}}, Radians{heading}));
  }
  return points;
}

TEST(RoundedLine, roundsARightAngleAsFarAsItMay) {
  const RoundedLine way{Polyline{{pt(0, 0), pt(2, 0), pt(2, 2)}}, Metres{0.1}, kSharp};
  ASSERT_EQ(way.arcs().size(), 1U);
  const RoundedLine::Arc& arc = way.arcs()[0];
  const double radius = 0.1 / (std::sqrt(2.0) - 1);
  EXPECT_NEAR(arc.radius.value(), radius, 1e-12);
  EXPECT_NEAR(arc.tangent.value(), radius, 1e-12) << "of a right angle";
  EXPECT_NEAR(abs(way.line().project(pt(2, 0)).across).value(), 0.1, 1e-9);
  EXPECT_NEAR((arc.to - arc.from).value(), radius * kPi / 2, 2e-4);
  EXPECT_EQ(way.line().vertices().front(), pt(0, 0));
  EXPECT_EQ(way.line().vertices().back(), pt(2, 2));
}

TEST(RoundedLine, withoutACutIsTheLineItself) {
  const Polyline drawn{{pt(0, 0), pt(1, 0), pt(1, 1), pt(0, 0.5)}};
  for (const double cut : {0.0, -0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const RoundedLine way{drawn, Metres{cut}, kSharp};
    EXPECT_TRUE(way.arcs().empty()) << cut;
    EXPECT_EQ(way.line().vertices(), drawn.vertices()) << cut;
    for (const double along : {0.0, 0.3, 1.0, 1.7}) {
      EXPECT_EQ(way.onDrawn(Metres{along}).value(), along);
      EXPECT_EQ(way.onLine(Metres{along}).value(), along);
    }
  }
}

TEST(RoundedLine, sharesALegFairly) {
  // Each would like 0.48 m of the 0.6 m between them.
  const RoundedLine even{Polyline{{pt(0, 0), pt(2, 0), pt(2, 0.6), pt(0, 0.6)}}, Metres{0.2}, kSharp};
  ASSERT_EQ(even.arcs().size(), 2U);
  for (const RoundedLine::Arc& arc : even.arcs()) EXPECT_NEAR(arc.tangent.value(), 0.3, 1e-12);
  // The second one's other leg is short: what it cannot use the first one may have.
  const RoundedLine uneven{Polyline{{pt(0, 0), pt(2, 0), pt(2, 0.6), pt(2.04, 0.6)}}, Metres{0.2}, kSharp};
  ASSERT_EQ(uneven.arcs().size(), 1U) << "4 cm are no room for an arc";
  EXPECT_NEAR(uneven.arcs()[0].tangent.value(), 0.2 / (std::sqrt(2.0) - 1), 1e-12);
}

TEST(RoundedLine, leavesAloneWhatCannotBeRounded) {
  for (const auto& vertices : {std::vector{pt(0, 0), pt(1, 0), pt(0, 0)},        // back
                               std::vector{pt(0, 0), pt(1, 0), pt(0, 0.05)},     // nearly back
                               std::vector{pt(0, 0), pt(1, 0), pt(2, 0.2)},      // hardly a turn
                               std::vector{pt(0, 0), pt(1, 0), pt(2, 0)},        // none
                               std::vector{pt(0, 0), pt(0.04, 0), pt(0.04, 1)},  // no room
                               std::vector{pt(0, 0), pt(0, 0)}, std::vector{pt(0, 0)}, std::vector<Point>{}}) {
    const Polyline drawn{vertices};
    const RoundedLine way{drawn, Metres{0.15}, kSharp};
    EXPECT_TRUE(way.arcs().empty());
    EXPECT_EQ(way.line().vertices(), drawn.vertices());
  }
}

TEST(RoundedLine, keepsWithinTheCutAndTheLegsOnAnyLine) {
  std::mt19937 random{20261123};
  int arcs = 0;
  for (int n = 0; n < 5000; ++n) {
    const Polyline drawn{randomVertices(random)};
    const Metres cut{std::uniform_real_distribution{0.01, 0.5}(random)};
    const RoundedLine way{drawn, cut, kSharp};
    SCOPED_TRACE(n);
    for (const Point& p : way.line().vertices()) ASSERT_TRUE(std::isfinite(p.x.value()) && std::isfinite(p.y.value()));
    ASSERT_EQ(way.line().vertices().front(), drawn.vertices().front());
    ASSERT_EQ(way.line().vertices().back(), drawn.vertices().back());
    ASSERT_LE(way.line().length(), drawn.length() + Metres{1e-5});
    Metres free;  // on the drawn line, behind the arcs so far
    for (const RoundedLine::Arc& arc : way.arcs()) {
      ++arcs;
      ASSERT_GE(arc.radius, kTightestArc * (1.0 - 1e-6));
      ASSERT_LE(arc.radius, kWidestArc * (1.0 + 1e-6));
      ASSERT_GE(arc.vertex - arc.tangent, free - Metres{1e-9}) << "no longer than its legs allow";
      free = arc.vertex + arc.tangent;
      ASSERT_LE(free, drawn.length() + Metres{1e-9});
      const Point vertex = drawn.at(arc.vertex);
      const Point middle = way.line().at(0.5 * (arc.from + arc.to));
      ASSERT_LE(distance(vertex, middle), cut + Metres{1e-5});
      ASSERT_LE(distance(way.line().at(arc.from), drawn.at(arc.vertex - arc.tangent)), Metres{1e-5});
      ASSERT_LE(distance(way.line().at(arc.to), drawn.at(arc.vertex + arc.tangent)), Metres{1e-5});
      // It touches its legs: all of it lies at its radius from the one point that both tangents have in common.
      const std::size_t leg = drawn.legAt(arc.vertex - 0.5 * arc.tangent);
      const double side = turnBetween(drawn.headingOf(leg), drawn.headingOf(leg + 1)) > Radians{} ? 1.0 : -1.0;
      const Point centre =
          drawn.at(arc.vertex - arc.tangent) + turned({Metres{}, side * arc.radius}, drawn.headingOf(leg));
      for (int i = 0; i <= 20; ++i) {
        const Metres off = distance(way.line().at(arc.from + (i / 20.0) * (arc.to - arc.from)), centre) - arc.radius;
        ASSERT_LE(abs(off).value(), 1e-5 + 1e-3 * arc.radius.value()) << "the chain's chords lie within 0.1 %";
      }
    }
    for (std::size_t v = 1; v < way.line().legCount(); ++v) {
      const Radians turn = abs(turnBetween(way.line().headingOf(v - 1), way.line().headingOf(v)));
      const Metres along = way.line().startOf(v);
      for (const RoundedLine::Arc& arc : way.arcs()) {
        if (along <= arc.from + Metres{1e-4} || along >= arc.to - Metres{1e-4}) continue;
        ASSERT_LE(turn, kArcBend + Radians{1e-3}) << "no stop within an arc";
      }
    }
  }
  EXPECT_GT(arcs, 3000) << "there was something to try";
}

TEST(RoundedLine, distancesAlongBothLinesGoTogether) {
  std::mt19937 random{4};
  for (int n = 0; n < 1000; ++n) {
    const Polyline drawn{randomVertices(random)};
    const RoundedLine way{drawn, Metres{0.15}, kSharp};
    SCOPED_TRACE(n);
    Metres last{-1.0};
    for (int i = 0; i <= 200; ++i) {
      const Metres along = (i / 200.0) * way.line().length();
      const Metres drawnAt = way.onDrawn(along);
      ASSERT_GT(drawnAt, last);
      last = drawnAt;
      ASSERT_NEAR(way.onLine(drawnAt).value(), along.value(), 1e-9);
      ASSERT_LE(distance(drawn.at(drawnAt), way.line().at(along)), Metres{0.15 + 1e-4})
          << "the same place, but for the cut";
    }
    ASSERT_NEAR(last.value(), drawn.length().value(), 1e-4);
    for (const RoundedLine::Arc& arc : way.arcs())
      ASSERT_NEAR(way.onLine(arc.vertex).value(), 0.5 * (arc.from + arc.to).value(), 1e-9);
  }
}

}  // namespace
}  // namespace tessera
