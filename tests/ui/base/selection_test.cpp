#include "ui/base/selection.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

namespace tessera::ui {
namespace {

TEST(ChosenVehicleAndRoute, areToldWhenTheyChangeAndOnlyThen) {
  Selection selection;
  QSignalSpy vehicle{&selection, &Selection::vehicleChanged};
  QSignalSpy route{&selection, &Selection::routeChanged};
  EXPECT_EQ(selection.vehicle(), std::nullopt);
  selection.setVehicle(VehicleId{3});
  selection.setVehicle(VehicleId{3});
  EXPECT_EQ(selection.vehicle(), VehicleId{3});
  EXPECT_EQ(vehicle.size(), 1);
  selection.setRoute("north");
  selection.setRoute("north");
  EXPECT_EQ(selection.route(), "north");
  EXPECT_EQ(route.size(), 1);
  selection.setVehicle(std::nullopt);
  EXPECT_EQ(vehicle.size(), 2);
  EXPECT_EQ(route.size(), 1);
}

TEST(ChosenVehicleAndRoute, areAlreadyNewWhenTheChangeIsTold) {
  Selection selection;
  QString seen;
  QObject::connect(&selection, &Selection::routeChanged, [&] { seen = selection.route(); });
  selection.setRoute("south");
  EXPECT_EQ(seen, "south");
}

}  // namespace
}  // namespace tessera::ui
