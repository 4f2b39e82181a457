// Quantities mix as physics lets them. (What must not compile at all is tried in tests/structure.)
#include "base/units.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "base/ids.h"

namespace tessera {
namespace {

using namespace literals;

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Multipliable = requires(A a, B b) {
  a* b;
};

static_assert(!Addable<Metres, Seconds>);
static_assert(!Addable<Metres, double>);
static_assert(!Multipliable<Metres, Metres>);
static_assert(!std::is_convertible_v<double, Metres>);
static_assert(!std::is_convertible_v<Metres, double>);

TEST(Units, combineToTheRightKind) {
  static_assert(std::is_same_v<decltype(1.0_m / 1.0_s), MetresPerSecond>);
  static_assert(std::is_same_v<decltype(1.0_rad / 1.0_s), RadiansPerSecond>);
  EXPECT_DOUBLE_EQ((0.5_mps * 4.0_s).value(), 2.0);
  EXPECT_DOUBLE_EQ((4.0_s * 0.5_mps).value(), 2.0);
  EXPECT_DOUBLE_EQ((RadiansPerSecond{1.5} * 2.0_s).value(), 3.0);
  EXPECT_DOUBLE_EQ((MetresPerSecond2{0.5} * 2.0_s).value(), 1.0);
  EXPECT_DOUBLE_EQ((1.0_m / 0.25_mps).value(), 4.0);
  EXPECT_DOUBLE_EQ((0.5_mps / MetresPerSecond2{0.25}).value(), 2.0);
  EXPECT_DOUBLE_EQ(1.0_m / 0.25_m, 4.0);
}

TEST(Units, literalsScale) {
  EXPECT_DOUBLE_EQ((15.0_cm).value(), 0.15);
  EXPECT_DOUBLE_EQ((250.0_ms).value(), 0.25);
  EXPECT_DOUBLE_EQ((180.0_deg).value(), 3.14159265358979323846);
}

TEST(Units, addScaleAndCompare) {
  Metres l = 1.0_m;
  l += 0.5_m;
  l -= 0.25_m;
  l *= 2.0;
  EXPECT_EQ(l, 2.5_m);
  EXPECT_EQ(abs(-l), l);
  EXPECT_LT(-l, l);
  EXPECT_EQ(2.0 * l, l * 2.0);
  EXPECT_EQ(l / 2.0, 1.25_m);
  EXPECT_EQ(Metres{}, 0.0_m);
}

TEST(Ids, compareByValueAndHash) {
  EXPECT_LT(VehicleId{1}, VehicleId{2});
  EXPECT_EQ(std::hash<VehicleId>{}(VehicleId{7}), std::hash<VehicleId>{}(VehicleId{7}));
  static_assert(!std::is_convertible_v<VehicleId, Id<struct OtherTag, std::uint8_t>>);
}

}  // namespace
}  // namespace tessera
