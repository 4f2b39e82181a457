// What a route's fix promises, it does: the fault goes, and nothing worse comes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Route;
using floor::Site;
using floor::ZoneKind;
using testing::HasSubstr;

Site floorWithRoute(std::vector<Point> vertices) {
  Site site = goodFloor();
  site.routes = {{"r", std::move(vertices), Metres{0.2}}};
  return site;
}

Site mended(const Site& site, const Fault& fault) {
  Site after = site;
  EXPECT_TRUE(fault.fix && mend(fault.fix->edit, after)) << fault.sentence;
  return after;
}

// A hall with a pit and a lane in it, and routes that were drawn by a careless hand.
Site carelessSite(std::mt19937_64& random) {
  Site site = goodFloor();
  site.vehicles[0].maxTurnRate = RadiansPerSecond{0.1 * static_cast<double>(1 + random() % 15)};
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(random);
  };
  const double x = between(0.8, 1.8);
  const double y = between(0.6, 1.4);
  if (random() % 4 != 0) site.zones.push_back(zone("pit", ZoneKind::NoGo, rectangle(x, y, x + 0.3, y + 0.2)));
  site.zones.push_back(zone("lane", ZoneKind::OneWay, rectangle(0, 0, 3, between(0.4, 1.0))));
  site.zones.back().direction = Radians{random() % 2 == 0 ? 0.0 : kPi};
  if (random() % 3 == 0) site.zones.erase(site.zones.begin());
  site.routes.clear();
  for (int r = 0; r < 4; ++r) {
    std::vector<Point> vertices;
    Point place = at(between(0.2, 2.8), between(0.1, 2.3));
    double heading = between(-kPi, kPi);
    for (std::size_t n = 3 + random() % 5; n > 0; --n) {
      vertices.push_back(place);
      // Soft bends as well as sharp corners.
      heading += random() % 3 == 0 ? between(-2, 2) : between(-0.34, 0.34);
      const double way = between(0.1, 0.7);
      place = place + Offset{Metres{way * std::cos(heading)}, Metres{way * std::sin(heading)}};
    }
    site.routes.push_back({"R" + std::to_string(r), std::move(vertices), Metres{0.2}});
  }
  return site;
}

std::ptrdiff_t countAlike(const Faults& faults, const Fault& like) {
  return std::count_if(faults.begin(), faults.end(),
                       [&](const Fault& f) { return f.kind == like.kind && f.objects == like.objects; });
}

TEST(RouteFix, takesItsFaultAwayAndBringsNothingWorse) {
  std::array<int, kFaultKinds> fixes{};
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    std::mt19937_64 random{seed};
    const Site site = carelessSite(random);
    CheckOptions options;
    if (seed % 3 == 0) options.clearance = Metres{0.05};
    const Faults before = checkSite(site, options).faults();
    for (const Fault& fault : before) {
      if (!fault.fix) continue;
      const Faults after = checkSite(mended(site, fault), options).faults();
      EXPECT_LT(countAlike(after, fault), countAlike(before, fault)) << seed << ": " << fault.fix->sentence;
      for (const Fault& f : after)
        EXPECT_TRUE(f.severity <= fault.severity || countAlike(after, f) <= countAlike(before, f))
            << seed << ": " << fault.fix->sentence << " brings " << f.sentence;
      for (const Fault& f : after)
        EXPECT_TRUE(f.severity != Severity::Error || countAlike(after, f) <= countAlike(before, f))
            << seed << ": " << fault.fix->sentence << " brings " << f.sentence;
      ++fixes.at(static_cast<std::size_t>(fault.kind));
    }
  }
  for (const FaultKind kind : {FaultKind::RouteLeavesRunningZone, FaultKind::RouteCrossesNoGo,
                               FaultKind::RouteAgainstOneWay, FaultKind::RouteTooClose, FaultKind::RouteTooTight})
    EXPECT_GT(fixes.at(static_cast<std::size_t>(kind)), 8) << codeOf(kind);
}

TEST(RouteFix, slowsTheLegsOfATightBendAndNoOthers) {
  Site site = floorWithRoute({at(0.5, 1), at(1.0, 1), at(1.1, 1.02), at(1.2, 1.06), at(2.2, 1.46)});
  site.routes[0].legSpeeds = {MetresPerSecond{0.2}, {}, {}, MetresPerSecond{0.45}};
  site.vehicles[0].maxTurnRate = RadiansPerSecond{0.5};
  const auto faults = faultsOf(site, FaultKind::RouteTooTight);
  ASSERT_EQ(faults.size(), 1U);
  const Site after = mended(site, faults[0]);
  EXPECT_TRUE(faultsOf(after, FaultKind::RouteTooTight).empty());
  EXPECT_EQ(after.routes[0].legSpeeds[0], MetresPerSecond{0.2}) << "slow enough as it was";
  EXPECT_EQ(after.routes[0].legSpeeds[3], MetresPerSecond{0.45}) << "its end does not bend";
  EXPECT_LT(after.routes[0].legSpeeds[1], MetresPerSecond{0.5});
  EXPECT_EQ(after.routes[0].vertices, site.routes[0].vertices);
  site.vehicles[0].maxTurnRate = RadiansPerSecond{0.01};
  EXPECT_FALSE(faultsOf(site, FaultKind::RouteTooTight).at(0).fix) << "nobody wants it to creep";
}

