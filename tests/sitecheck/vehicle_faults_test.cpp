#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Site;
using testing::HasSubstr;

TEST(VehicleFaults, addressesThatStandTwiceOrCannotBe) {
  Site site = goodFloor();
  site.vehicles.push_back(site.vehicles[0]);
  site.vehicles[1].name = "AGV 2";
  site.vehicles[1].key[0] = 1;
  auto faults = faultsOf(site, FaultKind::VehicleAddressTwice);
  ASSERT_EQ(faults.size(), 1U);
  ASSERT_TRUE(mend(faults[0].fix->edit, site));
  EXPECT_EQ(site.vehicles[1].id, VehicleId{2});
  EXPECT_EQ(listOf(checkSite(site).faults()), "");
  for (const int bad : {0, 255}) {
    site.vehicles[1].id.value = static_cast<std::uint8_t>(bad);
    faults = faultsOf(site, FaultKind::VehicleAddressInvalid);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_THAT(faults[0].sentence.english(), HasSubstr("1 to 254"));
  }
}

TEST(VehicleFaults, keysThatAreMissingOrShared) {
  Site site = goodFloor();
  site.vehicles[0].key = {};
  EXPECT_EQ(faultsOf(site, FaultKind::VehicleWithoutKey).size(), 1U);
  site = goodFloor();
  site.vehicles.push_back(site.vehicles[0]);
  site.vehicles[1].id = VehicleId{9};
  EXPECT_EQ(faultsOf(site, FaultKind::VehicleKeyShared).size(), 1U);
  EXPECT_EQ(faultsOf(site, FaultKind::VehicleTwice).size(), 1U);
}

TEST(VehicleFaults, noReadersNoBodyNoPlace) {
  Site site = goodFloor();
  site.vehicles[0].readers.clear();
  site.vehicles[0].footprint.clear();
  site.vehicles[0].start = Pose{at(-1, -1), {}};
  EXPECT_EQ(faultsOf(site, FaultKind::VehicleWithoutReaders).size(), 1U);
  EXPECT_EQ(faultsOf(site, FaultKind::VehicleWithoutFootprint).size(), 1U);
  EXPECT_EQ(faultsOf(site, FaultKind::VehicleStartOutside).size(), 1U);
}

TEST(RadioFaults, settingsThatTheModuleDoesNotKnow) {
  Site site = goodFloor();
  site.radio = {40, 1000, 9601};
  EXPECT_EQ(faultsOf(site, FaultKind::RadioSettingInvalid).size(), 3U);
}

TEST(RadioFaults, aChannelTooSlowForItsVehicles) {
  Site site = goodFloor();
  EXPECT_TRUE(faultsOf(site, FaultKind::RadioTooSlow).empty());
  site.radio.airRate = 1200;
  EXPECT_EQ(faultsOf(site, FaultKind::RadioTooSlow).size(), 1U);
  site.radio.airRate = 19200;
  for (int i = 2; i <= 10; ++i) {
    site.vehicles.push_back(site.vehicles[0]);
    site.vehicles.back().id.value = static_cast<std::uint8_t>(i);
  }
  EXPECT_TRUE(faultsOf(site, FaultKind::RadioTooSlow).empty()) << "ten are a fifth of a second";
  for (int i = 11; i <= 60; ++i) {
    site.vehicles.push_back(site.vehicles[0]);
    site.vehicles.back().id.value = static_cast<std::uint8_t>(i);
  }
  EXPECT_EQ(faultsOf(site, FaultKind::RadioTooSlow).size(), 1U);
}

}  // namespace
}  // namespace tessera::sitecheck
