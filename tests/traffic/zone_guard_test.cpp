// How far a vehicle may go along its way, and what it holds meanwhile.
#include "traffic/zone_guard.h"

#include <gmock/gmock.h>

#include <cmath>

#include "traffic/parts.h"

namespace tessera::traffic {
namespace {

floor::Zone single(double x0, double x1) {
  return {"single", floor::ZoneKind::SingleVehicle, {at(x0, -1), at(x1, -1), at(x1, 1), at(x0, 1)}, {}, {}};
}
std::shared_ptr<Traffic> trafficOf(const std::vector<floor::Zone>& zones) {
  return std::make_shared<Traffic>(Traffic{ZoneMap{zones}, {}});
}

class Pair : public testing::Test {
protected:
  void lay(const std::vector<floor::Zone>& zones) {
    traffic = trafficOf(zones);
    for (auto& [id, guard] : {std::pair{kOne, &one}, {kTwo, &two}}) {
      *guard = std::make_unique<ZoneGuard>(id, kBody, traffic);
      (*guard)->laid(Polyline{{at(0, 0), at(10, 0)}});
    }
  }
  static double goes(ZoneGuard& guard, double along) { return guard.mayGoTo(Metres{along}, Metres{0.3}).value(); }

  std::shared_ptr<Traffic> traffic;
  std::unique_ptr<ZoneGuard> one, two;
};

TEST_F(Pair, waitBeforeTheZoneUntilTheOtherHasLeftIt) {
  lay({single(2, 3)});
  EXPECT_TRUE(std::isinf(goes(*one, 0.0))) << "far away nobody asks";
  EXPECT_THAT(one->needed(), testing::IsEmpty());
  EXPECT_TRUE(std::isinf(goes(*one, 1.5)));
  EXPECT_THAT(one->needed(), testing::ElementsAre(0U));
  const double stop = goes(*two, 1.5);
  EXPECT_LT(stop, 2.0 - 0.30) << "its nose stays outside";
  EXPECT_GT(stop, 2.0 - 0.30 - 0.15);
  EXPECT_TRUE(std::isinf(goes(*one, 3.1))) << "its tail is still in the zone";
  traffic->rights.keepOnly(kOne, one->needed(), true);
  EXPECT_EQ(goes(*two, 1.5), stop);
  EXPECT_TRUE(std::isinf(goes(*one, 3.2)));
  traffic->rights.keepOnly(kOne, one->needed(), true);
  EXPECT_TRUE(std::isinf(goes(*two, 1.5)));
}

TEST_F(Pair, askForZonesTogetherBetweenWhichTheyCouldNotWait) {
  lay({single(2, 3), single(3.2, 4), single(8, 9)});
  EXPECT_TRUE(std::isinf(goes(*one, 1.5)));
  EXPECT_THAT(one->needed(), testing::ElementsAre(0U, 1U)) << "there is no room between the first two";
  EXPECT_TRUE(std::isinf(goes(*one, 3.5)));
  EXPECT_THAT(one->needed(), testing::ElementsAre(1U)) << "what is behind is free for others";
}

TEST_F(Pair, mayGoOnOutOfAZoneInWhichTheyStand) {
  lay({single(0, 1)});
  traffic->rights.standsIn(kOne, {0});
  EXPECT_TRUE(std::isinf(goes(*one, 0.5)));
  EXPECT_LE(goes(*two, 0.0), 0.0) << "stays where it is";
}

TEST_F(Pair, takeOverOtherZonesInTheMiddleOfADrive) {
  lay({});
  EXPECT_TRUE(std::isinf(goes(*one, 1.5)));
  traffic->zones = ZoneMap{std::vector{single(2, 3)}};
  traffic->rights.standsIn(kTwo, {0});
  one->zonesChanged();
  EXPECT_LT(goes(*one, 1.5), 1.7);
}

}  // namespace
}  // namespace tessera::traffic