TEST(RouteFix, reversesARouteThatRunsAgainstItsLaneUnlessAnotherLaneForbids) {
  Site site = floorWithRoute({at(0.5, 1), at(2.5, 1)});
  site.zones.push_back(zone("west", ZoneKind::OneWay, rectangle(0.6, 0.5, 1.2, 1.5)));
  site.zones.back().direction = Radians{kPi};
  const auto faults = faultsOf(site, FaultKind::RouteAgainstOneWay);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].fix->sentence.english(), "Reverse route \"r\"");
  const Site after = mended(site, faults[0]);
  EXPECT_EQ(after.routes[0].vertices.front(), at(2.5, 1));
  EXPECT_EQ(listOf(checkSite(after).faults()), "");
  site.zones.push_back(zone("east", ZoneKind::OneWay, rectangle(1.8, 0.5, 2.4, 1.5)));
  site.zones.back().direction = Radians{0.0};
  EXPECT_FALSE(faultsOf(site, FaultKind::RouteAgainstOneWay).at(0).fix);
}

TEST(RouteFix, movesVerticesToWhereThereIsRoom) {
  // One vertex 10 cm outside, where a vehicle of 36 cm needs 18 cm aside and more to turn.
  Site site = floorWithRoute({at(0.5, 1), at(2, 1), at(2, 2.5)});
  auto faults = faultsOf(site, FaultKind::RouteLeavesRunningZone);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0].fix->sentence.english(), HasSubstr("Move vertex 3 of route \"r\" by 0.37 m"));
  EXPECT_EQ(listOf(checkSite(mended(site, faults[0])).faults()), "") << "inside, and room for the vehicle at once";
  site = floorWithRoute({at(0.5, 0.1), at(2.5, 0.1)});
  faults = faultsOf(site, FaultKind::RouteTooClose);
  ASSERT_EQ(faults.size(), 1U);
  const Site after = mended(site, faults[0]);
  EXPECT_EQ(after.routes[0].vertices, (std::vector<Point>{at(0.5, 0.18), at(2.5, 0.18)})) << "no farther than needed";
  EXPECT_EQ(listOf(checkSite(after).faults()), "");
  site = floorWithRoute({at(0.5, 1), at(1.25, 1), at(1.25, 2)});
  site.zones.push_back(zone("pit", ZoneKind::NoGo, rectangle(1.2, 0.9, 1.5, 1.05)));
  faults = faultsOf(site, FaultKind::RouteCrossesNoGo);
  ASSERT_EQ(faults.size(), 1U);
  ASSERT_TRUE(faults[0].fix);
  EXPECT_TRUE(faultsOf(mended(site, faults[0]), FaultKind::RouteCrossesNoGo).empty());
}

TEST(RouteFix, isNotOfferedWhereItWouldBeAnotherRoute) {
  EXPECT_FALSE(faultsOf(floorWithRoute({at(1, 1), at(5, 1)}), FaultKind::RouteLeavesRunningZone).at(0).fix) << "2 m";
  Site site = floorWithRoute({at(0.5, 1), at(2.5, 1)});
  site.zones.push_back(zone("pit", ZoneKind::NoGo, rectangle(1.2, 0.5, 1.5, 1.5)));
  EXPECT_FALSE(faultsOf(site, FaultKind::RouteCrossesNoGo).at(0).fix) << "no vertex lies in it";
}

TEST(RouteFix, isLeftOutForARouteThatIsOnlyTried) {
  SiteChecker checker;
  checker.check(std::make_shared<const Site>(goodFloor()));
  const Faults faults = checker.tryRoute({"r", {at(0.5, 0.1), at(2.5, 0.1)}, Metres{0.2}});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_FALSE(faults[0].fix);
}

TEST(RouteFix, clearanceWantsThatMuchMoreRoom) {
  Site site = floorWithRoute({at(0.5, 0.2), at(2.5, 0.2)});
  EXPECT_EQ(listOf(checkSite(site).faults()), "");
  CheckOptions options;
  options.clearance = Metres{0.1};
  const Faults faults = checkSite(site, options).faults();
  ASSERT_EQ(faults.size(), 1U) << listOf(faults);
  EXPECT_EQ(faults[0].kind, FaultKind::RouteTooClose);
  EXPECT_THAT(faults[0].sentence.english(), HasSubstr("\"AGV 1\" with 0.10 m of room around it"));
  const Site after = mended(site, faults[0]);
  EXPECT_EQ(after.routes[0].vertices[0], at(0.5, 0.28));
  EXPECT_EQ(listOf(checkSite(after, options).faults()), "");
}

}  // namespace
}  // namespace tessera::sitecheck
