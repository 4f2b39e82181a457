// What either filter has to bear: to be carried, to be put down elsewhere than it is told, a map that is wrong.
#include "locate/filters.h"

#include <gtest/gtest.h>

#include "locate/synthetic_drive.h"

namespace tessera::test {
namespace {

struct Filter {
  const char* name;
  std::unique_ptr<locate::Locator> (*make)(const std::shared_ptr<const floor::SiteMap>&, std::optional<Pose>);
};

std::ostream& operator<<(std::ostream& to, const Filter& filter) { return to << filter.name; }

class EitherFilter : public testing::TestWithParam<Filter> {};

INSTANTIATE_TEST_SUITE_P(
    Of, EitherFilter,
    testing::Values(Filter{"kalman", [](const auto& map, std::optional<Pose> start) { return kalman(map, start); }},
                    Filter{"particles",
                           [](const auto& map, std::optional<Pose> start) -> std::unique_ptr<locate::Locator> {
                             return particles(map, start);
                           }}),
    [](const auto& filter) { return filter.param.name; });

TEST_P(EitherFilter, findsItselfAgainAfterBeingCarried) {
  const auto map = paperMap();
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.carriedAt = 5.0;
    options.speedNoise = 0.05;
    const auto locator = GetParam().make(map, std::nullopt);
    const auto samples = drive(*map, paperVehicle(), map->route("paper")->vertices, options, *locator);
    const ErrorSummary last = summarise(samples, samples.back().at - 3.0);
    EXPECT_LT(last.mean, 0.025) << "seed " << seed;
    EXPECT_EQ(last.locatedShare, 1.0) << "seed " << seed;
    EXPECT_GE(locator->counters().reacquisitions, 2U) << "the first one is the start's";
  }
}

TEST_P(EitherFilter, findsItselfAfterAWrongStart) {
  const auto map = paperMap();
  for (const Point wrong :
       {Point{Metres{0.6}, Metres{0.3}}, Point{Metres{0.3}, Metres{0.7}}, Point{Metres{1.5}, Metres{1.5}}}) {
    const auto locator = GetParam().make(map, Pose{wrong, Radians{kPi / 2}});
    const auto samples = drive(*map, paperVehicle(), map->route("paper")->vertices, {}, *locator);
    EXPECT_LT(summarise(samples, 5.0).mean, 0.02) << wrong.x.value() << ", " << wrong.y.value();
  }
}

TEST_P(EitherFilter, isNotLedAstrayByTagsThatLieElsewhereThanTheMapSays) {
  floor::Site site = paperSite();
  for (std::size_t i = 0; i + 1 < site.tiles.size(); i += 2)
    std::swap(site.tiles[i].uids[3], site.tiles[i + 1].uids[5]);
  const auto wrong = floor::SiteMap::build(site).value();
  const auto right = paperMap();
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    DriveOptions options;
    options.seed = seed;
    const auto locator = GetParam().make(wrong, std::nullopt);
    const ErrorSummary e =
        summarise(drive(*right, paperVehicle(), right->route("paper")->vertices, options, *locator), 5.0);
    EXPECT_LT(e.mean, 0.025) << "seed " << seed;
    EXPECT_GT(locator->counters().rejected, 0U);
  }
}

TEST_P(EitherFilter, tellsWhatItDoesNotKnowOfItsScaleToWhoeverRollsItOn) {
  const auto locator = GetParam().make(paperMap(), Pose{{Metres{0.3}, Metres{0.3}}, Radians{0.0}});
  double way = 0.0;
  for (int i = 0; i <= 50; ++i, way = 0.01 * i)
    locator->add(locate::Motion{Seconds{0.1 * i}, Metres{way}, MetresPerSecond{0.1}, Radians{0.0}});
  const locate::Estimate e = locator->at(Seconds{5.0});
  // It has driven half a metre without a tag: by as much as its scale is off it is too far already, but for what of
  // the scale wandered.
  EXPECT_GT(e.scale(3), 1e-4);
  EXPECT_GT(e.scale(0), 0.2 * e.scale(3));
  EXPECT_LT(e.scale(0), 0.6 * e.scale(3));
  EXPECT_NEAR(e.scale(1), 0.0, 0.1 * e.scale(3));
}

}  // namespace
}  // namespace tessera::test
