// `tessera-cli site`: from a new floor to tables and layouts and back, as a script would do it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "floor/site_json.h"
#include "store/revisions.h"
#include "store/site_store.h"
#include "system/site_commands.h"

namespace tessera::system_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(SiteCommands, makeAFloorThatIsNotWrittenOver) {
  makeFloor("hall.tessera.json", true);
  EXPECT_EQ(json({"check", at("hall.tessera.json")}, cli::kDone)["tags"], 160);
  EXPECT_EQ(json({"check", at("hall.tessera.json")}, cli::kDone)["name"], "hall");
  const std::string before = bytesOf(at("hall.tessera.json"));
  const Words again{"new", at("hall.tessera.json"), "--tile-type", "30x30 full 15", "--columns", "1", "--rows", "1"};
  EXPECT_EQ(run(again, cli::kCannotWrite), "");
  EXPECT_THAT(errors(), HasSubstr("--force"));
  EXPECT_EQ(bytesOf(at("hall.tessera.json")), before);
  Words forced = again;
  forced.emplace_back("--force");
  EXPECT_EQ(json(forced, cli::kDone)["tiles"], 1);
}

TEST_F(SiteCommands, checkWithRoomAroundVehicles) {
  const std::string paper = TESSERA_SITES "/paper.tessera.json";
  EXPECT_EQ(json({"check", paper}, cli::kDone)["warnings"], 0);
  EXPECT_THAT(run({"check", paper}, cli::kDone), HasSubstr("\n0 errors, 0 warnings.\n"));
  const auto checked = json({"check", paper, "--clearance", "0.3"}, cli::kDone);
  ASSERT_EQ(checked["warnings"], 1);
  EXPECT_EQ(checked["faults"][0]["kind"], "route-too-close");
  run({"check", paper, "--clearance", "-1"}, cli::kUsage);
}

TEST_F(SiteCommands, listFaultsWithTheirPlaces) {
  makeFloor("hall.tessera.json", true);
  auto site = nlohmann::json::parse(bytesOf(at("hall.tessera.json")));
  site["placements"][7]["x_m"] = 0.9;
  site["tiles"][2]["uids"] = nlohmann::json::array();
  write("broken.tessera.json", site.dump());
  const auto found = json({"check", at("broken.tessera.json")}, cli::kNotFinished);
  EXPECT_EQ(found["errors"], 1);
  const auto overlap = std::find_if(found["faults"].begin(), found["faults"].end(),
                                    [](const auto& f) { return f["kind"] == "tiles-overlap"; });
  ASSERT_NE(overlap, found["faults"].end());
  EXPECT_EQ((*overlap)["severity"], "error");
  EXPECT_EQ((*overlap)["objects"][0]["name"], "T-0008");
  EXPECT_NEAR((*overlap)["place"]["low_m"][0].get<double>(), 0.9, 1e-9);
  EXPECT_THAT(run({"check", at("broken.tessera.json")}, cli::kNotFinished),
              HasSubstr("tile-unregistered at (1.50, 0.30) m"));
  site["tiles"][3]["uids"][0] = site["tiles"][4]["uids"][0];
  write("twice.tessera.json", site.dump());
  EXPECT_THAT(run({"check", at("twice.tessera.json")}, cli::kBadInput), HasSubstr("uid-twice"));
  EXPECT_THAT(errors(), HasSubstr("two places"));
}

TEST_F(SiteCommands, sayWhichTagsATableLacks) {
  makeFloor("hall.tessera.json", true);
  auto site = nlohmann::json::parse(bytesOf(at("hall.tessera.json")));
  site["loose_tags"] = {{{"uid", "04AABBCC"}, {"x_m", 1}, {"y_m", 1}}};
  site["placements"].erase(0);
  write("loose.tessera.json", site.dump());
  EXPECT_THAT(run({"convert", at("loose.tessera.json"), at("tags.csv")}, cli::kDone), HasSubstr("left out: 1."));
  const auto places = json({"convert", at("loose.tessera.json"), at("places.csv"), "--to", "csv-places"}, cli::kDone);
  ASSERT_EQ(places["notes"].size(), 1U);
  EXPECT_THAT(places["notes"][0].get<std::string>(), HasSubstr("left out: 8."));
}

