// What the wizard proposes and refuses.
#include "ui/commission/vehicle_draft.h"

#include <gtest/gtest.h>

#include <set>

namespace tessera::ui {
namespace {

floor::VehicleSetup namedVehicle(std::uint8_t id, const char* name) {
  floor::VehicleSetup v;
  v.id = VehicleId{id};
  v.name = name;
  return v;
}

TEST(VehicleDraft, ProposesTheLowestFreeAddress) {
  floor::Site site;
  EXPECT_EQ(VehicleDraft::freeAddress(site), VehicleId{1});
  site.vehicles = {namedVehicle(1, "a"), namedVehicle(2, "b"), namedVehicle(4, "c")};
  EXPECT_EQ(VehicleDraft::freeAddress(site), VehicleId{3});
  site.vehicles.clear();
  for (int a = 1; a <= 254; ++a) site.vehicles.push_back(namedVehicle(static_cast<std::uint8_t>(a), "x"));
  EXPECT_EQ(VehicleDraft::freeAddress(site), std::nullopt);
}

TEST(VehicleDraft, ProposesANameThatNobodyHas) {
  floor::Site site;
  site.vehicles = {namedVehicle(1, "AGV 2")};
  EXPECT_EQ(VehicleDraft::freeName(site, VehicleId{2}), "AGV 3");
}

TEST(VehicleDraft, RefusesASecondVehicleOfOneNameOrAddress) {
  floor::Site site;
  site.vehicles = {namedVehicle(1, "AGV 1")};
  EXPECT_FALSE(VehicleDraft::complaint(site, namedVehicle(1, "other"), std::nullopt).isEmpty());
  EXPECT_FALSE(VehicleDraft::complaint(site, namedVehicle(2, "AGV 1"), std::nullopt).isEmpty());
  EXPECT_FALSE(VehicleDraft::complaint(site, namedVehicle(2, " "), std::nullopt).isEmpty());
  EXPECT_FALSE(VehicleDraft::complaint(site, namedVehicle(0, "zero"), std::nullopt).isEmpty());
  EXPECT_TRUE(VehicleDraft::complaint(site, namedVehicle(2, "AGV 2"), std::nullopt).isEmpty());
  EXPECT_TRUE(VehicleDraft::complaint(site, namedVehicle(1, "AGV 1"), VehicleId{1}).isEmpty());
}

TEST(VehicleDraft, ReadsBackTheKeysThatItWrites) {
  const wire::Key key = VehicleDraft::randomKey();
  EXPECT_EQ(VehicleDraft::keyFromText(VehicleDraft::keyText(key)), key);
  EXPECT_EQ(VehicleDraft::keyFromText("284a27c742c615c4-d46476e3adbfca68").value()[0], 0x28);
  EXPECT_FALSE(VehicleDraft::keyFromText("284A"));
  EXPECT_FALSE(VehicleDraft::keyFromText("zz4A27C742C615C4D46476E3ADBFCA68"));
  EXPECT_FALSE(VehicleDraft::keyFromText(""));
}

TEST(VehicleDraft, NoTwoRandomKeysAreEqual) {
  std::set<wire::Key> keys;
  for (int i = 0; i < 100; ++i) keys.insert(VehicleDraft::randomKey());
  EXPECT_EQ(keys.size(), 100U);
}

TEST(VehicleDraft, PresetsStandInTheSiteWithoutContradiction) {
  floor::Site site;
  site.vehicles = {namedVehicle(9, "Nine")};
  const auto presets = VehicleDraft::presets(site);
  ASSERT_EQ(presets.size(), 4U);
  EXPECT_TRUE(presets.back().name.contains("Nine"));
  for (const auto& p : presets) {
    if (p.setup.id == VehicleId{9}) continue;
    const VehicleExtent e = VehicleDraft::extentOf(p.setup.footprint);
    EXPECT_LT(p.setup.track.value(), 2 * e.side.value());
    for (std::size_t i = 1; i < p.setup.readers.size(); ++i)
      EXPECT_GT(p.setup.readers[i - 1].y.value(), p.setup.readers[i].y.value());
    EXPECT_LT(p.setup.readers.front().x.value(), e.front.value());
  }
}

TEST(VehicleDraft, AnOutlineKeepsItsExtent) {
  const VehicleExtent e{Metres{0.5}, Metres{0.3}, Metres{0.2}};
  EXPECT_EQ(VehicleDraft::extentOf(VehicleDraft::outlineOf(e)), e);
}

}  // namespace
}  // namespace tessera::ui
