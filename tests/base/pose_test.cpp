#include "base/pose.h"

#include <gtest/gtest.h>

namespace tessera {
namespace {

TEST(Pose, placesAPointOfTheVehicleOnTheSite) {
  const Pose facingUp{{Metres{2}, Metres{1}}, Radians{kPi / 2}};
  const Point nose = placeOf(facingUp, {Metres{0.15}, Metres{0.10}});
  EXPECT_NEAR(nose.x.value(), 1.90, 1e-12) << "left of a vehicle that faces up is towards smaller x";
  EXPECT_NEAR(nose.y.value(), 1.15, 1e-12);
}

TEST(Pose, offsetsAddAndTurn) {
  const Point a{Metres{1}, Metres{2}};
  const Point b{Metres{4}, Metres{6}};
  EXPECT_EQ(a + (b - a), b);
  EXPECT_EQ(b - (b - a), a);
  EXPECT_DOUBLE_EQ(distance(a, b).value(), 5.0);
  EXPECT_DOUBLE_EQ(direction({Metres{0}, Metres{-1}}).value(), -kPi / 2);
  const Offset back = turned({Metres{1}, Metres{0}}, Radians{kPi});
  EXPECT_NEAR(back.x.value(), -1.0, 1e-15);
  EXPECT_NEAR(back.y.value(), 0.0, 1e-15);
}

}  // namespace
}  // namespace tessera
