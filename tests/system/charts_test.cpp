// Charts over many runs: drawn from what an experiment left, refused in a sentence where the tables are not right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QColor>
#include <QImage>
#include <QTemporaryDir>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/cli/exit_codes.h"
#include "system/program.h"

namespace tessera::system_test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string kRunHead =
    "folder,track,controller,speed_m_per_s,position_error_mean_m,cross_track_rms_m,reversals,nees_mean,nees_low,nees_"
    "high,error\n";
const std::string kTrackHead = "time_s,true_x_m,true_y_m,estimate_x_m,estimate_y_m,judged\n";
const QColor kFirst{0, 114, 178}, kSecond{213, 94, 0};

/// How many pixels have this colour, as near as smooth edges leave it.
int pixels(const QImage& picture, const QColor& colour) {
  const auto near = [](int a, int b) { return std::abs(a - b) <= 12; };
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor here = picture.pixelColor(x, y);
      count += near(here.red(), colour.red()) && near(here.green(), colour.green()) && near(here.blue(), colour.blue());
    }
  return count;
}

class Charts : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    fs::create_directories(path("a"));
    write("a/track.csv", kTrackHead + "0,0,0,9,9,0\n0.1,0,0,0.01,0,1\n0.2,0,0,0,0.03,1\n");
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path().toStdString() + "/" + name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream{path(name)} << text; }
  [[nodiscard]] Program draw(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"charts", path("runs.csv"), "--out", path("out")};
    words.insert(words.end(), more.begin(), more.end());
    return Program{TESSERA_CLI, words};
  }
  void expectRefusal(const std::string& saying, std::vector<std::string> more = {}) const {
    Program cli = draw(std::move(more));
    EXPECT_EQ(cli.exitCode(), cli::kBadInput) << cli.errors();
    EXPECT_EQ(cli.output(), "");
    EXPECT_THAT(cli.errors(), HasSubstr(saying));
    EXPECT_THAT(cli.errors(), testing::StartsWith("tessera-cli: "));
    EXPECT_EQ(std::count(cli.errors().begin(), cli.errors().end(), '\n'), 1) << cli.errors();
    EXPECT_FALSE(fs::exists(path("out/errors.png")));
  }
  [[nodiscard]] QImage picture(const std::string& name) const {
    return QImage{QString::fromStdString(path("out/" + name)), "PNG"};
  }

private:
  QTemporaryDir folder_;
};

TEST_F(Charts, areDrawnOfEachSeriesInAColourOfItsOwn) {
  fs::create_directories(path("b"));
  write("b/track.csv", kTrackHead + "0.1,0,0,0.05,0,1\n0.2,0,0,0,0.04,1\n");
  write("runs.csv", kRunHead + "a,track.csv,ours,0.05,0.02,0.01,0,2,1,3,\n" +
                        "b,track.csv,theirs,0.05,0.03,0.02,1,5,1,3,\n" + "a,track.csv,ours,0.2,0.02,0.01,0,2,1,3,\n" +
                        "b,track.csv,theirs,0.2,0.03,0.08,9,5,1,3,\n" + "c,,,,,,,,,,refused\n");
  Program cli = draw({"--json"});
  ASSERT_EQ(cli.exitCode(), cli::kDone) << cli.errors();
  EXPECT_EQ(cli.errors(), "") << "nor do Qt or the charts complain";
  const auto answer = nlohmann::json::parse(cli.output(), nullptr, false);
  ASSERT_TRUE(answer.is_object());
  EXPECT_EQ(answer["runs"], 4);
  EXPECT_EQ(answer["left_out"], 1);
  ASSERT_EQ(answer["pictures"].size(), 4U);
  // Keys of the legend alone have fewer pixels than this.
  for (const char* name : {"errors.png", "speed.png", "nees.png", "tracking.png"}) {
    const QImage drawn = picture(name);
    EXPECT_EQ(drawn.width(), 900) << name;
    EXPECT_GE(drawn.height(), 400) << name;
    EXPECT_EQ(drawn.pixelColor(2, 2), QColor{Qt::white}) << name;
    EXPECT_GT(pixels(drawn, kFirst), 60) << name;
    EXPECT_GT(pixels(drawn, kSecond), 60) << name;
  }
}

