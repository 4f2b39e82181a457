#include "sim/rangers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/site_bounds.h"
#include "sim/test_floor.h"

namespace tessera::sim {
namespace {

RangerParameters exact() {
  RangerParameters p;
  p.noise = Metres{};
  p.miss = 0.0;
  return p;
}

TEST(Rangers, measureTheWallAheadFromTheVehiclesFrontCorners) {
  Rangers rangers{exact(), RandomStream{1, "rangers"}};
  const Scene scene{{{{Metres{1.2}, Metres{-5.0}}, {Metres{1.2}, Metres{5.0}}}}, {}};
  const auto range = rangers.measure(Pose{}, scene);
  EXPECT_NEAR(range[0].value(), 1.0, 1e-9);
  EXPECT_NEAR(range[1].value(), 1.0, 1e-9);
}

TEST(Rangers, measureNothingWhenTheyAreDead) {
  Rangers rangers{exact(), RandomStream{1, "rangers"}};
  const Scene scene{{{{Metres{1.0}, Metres{-2.0}}, {Metres{1.0}, Metres{2.0}}}}, {}};
  rangers.setDead(1, true);
  const auto range = rangers.measure(Pose{}, scene);
  EXPECT_NEAR(range[0].value(), 0.80, 1e-9);
  EXPECT_TRUE(std::isnan(range[1].value()));
  rangers.setDead(1, false);
  EXPECT_NEAR(rangers.measure(Pose{}, scene)[1].value(), 0.80, 1e-9);
}

TEST(Rangers, seeAPostOnlyOnItsSide) {
  Rangers rangers{exact(), RandomStream{1, "rangers"}};
  const Scene scene{{}, {{{Metres{1.0}, Metres{0.12}}, Metres{0.05}}}};
  const auto range = rangers.measure(Pose{}, scene);
  EXPECT_NEAR(range[0].value(), 0.75, 1e-9);
  EXPECT_EQ(range[1].value(), 0.0);
}

TEST(Rangers, seeNothingBehindOrBeyondTheirReach) {
  Rangers rangers{exact(), RandomStream{1, "rangers"}};
  const Scene scene{{{{Metres{-1.0}, Metres{-5.0}}, {Metres{-1.0}, Metres{5.0}}},
                     {{Metres{4.5}, Metres{-5.0}}, {Metres{4.5}, Metres{5.0}}}},
                    {{{Metres{-0.5}, Metres{}}, Metres{0.1}}}};
  for (const Metres range : rangers.measure(Pose{}, scene)) EXPECT_EQ(range.value(), 0.0);
}

TEST(Rangers, areNoisyAndMissSometimes) {
  Rangers rangers{RangerParameters{}, RandomStream{1, "rangers"}};
  const Scene scene{{{{Metres{1.2}, Metres{-5.0}}, {Metres{1.2}, Metres{5.0}}}}, {}};
  int missed = 0;
  double squares = 0.0;
  constexpr int kPings = 5000;
  for (int i = 0; i < kPings; ++i) {
    const Metres range = rangers.measure(Pose{}, scene)[0];
    if (range.value() == 0.0)
      ++missed;
    else
      squares += std::pow(range.value() - 1.0, 2);
  }
  EXPECT_NEAR(missed / static_cast<double>(kPings), 0.01, 0.005);
  EXPECT_NEAR(std::sqrt(squares / (kPings - missed)), 0.003, 0.0003);
}

TEST(Rangers, seeTheWallsOfTheRoomAroundASite) {
  Rangers rangers{exact(), RandomStream{1, "rangers"}};
  const Scene room = roomAround(testSite(12), Metres{1.0});  // 1.8 m square
  const auto range = rangers.measure({{Metres{0.9}, Metres{0.9}}, Radians{kPi / 2}}, room);
  EXPECT_NEAR(range[0].value(), 1.7, 1e-9);
  EXPECT_NEAR(range[1].value(), 1.7, 1e-9);
}

}  // namespace
}  // namespace tessera::sim
