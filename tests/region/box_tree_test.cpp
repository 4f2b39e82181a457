#include "region/box_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tessera::region {
namespace {

TEST(BoxTree, findsWhatBruteForceFinds) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> at{-50, 50};
  std::exponential_distribution<double> size{0.5};
  const auto box = [&] {
    const Point low{Metres{at(random)}, Metres{at(random)}};
    return Box{low, low + Offset{Metres{size(random)}, Metres{size(random)}}};
  };
  for (const std::size_t count : {0U, 1U, 16U, 17U, 300U, 5000U}) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) boxes.push_back(box());
    const BoxTree tree{boxes};
    for (int round = 0; round < 50; ++round) {
      const Box place = box();
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < count; ++i)
        if (meet(boxes[i], place)) expected.push_back(i);
      std::vector<std::size_t> found;
      tree.forEachIn(place, [&](std::size_t i) { found.push_back(i); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected) << count;
    }
  }
}

TEST(BoxTree, bearsBoxesThatAreNoNumbers) {
  const Metres nan{std::numeric_limits<double>::quiet_NaN()};
  std::vector<Box> boxes(40, Box{{nan, nan}, {nan, nan}});
  boxes[7] = {{}, {Metres{1}, Metres{1}}};
  int found = 0;
  BoxTree{boxes}.forEachIn({{}, {Metres{2}, Metres{2}}}, [&](std::size_t i) { found += i == 7 ? 1 : 0; });
  EXPECT_LE(found, 1);
}

}  // namespace
}  // namespace tessera::region
