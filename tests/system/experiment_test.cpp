// A whole experiment as the README starts it: what it leaves in its folder, with vehicles of either kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QColor>
#include <QImage>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "system/program.h"

namespace tessera::system_test {
namespace {

std::vector<std::string> linesOf(const std::string& file) {
  std::ifstream in{file};
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// How many have this colour, as near as smooth edges leave it.
int pixels(const QImage& picture, const QColor& colour) {
  constexpr int kNear = 12;
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor here = picture.pixelColor(x, y);
      const bool same = std::abs(here.red() - colour.red()) <= kNear &&
                        std::abs(here.green() - colour.green()) <= kNear &&
                        std::abs(here.blue() - colour.blue()) <= kNear;
      count += same ? 1 : 0;
    }
  }
  return count;
}

class AnExperimentThroughThePort : public ::testing::TestWithParam<std::string> {};

TEST_P(AnExperimentThroughThePort, leavesItsFiguresItsTrackAndItsPicture) {
  const QTemporaryDir folder;
  const std::string out = folder.path().toStdString() + "/results";
  Program cli{TESSERA_CLI,
              {"experiment", TESSERA_SYSTEM_TEST "/corner.tessera.json", "--route", "corner", "--speed", "0.2",
               "--vehicle", GetParam(), "--json", "--out", out}};
  ASSERT_EQ(cli.exitCode(), 0) << cli.errors();
  EXPECT_EQ(cli.errors(), "") << "--json says nothing beside its result";

  std::ifstream file{out + "/summary.json"};
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  ASSERT_TRUE(summary.is_object());
  EXPECT_EQ(nlohmann::json::parse(cli.output(), nullptr, false), summary);
  for (const char* key : {"position_error_mean_m", "position_error_p95_m", "heading_error_rms_rad", "cross_track_rms_m",
                          "cross_track_max_m", "duration_s", "end_error_m", "mean_speed_ratio"}) {
    ASSERT_TRUE(summary.contains(key) && summary[key].is_number()) << key;
    EXPECT_GT(summary[key].get<double>(), 0) << key << " of a real drive is never nothing at all";
  }
  EXPECT_EQ(summary["finished"], true);
  EXPECT_EQ(summary["reversals"], 0);
  EXPECT_LT(summary["position_error_mean_m"], 0.05);
  EXPECT_LE(summary["position_error_mean_m"], summary["position_error_p95_m"]);
  EXPECT_LT(summary["cross_track_rms_m"], 0.03);
  EXPECT_LE(summary["cross_track_rms_m"], summary["cross_track_max_m"]);
  // How fast it went on the way is a matter of the machine too, here where time is real: the benches hold it to 0.8.
  EXPECT_GT(summary["duration_s"], 1.0 / 0.2) << "it is no faster than asked";
  EXPECT_EQ(summary["options"]["vehicle"], GetParam());

  const auto rows = linesOf(out + "/track.csv");
  ASSERT_GT(rows.size(), 20U);
  EXPECT_EQ(rows[0],
            "time_s,true_x_m,true_y_m,true_heading_rad,estimate_x_m,estimate_y_m,estimate_heading_rad,located,"
            "command_speed_m_per_s,command_heading_rad,judged,claimed_xx_m2,claimed_yy_m2,claimed_xy_m2");
  EXPECT_GT(rows.size(), summary["samples"].get<std::size_t>()) << "a row for each sample, and the header";
  for (const auto& row : rows) EXPECT_EQ(std::count(row.begin(), row.end(), ','), 13) << row;
  const auto isJudged = [](const std::string& row) { return QString::fromStdString(row).section(',', 10, 10) == "1"; };
  const auto judged = std::count_if(rows.begin(), rows.end(), isJudged);
  EXPECT_EQ(judged, summary["samples"].get<std::ptrdiff_t>()) << "the ticks that the figures count";

  const QImage picture{QString::fromStdString(out + "/track.png"), "PNG"};
  EXPECT_GE(picture.width(), 600);
  EXPECT_GE(picture.height(), 400);
  // The route is drawn wide, the true track as a thin line on it, the estimate dashed; lettering is black on white.
  EXPECT_GT(pixels(picture, QColor{60, 60, 60}), 500) << "the route";
  EXPECT_GT(pixels(picture, QColor{0, 114, 178}), 300) << "the true track";
  // How much of the estimate is to be seen says how far it is from the true track, which hides it where they agree.
  EXPECT_GT(pixels(picture, QColor{0, 114, 178}.lighter(150)), 0) << "the estimate";
}

INSTANTIATE_TEST_SUITE_P(OfVehicles, AnExperimentThroughThePort, ::testing::Values(TESSERA_KIND),
                         [](const auto& tried) { return tried.param; });

}  // namespace
}  // namespace tessera::system_test