TEST_F(SiteCommands, takeALayoutForOneWhateverItsName) {
  run({"convert", TESSERA_SITES "/paper.tessera.json", at("paper.lif.json")}, cli::kDone);
  write("foreign.json", bytesOf(at("paper.lif.json")));
  run({"convert", at("foreign.json"), at("routes.tessera.json")}, cli::kDone);
  EXPECT_EQ(json({"stats", at("routes.tessera.json")}, cli::kDone)["routes"][0]["name"], "paper");
  write("plain.json", bytesOf(TESSERA_SITES "/paper.tessera.json"));
  run({"convert", at("plain.json"), at("again.tessera.json")}, cli::kDone);
  EXPECT_EQ(bytesOf(at("again.tessera.json")), bytesOf(TESSERA_SITES "/paper.tessera.json"));
}

TEST_F(SiteCommands, checkAndCountSeveralFilesAtOnce) {
  makeFloor("good.tessera.json", true);
  makeFloor("other.tessera.json", true);
  auto site = nlohmann::json::parse(bytesOf(at("other.tessera.json")));
  site["placements"][7]["x_m"] = 0.9;
  write("broken.tessera.json", site.dump());
  site["tiles"][3]["uids"][0] = site["tiles"][4]["uids"][0];
  write("twice.tessera.json", site.dump());
  EXPECT_THAT(run({"check", at("good.tessera.json"), at("other.tessera.json")}, cli::kDone),
              AllOf(HasSubstr(at("good.tessera.json") + ":\ngood: 20 tiles"), HasSubstr("other: 20 tiles")));
  const auto two = json({"check", at("broken.tessera.json"), at("good.tessera.json")}, cli::kNotFinished);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0]["file"], at("broken.tessera.json"));
  EXPECT_EQ(two[0]["errors"], 1);
  EXPECT_EQ(two[1]["errors"], 0);
  const auto all =
      json({"check", at("twice.tessera.json"), at("none.tessera.json"), at("good.tessera.json")}, cli::kBadInput);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_TRUE(std::any_of(all[0]["faults"].begin(), all[0]["faults"].end(), [](const auto& f) {
    return f["kind"] == "uid-twice" && f["severity"] == "error";
  })) << "what cannot be used is listed all the same";
  EXPECT_THAT(all[1]["error"].get<std::string>(), HasSubstr("none.tessera.json"));
  EXPECT_EQ(all[2]["errors"], 0) << "after one that cannot be read";
  const auto stats = json({"stats", at("good.tessera.json"), at("broken.tessera.json")}, cli::kDone);
  ASSERT_EQ(stats.size(), 2U);
  EXPECT_EQ(stats[1]["file"], at("broken.tessera.json"));
  EXPECT_EQ(stats[1]["tags_registered"], 160);
  EXPECT_EQ(json({"stats", at("good.tessera.json"), at("none.tessera.json")}, cli::kBadInput).size(), 2U);
}

TEST_F(SiteCommands, addOneSiteToAnother) {
  makeFloor("a.tessera.json", true);
  auto site = nlohmann::json::parse(bytesOf(at("a.tessera.json")));
  for (auto& tile : site["tiles"]) {
    tile["serial"] = "X" + tile["serial"].get<std::string>();
    tile["uids"] = nlohmann::json::array();
  }
  for (auto& placement : site["placements"]) {
    placement["serial"] = "X" + placement["serial"].get<std::string>();
    placement["x_m"] = placement["x_m"].get<double>() + 50;
  }
  write("b.tessera.json", site.dump());
  const Words words{"convert", at("b.tessera.json"), at("both.tessera.json"), "--onto", at("a.tessera.json")};
  EXPECT_EQ(json(words, cli::kDone)["changes"].size(), 40U);
  EXPECT_EQ(json({"stats", at("both.tessera.json")}, cli::kDone)["tiles_laid"], 40);
  site["tiles"][0]["uids"] = nlohmann::json::parse(bytesOf(at("a.tessera.json")))["tiles"][1]["uids"];
  write("b.tessera.json", site.dump());
  Words forced = words;
  forced.emplace_back("--force");
  const std::string before = bytesOf(at("both.tessera.json"));
  run(forced, cli::kBadInput);
  EXPECT_THAT(errors(), HasSubstr("would be registered twice"));
  EXPECT_EQ(bytesOf(at("both.tessera.json")), before);
}

TEST_F(SiteCommands, carryTagsByTheirPlaces) {
  makeFloor("full.tessera.json", true);
  makeFloor("bare.tessera.json", false);
  run({"convert", at("full.tessera.json"), at("tags.csv"), "--to", "csv-places"}, cli::kDone);
  const auto filled =
      json({"convert", at("tags.csv"), at("filled.tessera.json"), "--onto", at("bare.tessera.json")}, cli::kDone);
  EXPECT_THAT(filled["notes"][0].get<std::string>(), HasSubstr("160"));
  EXPECT_EQ(json({"stats", at("filled.tessera.json")}, cli::kDone)["tags_registered"], 160);
}