TEST_F(Charts, tellRunsApartByTheColumnThatIsNamed) {
  write("runs.csv",
        kRunHead + "a,track.csv,ours,0.05,0.02,0.01,0,2,1,3,\n" + "a,track.csv,theirs,0.05,0.03,0.02,1,2,1,3,\n");
  Program cli = draw({"--by", "speed_m_per_s"});
  ASSERT_EQ(cli.exitCode(), cli::kDone) << cli.errors();
  EXPECT_THAT(cli.output(), HasSubstr("Picture: "));
  EXPECT_EQ(pixels(picture("speed.png"), kSecond), 0) << "all runs are one series";
}

TEST_F(Charts, areDrawnOfWhatAnExperimentLeft) {
  Program drive{TESSERA_CLI,
                {"experiment", TESSERA_SYSTEM_TEST "/corner.tessera.json", "--route", "corner", "--speed", "0.3",
                 "--lockstep", "--quiet", "--out", path("a")}};
  ASSERT_EQ(drive.exitCode(), cli::kDone) << drive.errors();
  write("runs.csv", kRunHead + "a,track.csv,ours,0.3,0.02,0.01,0,2,1,3,\n");
  Program cli = draw();
  EXPECT_EQ(cli.exitCode(), cli::kDone) << cli.errors();
  EXPECT_GT(pixels(picture("errors.png"), kFirst), 100);
}

TEST_F(Charts, ofTablesThatAreNotRightAreRefusedInASentence) {
  const std::string good = "a,track.csv,ours,0.05,0.02,0.01,0,2,1,3,\n";
  expectRefusal("runs.csv");  // there is none
  write("runs.csv", "");
  expectRefusal("runs.csv is empty.");
  write("runs.csv", kRunHead);
  expectRefusal("holds no run that gave figures");
  write("runs.csv", kRunHead + "b,,,,,,,,,,refused\n");
  expectRefusal("holds no run that gave figures");
  write("runs.csv", kRunHead + good + "a,track.csv,ours,fast,0.02,0.01,0,2,1,3,\n");
  expectRefusal("line 3: expected a number for speed_m_per_s, found \"fast\"");
  for (const char* wrong : {"nan", "inf", "1e999", "", "0.05 "}) {
    write("runs.csv", kRunHead + "a,track.csv,ours,0.05,0.02,0.01,0," + wrong + ",1,3,\n");
    expectRefusal("expected a number for nees_mean");
  }
  write("runs.csv", kRunHead + good + "a,track.csv,ours\n");
  expectRefusal("line 3");
  write("runs.csv", kRunHead + "\"a,track.csv\n");
  expectRefusal("closing quote");
  write("runs.csv", "folder,track,controller\na,b,c\n");
  expectRefusal("has no column speed_m_per_s");
  write("runs.csv", kRunHead + good);
  expectRefusal("has no column moon", {"--by", "moon"});
  std::string nine = kRunHead;
  for (int i = 0; i < 9; ++i) nine += "a,track.csv,c" + std::to_string(i) + ",0.05,0.02,0.01,0,2,1,3,\n";
  write("runs.csv", nine);
  expectRefusal("9 different things under controller");
}

TEST_F(Charts, ofTracksThatAreNotRightAreRefusedInASentence) {
  write("runs.csv", kRunHead + "a,track.csv,ours,0.05,0.02,0.01,0,2,1,3,\n");
  write("a/track.csv", kTrackHead + "0.1,0,zero,0.01,0,1\n");
  expectRefusal("track.csv: line 2: expected a number for true_y_m, found \"zero\"");
  write("a/track.csv", kTrackHead + "0.1,0,0,0.01,0,0\n");
  expectRefusal("holds no tick that is judged");
  write("a/track.csv", "time_s,true_x_m\n0,0\n");
  expectRefusal("has no column judged");
  fs::remove(path("a/track.csv"));
  expectRefusal("a/track.csv");
}

TEST_F(Charts, areNotDrawnWhereNothingCanBeWritten) {
  write("runs.csv", kRunHead + "a,track.csv,ours,0.05,0.02,0.01,0,2,1,3,\n");
  write("out", "a file");
  Program cli = draw({"--json"});
  EXPECT_EQ(cli.exitCode(), cli::kCannotWrite);
  EXPECT_THAT(nlohmann::json::parse(cli.output(), nullptr, false).value("error", ""), HasSubstr("/out"));
}

}  // namespace
}  // namespace tessera::system_test
