#include "exchange/lif.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "floor/route_legs.h"
#include "floor/site_json.h"
#include "sitecheck/sites.h"

namespace tessera::exchange {
namespace {

using floor::Site;
using floor::ZoneKind;
using sitecheck::at;
using sitecheck::goodFloor;
using testing::HasSubstr;

const std::string kTime = "2026-11-22T08:00:00Z";

std::string goldenLayout() {
  std::ifstream in{std::string{TESSERA_GOLDEN} + "/paper.lif.json", std::ios::binary};
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

std::string allOf(const std::vector<Sentence>& sentences) {
  std::string s;
  for (const Sentence& sentence : sentences) s += sentence.english() + "\n";
  return s;
}

TEST(Lif, ofTheDemoFloorIsTheOneThatIsKept) {
  Site site = floor::loadSite(std::string{TESSERA_SITES} + "/paper.tessera.json").value();
  site.zones.push_back(sitecheck::zone("P1", ZoneKind::Parking, sitecheck::rectangle(0.1, 0.1, 0.5, 0.5)));
  site.zones.push_back(sitecheck::zone("slow", ZoneKind::Slow, sitecheck::rectangle(0.8, 0.1, 1, 1)));
  site.zones.back().speed = MetresPerSecond{0.2};
  const LifText lif = writeLif(site, kTime);
  EXPECT_EQ(lif.text, goldenLayout());
  EXPECT_THAT(allOf(lif.leftOut), HasSubstr("with their tags: 9"));
  EXPECT_THAT(allOf(lif.leftOut), Not(HasSubstr("picture")));
  site.backdrop = floor::Backdrop{"hall.png", std::make_shared<const std::string>("bytes"), {}, {}, {}, 0.5};
  EXPECT_THAT(allOf(writeLif(site, kTime).leftOut), HasSubstr("LIF carries no picture of the floor plan"));
}

TEST(Lif, anImportOntoItselfChangesNothing) {
  std::mt19937_64 random{6};
  for (int round = 0; round < 200; ++round) {
    Site site = goodFloor();
    site.routes.push_back({"via/2", {at(1, 1), at(1, 1), at(2, 1), at(1, 1)}, Metres{0.5}});
    for (int i = 0; i < 5; ++i) sitecheck::editAtRandom(site, random);
    if (!floor::SiteMap::build(site)) continue;
    const auto preview = importLif(site, writeLif(site, kTime).text, "f.lif");
    ASSERT_TRUE(preview) << preview.error().sentence;
    ASSERT_EQ(preview->site, site) << round;
    ASSERT_TRUE(preview->changes.empty());
  }
}

TEST(Lif, legSpeedsComeBackWhateverElseIsAsSlow) {
  Site site = goodFloor();
  site.vehicles.push_back(site.vehicles[0]);
  site.vehicles.back().id = VehicleId{2};
  site.vehicles.back().name = "slow";
  site.vehicles.back().maxSpeed = MetresPerSecond{0.3};
  site.zones.push_back(sitecheck::zone("slow", ZoneKind::Slow, sitecheck::rectangle(2.4, 1, 2.8, 1.5)));
  site.zones.back().speed = MetresPerSecond{0.1};
  floor::Route& route = site.routes[0];
  for (const double speed : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 5.0}) {
    for (std::size_t leg = 0; leg < floor::legCount(route); ++leg) {
      route.legSpeeds.clear();
      setLegSpeed(route, leg, MetresPerSecond{speed});
      const auto preview = importLif(site, writeLif(site, kTime).text, "f.lif");
      ASSERT_TRUE(preview) << preview.error().sentence;
      EXPECT_EQ(preview->site, site) << "leg " << leg << " at " << speed;
      EXPECT_THAT(allOf(preview->notes), testing::Not(HasSubstr("became those of legs")));
    }
  }
  // Onto the site before the leg had one, and onto a site without vehicles and zones.
  route.legSpeeds.clear();
  const Site before = site;
  setLegSpeed(route, 0, MetresPerSecond{0.2});
  const auto preview = importLif(before, writeLif(site, kTime).text, "f.lif").value();
  EXPECT_EQ(preview.site, site);
  EXPECT_THAT(allOf(preview.notes), HasSubstr("became those of legs: 1"));
  EXPECT_EQ(preview.changes.size(), 1U);
  EXPECT_EQ(importLif({}, writeLif(site, kTime).text, "f.lif")->site.routes[0].legSpeeds[0], MetresPerSecond{0.2});
}

TEST(Lif, routesComeBackOntoAnEmptySite) {
  Site site = goodFloor();
  site.routes.push_back({"two", {at(0.4, 0.4), at(2, 1), at(0.4, 2)}, Metres{0.2}});
  site.zones.push_back(sitecheck::zone("C", ZoneKind::Charging, sitecheck::rectangle(1, 1, 2, 2)));
  const auto preview = importLif({}, writeLif(site, kTime).text, "f.lif");
  ASSERT_TRUE(preview) << preview.error().sentence;
  EXPECT_EQ(preview->site.routes, site.routes);
  ASSERT_EQ(preview->site.zones.size(), 1U);
  EXPECT_EQ(preview->site.zones[0].kind, ZoneKind::Charging);
  EXPECT_THAT(allOf(preview->notes), HasSubstr("0.6 m: 1."));
  EXPECT_EQ(preview->changes.size(), 3U);
}

// As another maker's file: ids of its own, curves, actions, keys that are not ours.
nlohmann::json foreign() {
  return nlohmann::json::parse(R"({"metaInformation": {"projectIdentification": "p", "creator": "c",
    "exportTimestamp": "2024-01-01T00:00:00Z", "lifVersion": "1.0.0", "more": 1},
  "layouts": [{"layoutId": "L", "layoutVersion": "3", "nodes": [
      {"nodeId": "a", "nodePosition": {"x": 0, "y": 0}, "vehicleTypeNodeProperties": [{"vehicleTypeId": "t", "actions": []}]},
      {"nodeId": "b", "nodePosition": {"x": 1, "y": 0}, "vehicleTypeNodeProperties": []},
      {"nodeId": "c", "nodePosition": {"x": 2, "y": 0}, "vehicleTypeNodeProperties": []},
      {"nodeId": "d", "nodePosition": {"x": 2, "y": 1}, "vehicleTypeNodeProperties": []}],
    "edges": [
      {"edgeId": "2", "startNodeId": "b", "endNodeId": "c", "vehicleTypeEdgeProperties": [{"trajectory": {}}]},
      {"edgeId": "1", "edgeName": "main", "startNodeId": "a", "endNodeId": "b", "vehicleTypeEdgeProperties": []},
      {"edgeId": "3", "startNodeId": "c", "endNodeId": "b", "vehicleTypeEdgeProperties": [{"maxSpeed": 1}]},
      {"edgeId": "4", "startNodeId": "b", "endNodeId": "a", "vehicleTypeEdgeProperties": []},
      {"edgeId": "5", "startNodeId": "c", "endNodeId": "d", "vehicleTypeEdgeProperties": []}],
    "stations": [{"stationId": "S", "interactionNodeIds": ["d"], "stationHeight": 1}]}]})");
}

