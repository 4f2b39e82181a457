// A leg's speed stays with the way that it was given for, whatever becomes of the vertices.
#include "floor/route_legs.h"

#include <gtest/gtest.h>

#include <random>

#include "base/polyline.h"

namespace tessera::floor {
namespace {

using Speeds = std::vector<std::optional<MetresPerSecond>>;

constexpr MetresPerSecond kSlow{0.1};
constexpr MetresPerSecond kSlower{0.05};

Point along(double x) { return {Metres{x}, {}}; }

// Legs 0 to 1, 1 to 2, 2 to 3; the middle one is slow.
Route slowInTheMiddle() { return {"r", {along(0), along(1), along(2), along(3)}, Metres{0.2}, {{}, kSlow, {}}}; }

TEST(RouteLegs, bothPartsOfALegThatIsCutKeepItsSpeed) {
  Route r = slowInTheMiddle();
  insertVertex(r, 2, along(1.5));
  EXPECT_EQ(r.legSpeeds, (Speeds{{}, kSlow, kSlow, {}}));
  insertVertex(r, 0, along(-1));
  insertVertex(r, 6, along(4));
  EXPECT_EQ(r.legSpeeds, (Speeds{{}, {}, kSlow, kSlow, {}, {}})) << "what is added at the ends has none";
  EXPECT_EQ(r.vertices.size(), 7U);
}

TEST(RouteLegs, ofTwoLegsThatBecomeOneTheLowerSpeedHolds) {
  Route r = slowInTheMiddle();
  setLegSpeed(r, 2, kSlower);
  eraseVertex(r, 2);
  EXPECT_EQ(r.legSpeeds, (Speeds{{}, kSlower}));
  eraseVertex(r, 1);
  EXPECT_EQ(r.legSpeeds, (Speeds{kSlower})) << "the slow way is still driven slowly";
  r = slowInTheMiddle();
  eraseVertex(r, 0);
  EXPECT_EQ(r.legSpeeds, (Speeds{kSlow, {}}));
  eraseVertex(r, 2);
  EXPECT_EQ(r.legSpeeds, (Speeds{kSlow}));
  eraseVertex(r, 9);
  EXPECT_EQ(r.vertices, (std::vector{along(1), along(2)}));
}

TEST(RouteLegs, turnRoundWithTheRoute) {
  Route r = slowInTheMiddle();
  setLegSpeed(r, 0, kSlower);
  reverse(r);
  EXPECT_EQ(r.legSpeeds, (Speeds{{}, kSlow, kSlower}));
  EXPECT_EQ(r.vertices.front(), along(3));
}

TEST(RouteLegs, areCutAndJoinedAtAVertex) {
  for (const std::size_t vertex : {1U, 2U}) {
    Route first = slowInTheMiddle();
    const Route rest = cutAt(first, vertex);
    EXPECT_EQ(first.vertices.size(), vertex + 1);
    EXPECT_EQ(rest.vertices.front(), first.vertices.back());
    EXPECT_EQ(legSpeed(first, 1), vertex == 2 ? std::optional{kSlow} : std::nullopt);
    EXPECT_EQ(legSpeed(rest, 0), vertex == 1 ? std::optional{kSlow} : std::nullopt);
    append(first, rest);
    EXPECT_EQ(first, slowInTheMiddle());
  }
}

TEST(RouteLegs, withoutAnySpeedAreSaidByNothing) {
  Route r = slowInTheMiddle();
  setLegSpeed(r, 1, {});
  EXPECT_TRUE(r.legSpeeds.empty());
  setLegSpeed(r, 3, kSlow);
  EXPECT_TRUE(r.legSpeeds.empty()) << "there is no fourth leg";
  r = slowInTheMiddle();
  EXPECT_TRUE(cutAt(r, 1).legSpeeds.size() == 2 && r.legSpeeds.empty());
}

TEST(RouteLegs, ofNoLengthAreNoLegsOfTheLine) {
  Route r = slowInTheMiddle();
  insertVertex(r, 1, along(1));
  setLegSpeed(r, 1, kSlower);  // from (1, 0) to (1, 0)
  EXPECT_EQ(legSpeedsOfLine(r), (Speeds{{}, kSlow, {}}));
  keepVertices(r, Polyline{r.vertices}.vertices());
  EXPECT_EQ(r, slowInTheMiddle());
}

TEST(RouteLegs, fitTheVerticesAfterAnyEdits) {
  std::mt19937 random{5};
  for (int round = 0; round < 200; ++round) {
    Route r = slowInTheMiddle();
    for (int step = 0; step < 30; ++step) {
      const std::size_t n = random() % 6;
      switch (random() % 6) {
        case 0:
          insertVertex(r, n, along(static_cast<double>(random() % 9)));
          break;
        case 1:
          eraseVertex(r, n);
          break;
        case 2:
          reverse(r);
          break;
        case 3:
          if (n < r.vertices.size()) static_cast<void>(cutAt(r, n));
          break;
        case 4:
          if (!r.vertices.empty()) append(r, slowInTheMiddle());
          break;
        default:
          setLegSpeed(r, n, n == 0 ? std::nullopt : std::optional{kSlower});
      }
      const bool any = std::any_of(r.legSpeeds.begin(), r.legSpeeds.end(), [](auto s) { return s.has_value(); });
      ASSERT_EQ(r.legSpeeds.size(), any ? legCount(r) : 0U) << round << ", " << step;
      ASSERT_EQ(legSpeedsOfLine(r).size(), Polyline{r.vertices}.legCount());
    }
  }
}

}  // namespace
}  // namespace tessera::floor
