// `tessera-cli site` where something is wrong: with the words, with a file, or with where the result is to go.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "system/site_commands.h"

namespace tessera::system_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class SiteFailures : public SiteCommands {};

TEST_F(SiteFailures, countEveryFaultHoweverManyAreListed) {
  run({"new", at("wide.tessera.json"), "--tile-type", "60x60 full 15", "--columns", "50", "--rows", "40"}, cli::kDone);
  const auto checked = json({"check", at("wide.tessera.json")}, cli::kDone);
  EXPECT_EQ(checked["warnings"], 2001) << "2000 tiles without tags, and no vehicle";
  EXPECT_EQ(checked["faults"].size(), 2001U);
  const std::string some = run({"check", at("wide.tessera.json")}, cli::kDone);
  EXPECT_THAT(some, AllOf(HasSubstr("... and 1980 more of tile-unregistered; --all lists them."),
                          HasSubstr("0 errors, 2001 warnings.")));
  EXPECT_THAT(some, testing::Not(HasSubstr("one by one")));
  const std::string all = run({"check", at("wide.tessera.json"), "--all"}, cli::kDone);
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 2003) << "a line of each, one before and one after";
}

TEST_F(SiteFailures, refuseWordsThatAreWrong) {
  run({"new", at("x"), "--tile-type", "marble", "--columns", "1", "--rows", "1"}, cli::kUsage);
  run({"new", at("x"), "--tile-type", "30x30 full 15", "--columns", "0", "--rows", "1"}, cli::kUsage);
  run({"convert", at("a.csv"), at("b.tessera.json")}, cli::kUsage);
  run({"convert", TESSERA_SITES "/paper.tessera.json", at("b.txt")}, cli::kUsage);
  run({"diff", at("a")}, cli::kUsage);
  run({"chek", at("a")}, cli::kUsage);
  EXPECT_THAT(errors(), HasSubstr("There is no sub-command \"site chek\""));
  run({}, cli::kUsage);
  EXPECT_THAT(errors(), HasSubstr("subcommand is required"));
  run({"new", at("a.csv"), "--tile-type", "30x30 full 15", "--columns", "1", "--rows", "1"}, cli::kUsage);
  EXPECT_THAT(errors(), HasSubstr("*.tessera.json"));
  EXPECT_EQ(bytesOf(at("a.csv")), "");
}

TEST_F(SiteFailures, neitherCountNorConvertAContradictionAsIfItWereNone) {
  makeFloor("hall.tessera.json", true);
  auto site = nlohmann::json::parse(bytesOf(at("hall.tessera.json")));
  site["tiles"][3]["uids"][0] = site["tiles"][4]["uids"][0];
  write("twice.tessera.json", site.dump());
  const auto stats = json({"stats", at("twice.tessera.json")}, cli::kBadInput);
  EXPECT_THAT(stats["error"].get<std::string>(), HasSubstr("two places"));
  EXPECT_EQ(stats["tiles_laid"], 20) << "what can be counted is";
  for (const char* out : {"tags.csv", "copy.tessera.json", "layout.lif.json"}) {
    run({"convert", at("twice.tessera.json"), at(out)}, cli::kBadInput);
    EXPECT_THAT(errors(), AllOf(HasSubstr("twice.tessera.json"), HasSubstr("two places")));
    EXPECT_EQ(bytesOf(at(out)), "") << out << " was not written";
  }
}

TEST_F(SiteFailures, failInJsonOnStandardOutputToo) {
  const std::string none = at("none.tessera.json");
  makeFloor("hall.tessera.json", true);
  const std::string hall = at("hall.tessera.json");
  for (const Words& words :
       {Words{"check", none}, Words{"stats", none}, Words{"diff", none, hall}, Words{"convert", none, at("a.csv")},
        Words{"revisions", none, "--database", at("no.sqlite")}})
    EXPECT_TRUE(json(words, cli::kBadInput)["error"].is_string()) << words.front();
  EXPECT_TRUE(json({"convert", hall, at("none/a.csv")}, cli::kCannotWrite)["error"].is_string());
}

TEST_F(SiteFailures, nameForceOnlyWhereAFileIsInTheWay) {
  makeFloor("hall.tessera.json", true);
  run({"convert", at("hall.tessera.json"), at("none/a.csv")}, cli::kCannotWrite);
  EXPECT_THAT(errors(), testing::Not(HasSubstr("--force")));
  run({"convert", at("hall.tessera.json"), at("hall.tessera.json")}, cli::kCannotWrite);
  EXPECT_THAT(errors(), HasSubstr("See --force."));
  run({"new", at("none/b.json"), "--tile-type", "30x30 full 15", "--columns", "1", "--rows", "1"}, cli::kCannotWrite);
  EXPECT_THAT(errors(), testing::Not(HasSubstr("--force")));
}

TEST_F(SiteFailures, replaceNeitherAPipeNorAFolderEvenByForce) {
  makeFloor("hall.tessera.json", true);
  ASSERT_EQ(::mkfifo(at("pipe.csv").c_str(), 0600), 0);
  ASSERT_EQ(::symlink("pipe.csv", at("link.csv").c_str()), 0);
  for (const char* out : {"pipe.csv", "link.csv"}) {
    run({"convert", at("hall.tessera.json"), at(out), "--force"}, cli::kCannotWrite);
    EXPECT_THAT(errors(), HasSubstr("is not replaced"));
    EXPECT_TRUE(std::filesystem::is_fifo(at(out)));
  }
}

}  // namespace
}  // namespace tessera::system_test