TEST(Lif, joinsForeignEdgesWhereOnlyOneLeadsOn) {
  const auto preview = importLif({}, foreign().dump(), "f.lif");
  ASSERT_TRUE(preview) << preview.error().sentence;
  std::map<std::string, std::size_t> routes;
  for (const auto& route : preview->site.routes) routes[route.name] = route.vertices.size();
  EXPECT_EQ(routes, (std::map<std::string, std::size_t>{{"main", 4}, {"c - b", 3}}));
  ASSERT_EQ(preview->site.zones.size(), 1U);
  EXPECT_EQ(preview->site.zones[0].name, "S");
  EXPECT_EQ(preview->site.zones[0].outline[0], at(1.7, 0.7));
  const auto back = std::find_if(preview->site.routes.begin(), preview->site.routes.end(),
                                 [](const floor::Route& r) { return r.name == "c - b"; });
  EXPECT_EQ(back->legSpeeds, (std::vector<std::optional<MetresPerSecond>>{MetresPerSecond{1}, std::nullopt}));
  const std::string notes = allOf(preview->notes);
  EXPECT_THAT(notes, HasSubstr("became those of legs: 1"));
  EXPECT_THAT(notes, HasSubstr("straight legs: 1"));
  EXPECT_THAT(notes, HasSubstr("actions were left out: 1"));
  EXPECT_TRUE(floor::SiteMap::build(preview->site));
}

TEST(Lif, aRingIsARouteToo) {
  auto lif = foreign();
  auto& edges = lif["layouts"][0]["edges"];
  edges.clear();
  for (const auto& [from, to] : {std::pair{"a", "b"}, std::pair{"b", "c"}, std::pair{"c", "d"}, std::pair{"d", "a"}})
    edges.push_back({{"edgeId", from},
                     {"startNodeId", from},
                     {"endNodeId", to},
                     {"vehicleTypeEdgeProperties", nlohmann::json::array()}});
  const auto preview = importLif({}, lif.dump(), "f.lif");
  ASSERT_TRUE(preview) << preview.error().sentence;
  ASSERT_EQ(preview->site.routes.size(), 1U);
  EXPECT_EQ(preview->site.routes[0].vertices.size(), 5U);
}

TEST(Lif, saysWhereWhatIsWrong) {
  const auto error = [](const nlohmann::json& lif) { return importLif({}, lif.dump(), "f.lif").error().sentence; };
  auto lif = foreign();
  lif["layouts"][0]["edges"][1]["endNodeId"] = "z";
  EXPECT_EQ(error(lif),
            "f.lif: /layouts/0/edges/1/endNodeId: expected the nodeId of a node of this file, found \"z\".");
  lif = foreign();
  lif["layouts"][0]["nodes"][2]["nodeId"] = "a";
  EXPECT_THAT(error(lif), HasSubstr("/layouts/0/nodes/2/nodeId"));
  lif = foreign();
  lif["layouts"][0]["edges"][2]["vehicleTypeEdgeProperties"][0]["maxSpeed"] = -1;
  EXPECT_THAT(error(lif),
              HasSubstr("/layouts/0/edges/2/vehicleTypeEdgeProperties/0/maxSpeed: expected a number of m/s"));
  lif = foreign();
  lif["metaInformation"]["lifVersion"] = "2.0";
  EXPECT_THAT(error(lif), HasSubstr("a version 1.x"));
  lif = foreign();
  lif["layouts"][0].erase("stations");
  EXPECT_THAT(error(lif), HasSubstr("/layouts/0/stations: expected this key"));
  EXPECT_THAT(importLif({}, R"({"layouts": [], "layouts": []})", "f.lif").error().sentence, HasSubstr("stands twice"));
  EXPECT_THAT(importLif({}, "{", "f.lif").error().sentence, HasSubstr("line 1"));
}

}  // namespace
}  // namespace tessera::exchange
