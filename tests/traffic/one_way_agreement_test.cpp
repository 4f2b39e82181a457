// What the site's check calls the wrong way is what an order is refused for: each works it out for itself, as neither
// may know of the other.
#include <gtest/gtest.h>

#include "base/angle.h"
#include "drive/driven_way.h"
#include "sitecheck/sites.h"
#include "traffic/zone_map.h"

namespace tessera::traffic {
namespace {

class OneWaySites {
public:
  explicit OneWaySites(std::uint64_t seed) : random_{seed} {}

  floor::Site next() {
    floor::Site site = sitecheck::goodFloor();
    site.routes[0].vertices.clear();
    for (int n = whole(2, 7); n > 0; --n)
      site.routes[0].vertices.push_back({Metres{onGrid(6, 54)}, Metres{onGrid(6, 42)}});
    for (int n = whole(1, 3); n > 0; --n) {
      site.zones.push_back(
          sitecheck::zone("lane " + std::to_string(n), floor::ZoneKind::OneWay, outlineNear(site.routes[0].vertices)));
      site.zones.back().direction = fromDegrees(whole(-180, 180));
    }
    site.vehicles[0].cornerCut = Metres{0.05 * whole(0, 4)};
    return site;
  }

private:
  // Half of them are small and within a corner, where only who rounds it comes through.
  std::vector<Point> outlineNear(const std::vector<Point>& vertices) {
    const auto of = [&](int i) { return vertices[static_cast<std::size_t>(i) % vertices.size()]; };
    const int corner = whole(1, static_cast<int>(vertices.size()));
    const bool small = whole(0, 1) == 0;
    const Offset inwards = of(corner - 1) - of(corner) + (of(corner + 1) - of(corner));
    const double size = small ? 0.01 : 0.05;
    const Point low = small ? of(corner) + 0.01 * whole(1, 20) * inwards
                            : of(corner) + Offset{Metres{onGrid(-20, 20)}, Metres{onGrid(-20, 20)}};
    return {low, low + Offset{Metres{size * whole(1, 20)}, Metres{}},
            low + Offset{Metres{size * whole(0, 20)}, Metres{size * whole(1, 20)}}};
  }
  int whole(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double onGrid(int low, int high) { return 0.05 * whole(low, high); }
  std::mt19937_64 random_;
};

bool isRefused(const floor::Site& site) {
  const ZoneMap zones{site.zones};
  const floor::Route& route = site.routes[0];
  const RoundedLine way = drive::drivenWay(route, drive::abilityOf(site.vehicles[0]));
  return zones.wrongWay(Polyline{route.vertices}) || zones.wrongWay(way.line());
}

TEST(OneWayZones, areJudgedAlikeByTheSitesCheckAndByWhoTakesOrders) {
  OneWaySites sites{1};
  int refused = 0;
  int onlyRoundACorner = 0;
  constexpr int kSites = 800;
  for (int i = 0; i < kSites; ++i) {
    const floor::Site site = sites.next();
    if (Polyline{site.routes[0].vertices}.legCount() == 0) continue;
    const auto faults = faultsOf(site, sitecheck::FaultKind::RouteAgainstOneWay);
    ASSERT_EQ(!faults.empty(), isRefused(site)) << "site " << i << "\n" << sitecheck::listOf(faults);
    if (faults.empty()) continue;
    ++refused;
    const bool drawnIsRight = !ZoneMap{site.zones}.wrongWay(Polyline{site.routes[0].vertices});
    onlyRoundACorner += drawnIsRight ? 1 : 0;
  }
  EXPECT_GT(refused, kSites / 10);
  EXPECT_LT(refused, kSites - kSites / 10);
  EXPECT_GT(onlyRoundACorner, 5) << "of those that are right as drawn and wrong as driven";
}

}  // namespace
}  // namespace tessera::traffic
