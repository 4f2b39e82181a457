// The grid itself, and as bytes.
#include "locate/magnetic_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "locate/magnetic_file.h"

namespace tessera::test {
namespace {

using locate::MagneticMap;
using locate::MagneticNode;
using locate::MagneticValue;

constexpr double kOneDegree = kPi / 180.0;

Point at(double x, double y) { return {Metres{x}, Metres{y}}; }
double squared(double v) { return v * v; }

MagneticMap someMap() {
  MagneticMap map;
  std::mt19937 random{7};
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i)
    map.learn({static_cast<std::int32_t>(random() % 60) - 30, static_cast<std::int32_t>(random() % 60) - 30},
              0.1 * normal(random), squared(2 * kOneDegree));
  return map;
}

TEST(AMagneticMap, knowsNothingAtFirstAndSaysSo) {
  const MagneticValue value = MagneticMap{}.at(at(1.0, -2.0));
  EXPECT_EQ(value.deviation, 0.0);
  EXPECT_DOUBLE_EQ(value.variance, squared(MagneticMap::kPriorSigma));
  EXPECT_NEAR(value.known(), 0.0, 1e-12);
  EXPECT_EQ(value.visits, 0U);
  EXPECT_EQ(MagneticMap{}.at(Point{Metres{std::nan("")}, Metres{0.0}}).known(), 0.0);
}

TEST(AMagneticMap, isStraightBetweenItsNodes) {
  MagneticMap map;
  for (std::int32_t column = -3; column <= 3; ++column)
    for (std::int32_t row = -3; row <= 3; ++row)
      ASSERT_TRUE(map.put({column, row}, {0.01 * column - 0.02 * row, squared(kOneDegree), 1}));
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.2, -0.31}, {-0.37, 0.11}, {-0.40, -0.44}}) {
    EXPECT_NEAR(map.at(at(x, y)).deviation, 0.01 * x / 0.15 - 0.02 * y / 0.15, 1e-9) << x << ", " << y;
    EXPECT_NEAR(map.at(at(x, y)).variance, squared(kOneDegree), 1e-9);
  }
}

TEST(AMagneticMap, settlesOnWhatManyVisitsSayAndOneWrongOneDoesLittle) {
  MagneticMap map;
  std::mt19937 random{1};
  std::normal_distribution<double> normal;
  const MagneticNode node{4, -9};
  for (int i = 0; i < 20; ++i)
    ASSERT_TRUE(map.learn(node, (6.0 + 3.0 * normal(random)) * kOneDegree, squared(3 * kOneDegree)));
  const MagneticValue before = map.at(node);
  EXPECT_NEAR(before.deviation, 6 * kOneDegree, 1.5 * kOneDegree);
  EXPECT_LT(std::sqrt(before.variance), 1.1 * kOneDegree);
  map.learn(node, -90 * kOneDegree, squared(3 * kOneDegree));
  EXPECT_NEAR(map.at(node).deviation, before.deviation, 0.8 * kOneDegree);
  EXPECT_GT(map.at(node).variance, before.variance) << "but it is doubted";
}

TEST(AMagneticMap, followsAFloorThatHasChanged) {
  MagneticMap map;
  const MagneticNode node{0, 0};
  for (int i = 0; i < 100; ++i) map.learn(node, 8 * kOneDegree, squared(3 * kOneDegree));
  ASSERT_NEAR(map.at(node).deviation, 8 * kOneDegree, 0.2 * kOneDegree);
  int visits = 0;
  while (map.at(node).deviation > -4 * kOneDegree && visits < 100) {
    map.learn(node, -5 * kOneDegree, squared(3 * kOneDegree));
    ++visits;
  }
  EXPECT_LT(visits, 20);
}

TEST(AMagneticMap, isACopyThatStaysAsItWas) {
  MagneticMap map = someMap();
  const MagneticMap picture = map;
  const MagneticValue before = picture.at(MagneticNode{3, 3});
  map.learn({3, 3}, 0.3, 1e-4);
  EXPECT_NE(map.at(MagneticNode{3, 3}).deviation, before.deviation);
  EXPECT_EQ(picture.at(MagneticNode{3, 3}).deviation, before.deviation);
  map.clear();
  EXPECT_TRUE(map.empty());
  EXPECT_FALSE(picture.empty());
}

TEST(AMagneticMap, takesNoSenselessNumbers) {
  MagneticMap map;
  EXPECT_FALSE(map.learn({0, 0}, std::nan(""), 1e-3));
  EXPECT_FALSE(map.learn({0, 0}, 0.1, std::nan("")));
  EXPECT_FALSE(map.learn({0, 0}, 0.1, 0.0));
  EXPECT_FALSE(map.learn({0, 0}, 4.0, 1e-3));
  EXPECT_FALSE(map.learn({MagneticMap::kFarthest + 1, 0}, 0.1, 1e-3));
  EXPECT_FALSE(map.put({0, 0}, {0.1, 1.0, 1})) << "less sure than nothing known";
  EXPECT_TRUE(map.empty());
}

TEST(AMagneticMapAsBytes, comesBackAsItWas) {
  for (const MagneticMap& map : {MagneticMap{}, someMap()}) {
    const auto bytes = bytesOf(map);
    const auto back = locate::magneticMapFrom(bytes);
    ASSERT_TRUE(back) << back.error().sentence.english();
    EXPECT_EQ(bytesOf(*back), bytes);
    ASSERT_EQ(back->nodeCount(), map.nodeCount());
    map.forEach([&](MagneticNode node, const MagneticValue& value) {
      EXPECT_NEAR(back->at(node).deviation, value.deviation, 1e-6);
      EXPECT_NEAR(std::sqrt(back->at(node).variance), std::sqrt(value.variance), 1e-6);
      EXPECT_EQ(back->at(node).visits, value.visits);
    });
  }
}

TEST(AMagneticMapAsBytes, isRefusedWhenItIsCutOrChanged) {
  const auto whole = bytesOf(someMap());
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(locate::magneticMapFrom(std::span{whole}.first(size))) << size;
  std::mt19937 random{3};
  for (int i = 0; i < 3000; ++i) {
    auto changed = whole;
    for (std::size_t k = 0; k <= random() % 4; ++k)
      changed[random() % changed.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
    EXPECT_EQ(changed == whole, locate::magneticMapFrom(changed).has_value());
  }
}

TEST(AMagneticMapAsBytes, isRefusedWhenItIsGarbage) {
  std::mt19937 random{5};
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::uint8_t> bytes(random() % 400);
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    if (bytes.size() > 4 && i % 2 == 0) std::copy_n("TMAG\1", 5, bytes.begin());
    const auto map = locate::magneticMapFrom(bytes);
    ASSERT_FALSE(map);
    EXPECT_TRUE(map.error().sentence.english().ends_with('.'));
  }
}

}  // namespace
}  // namespace tessera::test
