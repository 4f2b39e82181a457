#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "floor/site_json.h"
#include "floor/site_map.h"
#include "fuzz/targets.h"
#include "sitecheck/site_checker.h"

namespace tessera::fuzz {

void site(std::span<const std::uint8_t> input) {
  const std::string_view text{reinterpret_cast<const char*>(input.data()), input.size()};
  const auto parsed = floor::parseSite(text, "f");
  if (!parsed) {
    const std::string& sentence = parsed.error().sentence;
    require(sentence.starts_with("f: ") && sentence.ends_with("."), "an error is a sentence that names the file");
    require(sentence.size() < 2000, "an error is short");
    return;
  }
  const std::string written = floor::writeSite(*parsed);
  const auto again = floor::parseSite(written, "f");
  require(again.has_value(), "what was written can be read");
  require(floor::writeSite(*again) == written, "reading and writing changes no byte");
  const auto map = floor::SiteMap::build(*parsed);
  const sitecheck::Verdict verdict = sitecheck::checkSite(*parsed);
  if (!map) {
    require(!map.error().sentence.empty(), "a refusal says why");
    require(verdict.count(sitecheck::Severity::Error) > 0, "what is refused is an error of the check");
    return;
  }
  std::size_t seen = 0;
  (*map)->forEachNear({}, Metres{1e9}, [&seen](const floor::PlacedTag&) { ++seen; });
  require(seen == (*map)->tags().size(), "the grid holds every tag");
  for (const floor::PlacedTag& tag : (*map)->tags()) require((*map)->find(tag.uid) == tag.place, "every tag is found");
}

std::vector<Input> siteSeeds(const std::string& folderOfSites) {
  std::vector<Input> seeds;
  for (const auto& entry : std::filesystem::directory_iterator{folderOfSites}) {
    if (!entry.path().string().ends_with(".tessera.json")) continue;
    std::ifstream in{entry.path(), std::ios::binary};
    seeds.emplace_back(std::istreambuf_iterator<char>{in}, std::istreambuf_iterator<char>{});
  }
  const std::string_view small =
      R"({"format": "tessera-site", "version": 1, "name": "n", "north_to_y_deg": 20.5,
"tile_types": [{"name": "t", "width_m": 1, "height_m": 1, "pitch_m": 0.2, "columns": 2, "rows": 1, "pattern": "custom", "custom": ["#."]}],
"tiles": [{"serial": "A", "type": "t", "uids": ["04000001"]}], "placements": [{"serial": "A", "x_m": 1, "y_m": 2, "quarter_turns": 1}],
"loose_tags": [{"uid": "04000002", "x_m": 1, "y_m": 1}],
"zones": [{"name": "z", "kind": "slow", "speed_mps": 0.1, "direction_deg": -90, "outline_m": [[0, 0], [1, 0], [1, 1]]}],
"routes": [{"name": "r", "vertices_m": [[0, 0], [1, 1], [2, 0]], "leg_speeds_mps": [0.5, null]}],
"vehicles": [{"id": 1, "name": "v", "key": "000102030405060708090A0B0C0D0E0F", "readers_m": [[0, 0]],
"footprint_m": [[0, 0], [1, 0], [1, 1]], "start": {"x_m": 0, "y_m": 0, "heading_deg": 90}}]})";
  seeds.emplace_back(small.begin(), small.end());
  return seeds;
}

}  // namespace tessera::fuzz
