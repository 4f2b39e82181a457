// tessera-cli's manners: help, exit codes, one sentence for what is wrong, results alone on standard output.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <QTemporaryDir>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/cli/exit_codes.h"
#include "drive/route_follower.h"
#include "host/supervisor_thread.h"
#include "locate/locator.h"
#include "system/program.h"
#include "system/world.h"

namespace tessera::system_test {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

const std::string kCorner = TESSERA_SYSTEM_TEST "/corner.tessera.json";

struct Call {
  const char* name;
  Words words;
  std::vector<std::string> says;
};
void PrintTo(const Call& call, std::ostream* out) { *out << call.name; }
const auto kNameOf = [](const auto& tried) { return std::string{tried.param.name}; };

class Help : public testing::TestWithParam<Call> {};

TEST_P(Help, namesTheOptionsAndTheExitCodes) {
  Program cli{TESSERA_CLI, GetParam().words};
  EXPECT_EQ(cli.exitCode(), cli::kDone);
  EXPECT_EQ(cli.errors(), "");
  for (const std::string& option : GetParam().says) EXPECT_THAT(cli.output(), HasSubstr(option));
  EXPECT_THAT(cli.output(), HasSubstr("Exit codes: 0 done"));
}

INSTANTIATE_TEST_SUITE_P(
    OfEverySubCommand, Help,
    testing::Values(
        Call{"tessera", {"--help"}, {"experiment", "drive", "ports", "site", "--version", "--help-all"}},
        Call{"experiment",
             {"experiment", "--help"},
             {"SITE",          "--route",     "--drive",      "--speed",     "--vehicle",   "--firmware",
              "--out",         "--estimator", "--controller", "--limit",     "--lockstep",  "--json",
              "--quiet",       "--seed",      "--air-rate",   "--loss",      "--detection", "--dead-tags",
              "--true-radius", "--slip",      "--corrupt",    "--eeprom-dir"}},
        Call{"charts", {"charts", "--help"}, {"RUNS", "--by", "--out", "--json", "errors.png", "tracking.png"}},
        Call{"drive",
             {"drive", "--help"},
             {"SITE", "--port", "--drive", "--speed", "--limit", "--estimator", "--controller", "--json", "--quiet"}},
        Call{"radio", {"radio", "--help"}, {"read", "write", "check"}},
        Call{"radioWrite",
             {"radio", "write", "--help"},
             {"--port", "--lines", "--json", "--site", "--channel", "--air-rate", "--baud", "--power"}},
        Call{"ports", {"ports", "--help"}, {"--json"}},
        Call{"site", {"site", "--help"}, {"new", "check", "convert", "diff", "stats", "revisions"}},
        Call{"siteCheck", {"site", "check", "--help"}, {"FILE", "--all", "--json"}},
        Call{"siteNew",
             {"site", "new", "--help"},
             {"--tile-type", "--columns", "--rows", "--name", "--practice", "--force"}},
        Call{"siteConvert", {"site", "convert", "--help"}, {"IN", "OUT", "--to", "--onto", "--force", "--json"}},
        Call{"siteDiff", {"site", "diff", "--help"}, {"BEFORE", "AFTER"}},
        Call{"siteRevisions", {"site", "revisions", "--help"}, {"FILE", "--database", "--json"}},
        Call{"siteStats", {"site", "stats", "--help"}, {"FILE", "--speed"}}),
    kNameOf);

// A refusal: this exit code, one line on standard error with the words, nothing on standard output.
void expectRefusal(const Call& call, int code) {
  Program cli{TESSERA_CLI, call.words};
  EXPECT_EQ(cli.exitCode(), code) << cli.errors();
  EXPECT_EQ(cli.output(), "");
  for (const std::string& word : call.says) EXPECT_THAT(cli.errors(), HasSubstr(word));
}
void expectOneSentence(const Call& call, int code) {
  Program cli{TESSERA_CLI, call.words};
  EXPECT_EQ(cli.exitCode(), code) << cli.errors();
  EXPECT_EQ(cli.output(), "");
  for (const std::string& word : call.says) EXPECT_THAT(cli.errors(), HasSubstr(word));
  EXPECT_EQ(std::count(cli.errors().begin(), cli.errors().end(), '\n'), 1) << cli.errors();
  EXPECT_THAT(cli.errors(), testing::StartsWith("tessera-cli: "));
  EXPECT_THAT(cli.errors(), testing::EndsWith(".\n"));
}

class WrongCall : public testing::TestWithParam<Call> {};
TEST_P(WrongCall, isRefused) { expectRefusal(GetParam(), cli::kUsage); }

INSTANTIATE_TEST_SUITE_P(
    Words, WrongCall,
    testing::Values(
        Call{"nothing", {}, {"subcommand"}}, Call{"unknownCommand", {"fly"}, {"fly"}},
        Call{"unknownCommandOfASite",
             {"site", "chek", "x"},
             {"no sub-command \"site chek\"", "tessera-cli site --help"}},
        Call{"unknownCommandOfTheRadio", {"radio", "reed"}, {"no sub-command \"radio reed\""}},
        Call{"noCommandOfTheRadio", {"radio"}, {"subcommand"}},
        Call{"unknownOption", {"ports", "--colour"}, {"--colour"}}, Call{"noSite", {"experiment"}, {"SITE"}},
        Call{"noPort", {"drive", kCorner, "--drive", "1=corner"}, {"--port"}},
        Call{"noRouteAtAll", {"experiment", kCorner}, {"--route"}},
        Call{"noAssignment", {"drive", kCorner, "--port", "/dev/null", "--drive", "corner"}, {"corner", "1=paper"}},
        Call{"noAddress", {"experiment", kCorner, "--drive", "256=corner"}, {"256=corner"}},
        Call{"noEndOfALimit", {"experiment", kCorner, "--route", "corner", "--limit", "nan"}, {"--limit"}},
        Call{"noNumber", {"experiment", kCorner, "--route", "corner", "--speed", "fast"}, {"--speed"}},
        Call{"tooFast", {"experiment", kCorner, "--route", "corner", "--speed", "9"}, {"--speed"}},
        Call{"unknownVehicleKind", {"experiment", kCorner, "--route", "corner", "--vehicle", "horse"}, {"--vehicle"}},
        Call{"emulatedInLockstep",
             {"experiment", kCorner, "--route", "corner", "--vehicle", "qemu", "--lockstep"},
             {"--lockstep"}},
        Call{"unknownEstimator",
             {"experiment", kCorner, "--route", "corner", "--lockstep", "--estimator", "oracle"},
             {"oracle"}},
        Call{"unknownController",
             {"drive", kCorner, "--port", "/dev/null", "--drive", "1=corner", "--controller", "oracle"},
             {"oracle"}}),
    kNameOf);

class BadInput : public testing::TestWithParam<Call> {};
TEST_P(BadInput, isToldInOneSentence) { expectOneSentence(GetParam(), cli::kBadInput); }

INSTANTIATE_TEST_SUITE_P(
    Files, BadInput,
    testing::Values(
        Call{"unknownRoute", {"experiment", kCorner, "--route", "moon"}, {"moon", "One corner"}},
        Call{"unknownVehicle", {"experiment", kCorner, "--drive", "9=corner"}, {"9", "One corner"}},
        Call{"aVehicleWithTwoRoutes",
             {"experiment", kCorner, "--route", "corner", "--drive", "1=corner"},
             {"Vehicle 1", "two routes"}},
        Call{"missingFile", {"site", "check", "/nonexistent.tessera.json"}, {"/nonexistent.tessera.json"}},
        Call{"missingFileOfAnExperiment",
             {"experiment", "/nonexistent.tessera.json", "--route", "corner"},
             {"/nonexistent.tessera.json"}},
        Call{"aFileThatIsNoSite", {"site", "check", TESSERA_SYSTEM_TEST "/CMakeLists.txt"}, {"CMakeLists.txt"}},
        Call{"aFolder", {"site", "check", TESSERA_SYSTEM_TEST}, {TESSERA_SYSTEM_TEST}}),
    kNameOf);

TEST(BrokenFile, isToldWithItsName) {
  const QTemporaryDir folder;
  const std::string path = folder.path().toStdString() + "/half.tessera.json";
  std::ifstream in{kCorner};
  std::string text{std::istreambuf_iterator<char>{in}, {}};
  std::ofstream{path} << text.substr(0, text.size() / 2);
  expectOneSentence({"", {"site", "check", path}, {path}}, cli::kBadInput);
  expectOneSentence({"", {"experiment", path, "--route", "corner"}, {path}}, cli::kBadInput);
}

TEST(MissingPort, isToldWhenTheLimitIsOver) {
  expectOneSentence({"",
                     {"drive", kCorner, "--port", "/dev/nonexistent", "--drive", "1=corner", "--limit", "1", "--quiet"},
                     {"/dev/nonexistent"}},
                    cli::kNoPort);
}

TEST(MissingPort, isToldAsItHappens) {
  expectRefusal({"",
                 {"drive", kCorner, "--port", "/dev/nonexistent", "--drive", "1=corner", "--limit", "1"},
                 {"/dev/nonexistent", "there is no such device"}},
                cli::kNoPort);
}

TEST(UnwritableFolder, isToldBeforeAnythingIsDriven) {
  expectOneSentence({"", {"experiment", kCorner, "--route", "corner", "--out", kCorner + "/results"}, {"/results"}},
                    cli::kCannotWrite);
}

TEST(Json, isAllThatStandsOnStandardOutput) {
  const QTemporaryDir folder;
  const auto parsed = [](const Words& words, int code) {
    Program cli{TESSERA_CLI, words};
    EXPECT_EQ(cli.exitCode(), code) << cli.errors();
    EXPECT_EQ(cli.errors(), "");
    return nlohmann::json::parse(cli.output(), nullptr, false);
  };
  EXPECT_TRUE(parsed({"ports", "--json"}, cli::kDone).is_array());
  const auto site = parsed({"site", "check", kCorner, "--json"}, cli::kDone);
  ASSERT_TRUE(site.is_object());
  EXPECT_EQ(site["tags"], 32);
  EXPECT_EQ(site["routes"], 1);
  const auto summary = parsed({"experiment", kCorner, "--route", "corner", "--speed", "0.3", "--lockstep", "--json",
                               "--out", folder.path().toStdString()},
                              cli::kDone);
  ASSERT_TRUE(summary.is_object());
  EXPECT_EQ(summary["finished"], true);
  EXPECT_GT(summary["channel"]["cycle_s"], 0.0);
  // Every option of the world is a field of its own, also where it was not given.
  for (const char* option : {"compass_spots_deg", "dead_tags", "read_time_s", "heading_learning_m", "true_radius_m",
                             "floor_seed", "corrupt", "drop", "replay", "eeprom_dir", "firmware"})
    EXPECT_TRUE(summary["options"].contains(option)) << option;
  EXPECT_EQ(summary["options"]["compass_spots_deg"], 10.0);
  EXPECT_EQ(summary["options"]["corner_cut_m"], 0.0) << "it turns on the spot";
  EXPECT_EQ(summary["options"]["carry_s"], 0.0);
  EXPECT_EQ(summary["options"]["floor_seed"], summary["options"]["seed"]) << "the same chance";
  EXPECT_NEAR(summary["options"]["limit_s"], 70.0, 1e-6) << "three times the drive of a metre, and 60 s";
  EXPECT_EQ(summary["options"]["magnetic_map"], "");
  const std::string map = folder.filePath("iron.map").toStdString();
  const auto told = parsed({"experiment",     kCorner,
                            "--route",        "corner",
                            "--speed",        "0.3",
                            "--lockstep",     "--json",
                            "--out",          folder.path().toStdString(),
                            "--carry",        "1000",
                            "--limit",        "90",
                            "--corner-cut",   "0.1",
                            "--magnetic-map", map,
                            "--floor-seed",   "7",
                            "--corrupt",      "0.001",
                            "--drop",         "0.002",
                            "--replay",       "0.003",
                            "--eeprom-dir",   folder.path().toStdString()},
                           cli::kDone);
  EXPECT_EQ(told["options"]["floor_seed"], 7);
  EXPECT_EQ(told["options"]["corrupt"], 0.001);
  EXPECT_EQ(told["options"]["drop"], 0.002);
  EXPECT_EQ(told["options"]["replay"], 0.003);
  EXPECT_EQ(told["options"]["eeprom_dir"], folder.path().toStdString());
  EXPECT_EQ(told["options"]["corner_cut_m"], 0.1);
  EXPECT_EQ(told["options"]["carry_s"], 1000.0);
  EXPECT_EQ(told["options"]["limit_s"], 90.0);
  EXPECT_EQ(told["options"]["magnetic_map"], map);
  EXPECT_EQ(summary["options"]["true_radius_m"], summary["options"]["radius_m"]);
  EXPECT_EQ(summary["options"]["estimator"], locate::locatorNames().front());
  EXPECT_EQ(summary["options"]["controller"], drive::followerNames().front());
  EXPECT_THAT(summary["options"]["world_arguments"].get<Words>(), testing::Not(testing::Contains("--truth")));
  World world{folder, kCorner, {}};
  const auto late = parsed({"drive", kCorner, "--port", world.port(), "--drive", "1=corner", "--limit", "2", "--json"},
                           cli::kNotFinished);
  ASSERT_TRUE(late.is_object());
  EXPECT_EQ(late["finished"], false);
  EXPECT_EQ(late["vehicles"][0]["vehicle"], 1);
}

TEST(Json, tellsAlsoWhatFailed) {
  const std::vector<std::vector<std::string>> calls{
      {"experiment", "/nonexistent.tessera.json", "--route", "corner"},
      {"drive", "/nonexistent.tessera.json", "--port", "/dev/null", "--drive", "1=corner"},
      {"radio", "check", "--port", "/dev/null", "--site", "/nonexistent.tessera.json"},
      {"site", "check", "/nonexistent.tessera.json"}};
  for (std::vector<std::string> words : calls) {
    words.emplace_back("--json");
    Program cli{TESSERA_CLI, words};
    EXPECT_EQ(cli.exitCode(), cli::kBadInput) << cli.errors();
    const auto answer = nlohmann::json::parse(cli.output(), nullptr, false);
    ASSERT_TRUE(answer.is_object()) << words.front() << cli.output();
    EXPECT_THAT(answer.value("error", ""), HasSubstr("/nonexistent.tessera.json")) << words.front();
    EXPECT_THAT(cli.errors(), HasSubstr("/nonexistent.tessera.json")) << "for people as well";
  }
}

TEST(CtrlC, stopsTheVehicleBeforeTheProgramEnds) {
  const QTemporaryDir folder;
  World world{folder, kCorner, {}};
  ASSERT_NE(world.port(), "") << world.program().errors();
  Program cli{TESSERA_CLI, {"drive", kCorner, "--port", world.port(), "--drive", "1=corner", "--speed", "0.1"}};
  ASSERT_TRUE(cli.complains("[ 10 %]")) << cli.errors();
  cli.signal(SIGINT);
  EXPECT_EQ(cli.exitCode(), cli::kInterrupted) << cli.errors();
  EXPECT_LT(world.movedOnFor(host::steadyNow()), Seconds{0.1}) << "it was left rolling";
  EXPECT_GT(distance(world.where(), Point{Metres{0.3}, Metres{0.3}}), Metres{0.05}) << "it was on its way";
}

TEST(CtrlC, leavesAnExperimentItsFiguresSoFar) {
  const QTemporaryDir folder;
  const std::string out = folder.path().toStdString();
  Program cli{TESSERA_CLI, {"experiment", kCorner, "--route", "corner", "--speed", "0.1", "--out", out}};
  ASSERT_TRUE(cli.complains("[ 10 %]")) << cli.errors();
  cli.signal(SIGINT);
  EXPECT_EQ(cli.exitCode(), cli::kInterrupted) << cli.errors();
  std::ifstream file{out + "/summary.json"};
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  ASSERT_TRUE(summary.is_object());
  EXPECT_EQ(summary["finished"], false);
}

}  // namespace
}  // namespace tessera::system_test
