// The site is edited while its vehicles drive.
#include "supervisor/site_change.h"

#include <gtest/gtest.h>

#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

using test::SupervisorRig;

std::shared_ptr<const floor::SiteMap> edited(const floor::SiteMap& map, const std::function<void(floor::Site&)>& edit) {
  floor::Site site = map.site();
  edit(site);
  return floor::SiteMap::build(std::move(site)).value();
}

class SiteChange : public ::testing::Test {
protected:
  void use(const std::function<void(floor::Site&)>& edit) {
    rig.supervisor.post(UseSite{edited(*rig.map, edit)});
    rig.run(Seconds{0.1});
  }
  SupervisorRig rig;
};

TEST_F(SiteChange, aNewRouteCanBeRunAtOnceAndARunningOneGoesOnAsItWasGiven) {
  rig.runRoute(1, "paper", 0.2);
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed > 0.15; }, Seconds{10}));
  const Metres length = rig.view(1).length;
  use([](floor::Site& s) {
    s.routes[0].vertices.resize(2);
    s.routes.push_back(s.routes[0]);
    s.routes[1].name = "short";
  });
  rig.run(Seconds{1});
  EXPECT_TRUE(rig.view(1).located);
  EXPECT_GT(rig.vehicle(1).speed, 0.15) << "not for a moment disturbed";
  EXPECT_EQ(rig.view(1).length, length);
  rig.runRoute(1, "short", 0.2);
  rig.run(Seconds{1});
  EXPECT_TRUE(rig.told(EventKind::OrderRefused).empty());
  EXPECT_LT(rig.view(1).length, length);
}

TEST_F(SiteChange, tagsThatLieElsewhereAreUsedFromWhereTheVehicleIs) {
  rig.runRoute(1, "paper", 0.15);
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).reads > 10; }, Seconds{30}));
  const Pose before = rig.view(1).pose;
  use([](floor::Site& s) { s.placements.pop_back(); });
  EXPECT_TRUE(rig.view(1).located);
  EXPECT_LT(distance(before.position, rig.view(1).pose.position).value(), 0.05);
  EXPECT_TRUE(rig.runUntil([&] { return rig.view(1).finished; }, Seconds{120})) << rig.view(1).doing;
  EXPECT_TRUE(rig.told(EventKind::Lost).empty());
}

TEST_F(SiteChange, tagsAreRegisteredOneAfterAnotherAndAVehicleThatDrivesMeanwhileKeepsWhatItHasLearned) {
  rig.runRoute(1, "paper", 0.15);
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).reads > 10; }, Seconds{30}));
  floor::LooseTag tag{floor::TagUid::parse("04A1B2C3D4E5F6").value(), {Metres{5.0}, Metres{5.0}}};
  Metres worst;
  for (int i = 0; !rig.view(1).finished && i < 600; ++i) {
    use([&](floor::Site& s) {
      if (i % 2 == 0) s.looseTags.push_back(tag);
    });
    rig.run(Seconds{0.1});
    worst = std::max(worst, distance(rig.view(1).pose.position, rig.vehicle(1).pose.position));
  }
  EXPECT_TRUE(rig.view(1).finished) << rig.view(1).doing;
  EXPECT_TRUE(rig.told(EventKind::Lost).empty());
  EXPECT_LT(worst.value(), 0.05);
}

TEST_F(SiteChange, aTagThatTheSiteGetsIsKnownFromThenOn) {
  floor::LooseTag tag{floor::TagUid::parse("04A1B2C3D4E5F6").value(), {}};
  wire::TagEvent seen;
  seen.kind = wire::EventKind::Uid7;
  std::copy(tag.uid.bytes().begin(), tag.uid.bytes().end(), seen.uid.begin());
  rig.run(Seconds{2});
  rig.vehicle(1).fake.note(seen, rig.air->now);
  ASSERT_TRUE(rig.runUntil([&] { return !rig.told(EventKind::UnknownTag).empty(); }, Seconds{2}));
  ASSERT_FALSE(rig.view(1).recentReads.empty());
  EXPECT_EQ(rig.view(1).recentReads.back().uid, tag.uid);
  EXPECT_EQ(rig.view(1).recentReads.back().place, std::nullopt);
  tag.place = rig.vehicle(1).pose.position;
  use([&](floor::Site& s) { s.looseTags.push_back(tag); });
  rig.vehicle(1).fake.note(seen, rig.air->now);
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).recentReads.back().place.has_value(); }, Seconds{2}));
  EXPECT_EQ(rig.view(1).recentReads.back().place, tag.place);
  EXPECT_EQ(rig.told(EventKind::UnknownTag).size(), 1U);
}

TEST_F(SiteChange, anotherNameIsTakenOver) {
  use([](floor::Site& s) { s.vehicles[0].name = "Rosinante"; });
  EXPECT_EQ(rig.view(1).name, "Rosinante");
}

TEST_F(SiteChange, otherVehiclesOrAnotherRadioAreRefused) {
  using Edit = std::function<void(floor::Site&)>;
  const std::vector<Edit> edits{
      [](floor::Site& s) { s.vehicles[0].key[3] ^= 1; },
      [](floor::Site& s) { s.vehicles[0].id = VehicleId{9}; },
      [](floor::Site& s) { s.vehicles[0].readers[0].x += Metres{0.01}; },
      [](floor::Site& s) { s.vehicles.clear(); },
      [](floor::Site& s) { s.radio.channel += 1; },
  };
  for (const Edit& edit : edits) use(edit);
  rig.supervisor.post(UseSite{});
  rig.run(Seconds{0.1});
  const auto refused = rig.told(EventKind::OrderRefused);
  ASSERT_EQ(refused.size(), edits.size() + 1);
  for (const Event& e : refused)
    EXPECT_EQ(e.sentence,
              "The site's vehicles or its radio have changed: supervision must be restarted to take them over.");
}

TEST_F(SiteChange, aTurnedNorthTurnsTheReportedHeading) {
  rig.run(Seconds{2});
  const Radians before = rig.view(1).heading;
  EXPECT_NEAR(turnBetween(before, rig.vehicle(1).pose.heading).value(), 0.0, 0.01);
  use([](floor::Site& s) { s.northToY += Radians{0.5}; });
  EXPECT_NEAR(std::abs(turnBetween(before, rig.view(1).heading).value()), 0.5, 0.01);
}

TEST(RecentReads, areTheLastOnesWithTheirPlacesOldestFirst) {
  SupervisorRig rig;
  rig.runRoute(1, "paper", 0.2);
  ASSERT_TRUE(rig.runUntil([&] { return rig.last && rig.view(1).reads > 20; }, Seconds{60}));
  const VehicleView& view = rig.view(1);
  EXPECT_EQ(view.recentReads.size(), kRecentReads);
  EXPECT_LT(view.recentReads.front().at, view.recentReads.back().at);
  for (const ReadView& read : view.recentReads) {
    EXPECT_EQ(read.place, rig.map->find(read.uid));
    EXPECT_LT(read.reader, rig.map->site().vehicles[0].readers.size());
  }
}

}  // namespace
}  // namespace tessera::supervisor