TEST_F(SiteCommands, carryTagsFromOneFloorToAnother) {
  makeFloor("full.tessera.json", true);
  makeFloor("bare.tessera.json", false);
  run({"convert", at("full.tessera.json"), at("tags.csv")}, cli::kDone);
  const auto filled =
      json({"convert", at("tags.csv"), at("filled.tessera.json"), "--onto", at("bare.tessera.json")}, cli::kDone);
  EXPECT_EQ(filled["changes"].size(), 20U);
  EXPECT_EQ(json({"stats", at("filled.tessera.json")}, cli::kDone)["tags_registered"], 160);
  write("tags.csv", bytesOf(at("tags.csv")) + "T-0001,99,\n");
  run({"convert", at("tags.csv"), at("other.tessera.json"), "--onto", at("bare.tessera.json")}, cli::kBadInput);
  EXPECT_THAT(errors(), HasSubstr("tags.csv: line 162: expected an index from 1 to 8"));
  EXPECT_EQ(bytesOf(at("other.tessera.json")), "") << "nothing was written";
}

TEST_F(SiteCommands, carryRoutesThroughALayout) {
  const std::string paper = TESSERA_SITES "/paper.tessera.json";
  const auto out = json({"convert", paper, at("paper.lif.json")}, cli::kDone);
  EXPECT_EQ(out["format"], "lif");
  EXPECT_GT(out["notes"].size(), 0U);
  run({"convert", at("paper.lif.json"), at("routes.tessera.json")}, cli::kDone);
  const auto stats = json({"stats", at("routes.tessera.json")}, cli::kDone);
  EXPECT_EQ(stats["routes"][0]["name"], "paper");
  EXPECT_NEAR(stats["routes"][0]["length_m"].get<double>(), 4.8, 1e-9);
  EXPECT_EQ(
      json({"convert", at("paper.lif.json"), at("same.tessera.json"), "--onto", paper}, cli::kDone)["changes"].size(),
      0U);
  EXPECT_EQ(bytesOf(at("same.tessera.json")), bytesOf(paper));
}

TEST_F(SiteCommands, sayWhatDiffers) {
  makeFloor("a.tessera.json", true);
  makeFloor("b.tessera.json", true);
  auto site = nlohmann::json::parse(bytesOf(at("b.tessera.json")));
  site["name"] = "a";
  site["placements"][3]["x_m"] = 7;
  write("b.tessera.json", site.dump());
  const auto changes = json({"diff", at("a.tessera.json"), at("b.tessera.json")}, cli::kNotFinished);
  ASSERT_EQ(changes["changes"].size(), 1U);
  EXPECT_EQ(changes["changes"][0]["kind"], "moved");
  EXPECT_EQ(run({"diff", at("a.tessera.json"), at("a.tessera.json")}, cli::kDone), "The sites are equal.\n");
}

TEST_F(SiteCommands, listTheRevisionsThatTheWindowKept) {
  makeFloor("hall.tessera.json", true);
  const std::string database = at("tessera.sqlite");
  const Words words{"revisions", at("hall.tessera.json"), "--database", database};
  EXPECT_EQ(run(words, cli::kBadInput), "");
  EXPECT_THAT(errors(), HasSubstr("is not there"));
  {
    auto site = floor::loadSite(at("hall.tessera.json")).value();
    const auto opened = store::Database::open(database).value();
    const std::string key = store::keyOfFile(at("hall.tessera.json"));
    ASSERT_TRUE(store::Revisions{*opened}.add(key, site, {1'000, "", "", true}));
    site.placements.pop_back();
    ASSERT_TRUE(store::Revisions{*opened}.add(key, site, {1'700'000'000'000, "Ada", "Take up 1 tile", false}));
  }
  run({"revisions", at("never.tessera.json"), "--database", database}, cli::kBadInput);
  EXPECT_THAT(errors(), HasSubstr("never.tessera.json: is not there"));
  EXPECT_EQ(run(words, cli::kDone),
            "2023-11-14T22:13:20Z  Ada  Take up 1 tile  (tiles taken up: 1)\n"
            "1970-01-01T00:00:01Z  unknown  the file as it was opened\n");
  const auto result = json(words, cli::kDone);
  ASSERT_EQ(result["revisions"].size(), 2U);
  EXPECT_EQ(result["revisions"][0]["changed"]["tiles_taken_up"], 1);
  EXPECT_EQ(result["revisions"][1]["changed"], nullptr);
  EXPECT_EQ(result["revisions"][1]["found_in_file"], true);
}

}  // namespace
}  // namespace tessera::system_test
