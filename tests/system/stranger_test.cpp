// Vehicles that others wrote in another language from docs/protocol.md alone meet the supervisor and its serial port:
// they are identified and located by the tags that they tell of.
#include <gtest/gtest.h>

#include <algorithm>

#include "floor/bearing.h"
#include "floor/site_map.h"
#include "system/program.h"
#include "system/pty_bridge.h"
#include "system/supervision.h"

namespace tessera::system_test {
namespace {

using supervisor::EventKind;

const std::string kSite = TESSERA_SYSTEM_TEST "/corner.tessera.json";

class StrangersVehicle : public ::testing::TestWithParam<const char*> {};

TEST_P(StrangersVehicle, isIdentifiedAndLocatedByItsTags) {
  const auto map = Supervision::mapOf(kSite);
  const floor::VehicleSetup& setup = map->site().vehicles.front();
  // It stands with its middle reader on the tag that is farthest from where the site lets the vehicle start.
  const auto& tag = *std::max_element(map->tags().begin(), map->tags().end(), [&](const auto& a, const auto& b) {
    return distance(a.place, setup.start->position) < distance(b.place, setup.start->position);
  });
  const Radians heading = fromDegrees(30);
  const Point place = tag.place - turned(setup.readers[1], heading);
  std::string key;
  for (const std::uint8_t byte : setup.key) {
    key += "0123456789ABCDEF"[byte >> 4];
    key += "0123456789ABCDEF"[byte & 15];
  }
  const double bearing = degrees(floor::bearingOfHeading(heading, map->site().northToY));

  PtyBridge bridge;
  Program vehicle{TESSERA_PYTHON,
                  {std::string{TESSERA_STRANGERS "/"} + GetParam(), bridge.path(0), std::to_string(setup.id.value), key,
                   std::to_string(bearing), "1:" + tag.uid.text()}};
  Supervision supervision{kSite, bridge.path(1)};
  EXPECT_TRUE(supervision.hears(EventKind::Identified)) << supervision.sentences() << vehicle.errors();
  EXPECT_TRUE(supervision.hears(EventKind::Located)) << supervision.sentences() << vehicle.errors();
  // The site's start is not where it stands; only the tag can tell.
  ASSERT_GT(distance(setup.start->position, place), Metres{0.5});
  EXPECT_TRUE(supervision.until([&] {
    const auto seen = supervision.view();
    return seen.located && distance(seen.pose.position, place) < setup.readerRadius;
  }));
  const auto view = supervision.view();
  EXPECT_NEAR(degrees(wrapped(view.pose.heading - heading)), 0.0, 1.0);
  EXPECT_EQ(view.reads, 1U);
  EXPECT_TRUE(supervision.until([&] { return supervision.view().link.reports > 10; })) << "and stays in touch";
  EXPECT_EQ(supervision.view().link.forged + supervision.view().link.replayed, 0U);
  EXPECT_TRUE(vehicle.running()) << vehicle.errors();
}

INSTANTIATE_TEST_SUITE_P(Python, StrangersVehicle, ::testing::Values("protocol_vehicle.py", "twenty_lines.py"),
                         [](const auto& tried) {
                           const std::string name = tried.param;
                           return name == "twenty_lines.py" ? "ofTwentyLines" : "ofTheWholeProtocol";
                         });

}  // namespace
}  // namespace tessera::system_test
