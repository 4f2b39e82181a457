#include "app/experiment/summary.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "floor/text_file.h"

namespace tessera::experiment {
namespace {

// The next comma-separated number of a line; false when there is none.
bool takeNumber(std::string_view& line, double& value) {
  const auto comma = line.find(',');
  const std::string_view field = line.substr(0, comma);
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  line = comma == std::string_view::npos ? std::string_view{} : line.substr(comma + 1);
  return error == std::errc{} && end == field.data() + field.size();
}

std::ostream& operator<<(std::ostream& out, const Pose& p) {
  return out << p.position.x.value() << ',' << p.position.y.value() << ',' << p.heading.value();
}

}  // namespace

nlohmann::json toJson(const Metrics& m, bool finished) {
  nlohmann::json figures = {{"finished", finished},
                            {"duration_s", m.duration.value()},
                            {"position_error_mean_m", m.positionErrorMean.value()},
                            {"position_error_p95_m", m.positionErrorP95.value()},
                            {"position_error_max_m", m.positionErrorMax.value()},
                            {"heading_error_rms_rad", m.headingErrorRms.value()},
                            {"cross_track_rms_m", m.crossTrackRms.value()},
                            {"cross_track_max_m", m.crossTrackMax.value()},
                            {"cross_track_rms_off_corners_m", m.crossTrackRmsOffCorners.value()},
                            {"cross_track_max_off_corners_m", m.crossTrackMaxOffCorners.value()},
                            {"reversals", m.reversals},
                            {"mean_speed_ratio", m.meanSpeedRatio},
                            {"end_error_m", m.endError.value()},
                            {"located_share", m.locatedShare},
                            {"nees_mean", m.consistency.neesMean},
                            {"nees_low", m.consistency.low},
                            {"nees_high", m.consistency.high},
                            {"nees_independent_samples", m.consistency.independent},
                            {"consistent", m.consistency.holds()},
                            {"samples", m.samples}};
  // Nothing measured is not nothing wrong.
  if (m.samples == 0)
    for (auto& [name, value] : figures.items())
      if (name != "finished" && name != "samples") value = nullptr;
  return figures;
}

Result<void> writeWhole(const std::string& file, const std::string& text) {
  if (auto fit = floor::replaceable(file); !fit) return fit;
  const std::string draft = file + ".part";
  {
    std::ofstream out{draft, std::ios::binary | std::ios::trunc};
    out << text;
    out.flush();
    if (!out) return failure("The file " + draft + " could not be written: " + std::strerror(errno) + ".");
  }
  std::error_code error;
  std::filesystem::rename(draft, file, error);
  if (error) return failure("The file " + file + " could not be written: " + error.message() + ".");
  return {};
}

Result<void> writeTrackCsv(const std::string& file, const std::vector<Sample>& samples) {
  std::ostringstream out;
  out.precision(9);
  out << "time_s,true_x_m,true_y_m,true_heading_rad,estimate_x_m,estimate_y_m,estimate_heading_rad,located,"
         "command_speed_m_per_s,command_heading_rad,judged,"
         "claimed_xx_m2,claimed_yy_m2,claimed_xy_m2\n";
  for (const Sample& s : samples) {
    out << s.belief.at.value() << ',' << s.truth.pose << ',' << s.belief.pose << ',' << (s.belief.located ? 1 : 0)
        << ',' << s.belief.commandSpeed.value() << ',' << s.belief.commandHeading.value() << ','
        << (s.belief.driving ? 1 : 0);
    for (const double claimed : s.belief.doubt) out << ',' << claimed;
    out << '\n';
  }
  return writeWhole(file, out.str());
}

Result<TruthTrack> readTruth(const std::string& file, int vehicle) {
  std::ifstream in{file};
  if (!in) return failure("The file of true poses " + file + " cannot be read: " + std::strerror(errno) + ".");
  std::vector<Truth> poses;
  std::string line;
  std::getline(in, line);  // the header
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    std::string_view rest = line;
    std::array<double, 6> v{};
    for (double& value : v) {
      // The last line may be cut where the world was ended in the middle of it.
      if (!takeNumber(rest, value)) {
        if (in.peek() == std::ifstream::traits_type::eof()) return TruthTrack{std::move(poses)};
        return failure("The file of true poses " + file + " holds something else than numbers in line " +
                       std::to_string(number) + ".");
      }
    }
    if (static_cast<int>(v[1]) != vehicle) continue;
    poses.push_back({Seconds{v[0]}, {{Metres{v[2]}, Metres{v[3]}}, Radians{v[4]}}, MetresPerSecond{v[5]}});
  }
  return TruthTrack{std::move(poses)};
}

}  // namespace tessera::experiment
