// Sites go through their files and come back as they were.
#include "floor/site_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "base/polyline.h"
#include "floor/random_site.h"
#include "floor/site_map.h"

namespace tessera::floor {
namespace {

std::string bytesOf(const std::string& path) {
  std::ifstream in{path, std::ios::binary};
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

std::string resource(const std::string& name) { return TESSERA_SITES "/" + name + ".tessera.json"; }

// A few computed angles have no decimal of degrees: they may come back one bit off.
void roundOff(Radians& angle, Radians like) {
  if (abs(angle - like).value() < 2e-15) angle = like;
}

Site withAnglesOf(Site site, const Site& like) {
  roundOff(site.northToY, like.northToY);
  for (std::size_t i = 0; i < std::min(site.zones.size(), like.zones.size()); ++i) {
    if (site.zones[i].direction && like.zones[i].direction)
      roundOff(*site.zones[i].direction, *like.zones[i].direction);
  }
  for (std::size_t i = 0; i < std::min(site.vehicles.size(), like.vehicles.size()); ++i) {
    if (site.vehicles[i].start && like.vehicles[i].start)
      roundOff(site.vehicles[i].start->heading, like.vehicles[i].start->heading);
  }
  if (site.backdrop && like.backdrop) roundOff(site.backdrop->turn, like.backdrop->turn);
  return site;
}

TEST(SiteJson, anySiteComesBackAsItWas) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Site site = randomSite(seed);
    const std::string text = writeSite(site);
    const auto back = parseSite(text, "random");
    ASSERT_TRUE(back) << seed << ": " << back.error().sentence << "\n" << text;
    ASSERT_EQ(withAnglesOf(*back, site), site) << seed << "\n" << text;
    ASSERT_EQ(writeSite(*back), text) << seed;
  }
}

TEST(SiteJson, everyAngleIsWrittenSoThatItsBytesStay) {
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> angle{-6.28, 6.28};
  for (int i = 0; i < 3000; ++i) {
    Site site;
    site.name = "angles";
    site.northToY = Radians{angle(random)};
    const std::string text = writeSite(site);
    const auto back = parseSite(text, "angles");
    ASSERT_TRUE(back);
    ASSERT_NEAR(back->northToY.value(), site.northToY.value(), 2e-15);
    ASSERT_EQ(writeSite(*back), text);
  }
}

TEST(SiteJson, numbersReadAsPeopleWriteThem) {
  Site site;
  site.name = "numbers";
  site.northToY = fromDegrees(20);
  site.looseTags = {{*TagUid::parse("04000001"), {Metres{0.15}, Metres{-0.0}}},
                    {*TagUid::parse("04000002"), {Metres{0.1 + 0.2}, Metres{12345.5}}}};
  const std::string text = writeSite(site);
  EXPECT_NE(text.find("\"north_to_y_deg\": 20,"), std::string::npos) << text;
  EXPECT_NE(text.find("\"x_m\": 0.15, \"y_m\": 0}"), std::string::npos) << text;
  EXPECT_NE(text.find("\"x_m\": 0.30000000000000004, \"y_m\": 12345.5}"), std::string::npos) << text;
  EXPECT_NE(text.find("\"air_rate_bps\": 19200,"), std::string::npos) << text;
}

TEST(SiteJson, legSpeedsAreWrittenOnlyWhereThereAreSome) {
  Site site;
  site.name = "legs";
  site.routes = {{"r", {{}, {Metres{1}, {}}, {Metres{2}, {}}}, Metres{0.2}}};
  EXPECT_EQ(writeSite(site).find("leg_speeds"), std::string::npos);
  const std::string plain = writeSite(site);
  site.routes[0].legSpeeds = {std::nullopt, MetresPerSecond{0.1}};
  const std::string text = writeSite(site);
  EXPECT_NE(text.find("\"leg_speeds_mps\": [null, 0.1]}"), std::string::npos) << text;
  EXPECT_EQ(parseSite(text, "legs").value(), site);
  // None at all by many words is none at all.
  std::string wordy = text;
  wordy.replace(wordy.find("[null, 0.1]"), 11, "[null, null]");
  EXPECT_TRUE(parseSite(wordy, "legs").value().routes[0].legSpeeds.empty());
  EXPECT_EQ(writeSite(parseSite(wordy, "legs").value()), plain);
}

TEST(SiteJson, cutsOfCornersAreWrittenOnlyWhereThereAreSome) {
  Site site;
  site.name = "corners";
  site.vehicles.resize(1);
  VehicleSetup& vehicle = site.vehicles[0];
  vehicle.id = VehicleId{1};
  vehicle.name = "v";
  vehicle.readers = {{}};
  vehicle.footprint = {{}, {Metres{1}, {}}, {{}, Metres{1}}};
  EXPECT_EQ(writeSite(site).find("corner_cut"), std::string::npos);
  EXPECT_EQ(parseSite(writeSite(site), "corners").value(), site);
  vehicle.cornerCut = Metres{0.05};
  const std::string text = writeSite(site);
  EXPECT_NE(text.find(", \"corner_cut_m\": 0.05"), std::string::npos) << text;
  EXPECT_EQ(parseSite(text, "corners").value(), site);
}

TEST(SiteJson, leftOutKeysTakeTheirDefaults) {
  const auto site = parseSite(R"({"format": "tessera-site", "version": 1, "name": "n",
    "tile_types": [{"name": "t", "width_m": 0.6, "height_m": 0.6, "pitch_m": 0.15, "columns": 4, "rows": 4, "pattern": "full"}],
    "routes": [{"name": "r", "vertices_m": [[0, 0], [1, 0]]}],
    "vehicles": [{"id": 1, "name": "v", "key": "000102030405060708090a0b0c0d0e0f", "readers_m": [[0, 0]],
                  "footprint_m": [[0, 0], [1, 0], [0, 1]]}]})",
                              "short");
  ASSERT_TRUE(site) << site.error().sentence;
  EXPECT_EQ(site->radio, RadioSetup{});
  EXPECT_EQ(site->northToY, Radians{});
  EXPECT_EQ(site->tileTypes[0].margin, (Offset{Metres{0.075}, Metres{0.075}}));
  EXPECT_EQ(site->routes[0].controlSpacing, Route{}.controlSpacing);
  VehicleSetup expected;
  EXPECT_EQ(site->vehicles[0].track, expected.track);
  EXPECT_EQ(site->vehicles[0].maxTurnRate, expected.maxTurnRate);
  EXPECT_EQ(site->vehicles[0].key[15], 0x0F);
  EXPECT_FALSE(site->vehicles[0].start);
  EXPECT_EQ(site->vehicles[0].cornerCut, Metres{}) << "it turns on the spot";
}

