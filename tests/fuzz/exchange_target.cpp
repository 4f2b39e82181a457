#include "exchange/lif.h"
#include "exchange/tag_tables.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "floor/site_map.h"
#include "fuzz/targets.h"

namespace tessera::fuzz {
namespace {

std::string_view textOf(std::span<const std::uint8_t> input) {
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}

void requireSentence(const std::string& sentence) {
  require(sentence.starts_with("f: ") && sentence.ends_with("."), "an error is a sentence that names the file");
  require(sentence.size() < 2000, "an error is short");
}

const floor::Site& smallFloor() {
  static const floor::Site site = [] {
    floor::Site s = floor::layNewFloor({"f", floor::usualTileTypes().front(), 2, 1, true}).value();
    s.looseTags = {{floor::TagUid::parse("04AABBCC").value(), {}}};
    s.routes = {{"r", {{}, {Metres{1}, {}}}, Metres{0.2}}};
    return s;
  }();
  return site;
}

// What an import gives is a site like any other.
void requireWhole(const floor::Site& site) {
  require(floor::SiteMap::build(site).has_value(), "the site does not contradict itself");
  const std::string written = floor::writeSite(site);
  const auto again = floor::parseSite(written, "f");
  require(again.has_value() && floor::writeSite(*again) == written, "the site can be written and read");
}

Input inputOf(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace

void csv(std::span<const std::uint8_t> input) {
  const auto preview = exchange::importTags(smallFloor(), textOf(input), "f");
  if (!preview) return requireSentence(preview.error().sentence);
  requireWhole(preview->site);
  require(preview->changes.empty() == (preview->site == smallFloor()), "what changes is told");
  for (const std::string& table : {exchange::writeTileTags(preview->site), exchange::writeTagPlaces(preview->site)}) {
    const auto again = exchange::importTags(preview->site, table, "f");
    require(again.has_value() && again->site == preview->site, "a table of the site changes nothing in it");
  }
}

void lif(std::span<const std::uint8_t> input) {
  const auto preview = exchange::importLif(smallFloor(), textOf(input), "f");
  if (!preview) return requireSentence(preview.error().sentence);
  requireWhole(preview->site);
  const std::string written = exchange::writeLif(preview->site, "2026-01-01T00:00:00Z").text;
  const auto again = exchange::importLif(preview->site, written, "f");
  require(again.has_value() && again->site == preview->site, "a layout of the site changes nothing in it");
}

std::vector<Input> csvSeeds() {
  return {inputOf(exchange::writeTileTags(smallFloor())), inputOf(exchange::writeTagPlaces(smallFloor())),
          inputOf("\xEF\xBB\xBFserial,index,uid\r\n\"T-0001\",1,\r\n\"T-0002\", 3 ,\"04:AA:BB:CD\"\r\n"),
          inputOf("x,y,uid\n1.5,-2e-1,04AABBCC\n\n0,0,0102030405060708090A\n")};
}

std::vector<Input> lifSeeds() {
  return {
      inputOf(exchange::writeLif(smallFloor(), "2026-01-01T00:00:00Z").text),
      inputOf(
          R"({"metaInformation": {"projectIdentification": "p", "creator": "c", "exportTimestamp": "t", "lifVersion": "1.0"},
"layouts": [{"layoutId": "L", "layoutVersion": "1", "nodes": [
{"nodeId": "a", "nodePosition": {"x": 0, "y": 0}, "vehicleTypeNodeProperties": []},
{"nodeId": "b", "nodePosition": {"x": 1, "y": 0}, "vehicleTypeNodeProperties": [{"actions": []}]}],
"edges": [{"edgeId": "1", "edgeName": "e", "startNodeId": "a", "endNodeId": "b", "vehicleTypeEdgeProperties": []},
{"edgeId": "r/1", "startNodeId": "b", "endNodeId": "a", "vehicleTypeEdgeProperties": [{"vehicleTypeId": "x", "maxSpeed": 0.3, "trajectory": {}}]}],
"stations": [{"stationId": "S", "interactionNodeIds": ["a"], "stationDescription": "parking"}]}]})")};
}

}  // namespace tessera::fuzz
