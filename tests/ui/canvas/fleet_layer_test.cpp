#include "ui/canvas/fleet_layer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

Point spot(double x, double y) { return {Metres{x}, Metres{y}}; }

TEST(PoseAfter, GoesStraightOnForATenthOfASecondAndNoFartherThanAFifth) {
  supervisor::VehicleView v = vehicleAt(1, 2.0, 1.0, kPi / 2);
  v.speed = MetresPerSecond{0.5};
  EXPECT_NEAR(poseAfter(v, Seconds{0.1}).position.y.value(), 1.05, 1e-9);
  EXPECT_NEAR(poseAfter(v, Seconds{0.1}).position.x.value(), 2.0, 1e-9);
  EXPECT_NEAR(poseAfter(v, Seconds{5.0}).position.y.value(), 1.10, 1e-9);
  EXPECT_NEAR(poseAfter(v, Seconds{-1.0}).position.y.value(), 1.0, 1e-9);
}

TEST(PoseAfter, StaysWhenTheReportIsOldOrTheVehicleSilent) {
  supervisor::VehicleView v = vehicleAt(1, 2.0, 1.0);
  v.speed = MetresPerSecond{0.5};
  v.link.age = Seconds{3.0};
  EXPECT_EQ(poseAfter(v, Seconds{0.1}), v.pose);
  v.link.age = Seconds{0.1};
  v.contact = supervisor::Contact::Silent;
  EXPECT_EQ(poseAfter(v, Seconds{0.1}), v.pose);
}

TEST(LookOf, TellsTheWorstFirst) {
  supervisor::VehicleView v = vehicleAt(1, 0, 0);
  EXPECT_EQ(lookOf(v), VehicleLook::Fine);
  v.waits = "It waits.";
  EXPECT_EQ(lookOf(v), VehicleLook::Waiting);
  v.task = supervisor::Task::Paused;
  EXPECT_EQ(lookOf(v), VehicleLook::Paused);
  v.state = wire::VehicleState::Obstacle;
  EXPECT_EQ(lookOf(v), VehicleLook::Obstacle);
  v.state = wire::VehicleState::Faulted;
  EXPECT_EQ(lookOf(v), VehicleLook::Fault);
  v.contact = supervisor::Contact::Silent;
  EXPECT_EQ(lookOf(v), VehicleLook::Silent);
}

TEST(Trail, KeepsAMinuteAndFewPoints) {
  Trail trail;
  for (int n = 0; n <= 6000; ++n) trail.add(spot(0.01 * n, 0.0), Seconds{0.02 * n});
  // 120 s at 0.5 m/s: 30 m of the last minute, a point every 3 or 4 cm.
  EXPECT_GE(trail.size(), 750U);
  EXPECT_LE(trail.size(), 1001U);
  View view{{1000, 600}, 1.0};
  view.setScale(10.0);
  view.centreOn(spot(45.0, 0.0));
  qsizetype points = 0;
  for (const Trail::Piece& piece : trail.pieces(view, Seconds{120.0}, 6)) points += piece.line.size();
  EXPECT_LT(points, 300);
  EXPECT_GT(points, 6);
}

TEST(Trail, BeginsANewPieceAfterALeapAndAfterALoss) {
  Trail trail;
  const View view{{1000, 600}, 1.0};
  trail.add(spot(0, 0), Seconds{0});
  trail.add(spot(0.5, 0), Seconds{1});
  trail.add(spot(3.0, 0), Seconds{2});  // lifted and set down
  trail.add(spot(3.5, 0), Seconds{3});
  trail.interrupt();
  trail.add(spot(3.9, 0), Seconds{4});
  trail.add(spot(4.2, 0), Seconds{5});
  EXPECT_EQ(trail.pieces(view, Seconds{5}, 1).size(), 3U);
  trail.add(spot(0, 0), Seconds{1});  // time ran back: another run
  EXPECT_EQ(trail.size(), 1U);
}

TEST(Trail, TellsWhatCameSinceATimeAndKeepsPiecesApart) {
  Trail trail;
  const View view{{400, 300}, 1.0};
  for (int n = 0; n < 5; ++n) trail.add({Metres{0.1 * n}, {}}, Seconds{1.0 * n});
  trail.interrupt();
  for (int n = 5; n < 8; ++n) trail.add({Metres{0.1 * n}, {}}, Seconds{1.0 * n});
  EXPECT_EQ(trail.last(), Seconds{7});
  const auto lines = trail.since(view, Seconds{2.5});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].size(), 3) << "from the last older point on";
  EXPECT_EQ(lines[1].size(), 3) << "no line across the gap";
  EXPECT_TRUE(trail.since(view, Seconds{7}).empty());
  EXPECT_TRUE(Trail{}.since(view, Seconds{}).empty());
}

TEST(FleetLayer, FlashesEachReadOnceWhereItsTagLies) {
  FleetLayer layer;
  supervisor::VehicleView v = vehicleAt(1, 0, 0);
  v.recentReads.push_back({{}, 0, Seconds{10.0}, spot(1, 2)});
  v.recentReads.push_back({{}, 0, Seconds{10.1}, std::nullopt});  // a tag that the site does not have
  layer.setSnapshot(snapshotOf(10.1, {v}));
  ASSERT_EQ(layer.flashes().size(), 1U);
  EXPECT_EQ(layer.flashes()[0].place, spot(1, 2));
  layer.setSnapshot(snapshotOf(10.2, {v}));
  EXPECT_EQ(layer.flashes().size(), 1U);
  EXPECT_TRUE(layer.advance(Seconds{0.1}));
  EXPECT_FALSE(layer.advance(Seconds{0.5}));
  EXPECT_TRUE(layer.flashes().empty());
}

TEST(FleetLayer, ForgetsReadsThatAreLongPastThoughNoFrameIsDrawn) {
  FleetLayer layer;
  supervisor::VehicleView v = vehicleAt(1, 0, 0);
  for (int n = 0; n < 100; ++n) {
    v.recentReads = {{{}, 0, Seconds{0.1 * n}, spot(1, 2)}};
    layer.setSnapshot(snapshotOf(0.1 * n, {v}));
  }
  EXPECT_LE(layer.flashes().size(), 6U);
  layer.setSnapshot(nullptr);
  EXPECT_TRUE(layer.flashes().empty());
}

TEST(FleetLayer, RestsWhenNothingMoves) {
  FleetLayer layer;
  supervisor::VehicleView v = vehicleAt(1, 0, 0);
  layer.setSnapshot(snapshotOf(1.0, {v}));
  EXPECT_FALSE(layer.advance(Seconds{0.0}));
  v.speed = MetresPerSecond{0.2};
  layer.setSnapshot(snapshotOf(1.1, {v}));
  EXPECT_TRUE(layer.advance(Seconds{0.0}));
  EXPECT_FALSE(layer.advance(Seconds{1.0}));  // no snapshot came for too long
}

}  // namespace
}  // namespace tessera::ui