TEST(SiteJson, theSitesThatComeWithTheProgramKeepTheirBytes) {
  for (const char* name : {"paper", "three"}) {
    const auto site = loadSite(resource(name));
    ASSERT_TRUE(site) << site.error().sentence;
    EXPECT_EQ(writeSite(*site), bytesOf(resource(name))) << name;
    EXPECT_TRUE(SiteMap::build(*site)) << name;
  }
}

TEST(SiteJson, thePublicationsFloorIsTheOneDescribed) {
  const auto site = loadSite(resource("paper"));
  ASSERT_TRUE(site);
  const auto map = *SiteMap::build(*site);
  EXPECT_EQ(map->tags().size(), 72U) << "nine tiles of eight tags";
  for (const PlacedTag& t : map->tags()) {
    const double column = (t.place.x.value() - 0.075) / 0.15;
    const double row = (t.place.y.value() - 0.075) / 0.15;
    ASSERT_NEAR(column, std::round(column), 1e-9);
    ASSERT_EQ(std::lround(column + row) % 2, 0) << "the checkerboard goes on across the seams";
  }
  const Route* route = map->route("paper");
  ASSERT_NE(route, nullptr);
  EXPECT_DOUBLE_EQ(Polyline{route->vertices}.length().value(), 4.8);
  const VehicleSetup* vehicle = map->vehicle(VehicleId{1});
  ASSERT_NE(vehicle, nullptr);
  EXPECT_EQ(vehicle->readers.size(), 3U);
  EXPECT_EQ(vehicle->start->position, route->vertices.front());
}

TEST(SiteJson, aPictureComesBackWithEveryByteAndItsPlace) {
  std::string bytes = "\x89PNG\r\n\x1A\n";
  for (int n = 0; n < 1000; ++n) bytes += static_cast<char>(n % 256);
  Site site;
  site.name = "hall";
  EXPECT_EQ(writeSite(site).find("backdrop"), std::string::npos) << "files without one stay as they were";
  site.backdrop = Backdrop{"Halle 3.png",
                           std::make_shared<const std::string>(bytes),
                           {Metres{-1.5}, Metres{2}},
                           Metres{0.02},
                           fromDegrees(30),
                           0.25};
  const std::string text = writeSite(site);
  EXPECT_NE(text.find("\"backdrop\": {\"file\": \"Halle 3.png\", \"origin_m\": [-1.5, 2], \"metres_per_pixel\": 0.02, "
                      "\"turn_deg\": 30, \"opacity\": 0.25,\n    \"picture\": \"iVBORw0KGgo"),
            std::string::npos)
      << text;
  const auto back = parseSite(text, "hall");
  ASSERT_TRUE(back) << back.error().sentence;
  EXPECT_EQ(*back, site);
  EXPECT_EQ(*back->backdrop->picture, bytes);
}

TEST(SiteJson, theThreeRoutesKeepApart) {
  const auto site = loadSite(resource("three"));
  ASSERT_TRUE(site);
  ASSERT_EQ(site->routes.size(), 3U);
  for (std::size_t a = 0; a < 3; ++a) {
    const Polyline line{site->routes[a].vertices};
    for (std::size_t b = 0; b < 3; ++b) {
      const Polyline other{site->routes[b].vertices};
      for (Metres along; a != b && along < line.length(); along += Metres{0.01}) {
        ASSERT_GE(abs(other.project(line.at(along)).across), Metres{0.8});
      }
    }
  }
}

}  // namespace
}  // namespace tessera::floor
