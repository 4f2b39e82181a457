#include "app/cli/magnetic_map_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/experiment/summary.h"
#include "locate/magnetic_file.h"

namespace tessera::cli {

Result<void> takeMagneticMap(const std::string& file, supervisor::Config& config) {
  if (file.empty()) return {};
  config.byMagneticMap = true;
  if (!std::filesystem::exists(file)) return {};
  std::ifstream in{file, std::ios::binary};
  const std::vector<char> read{std::istreambuf_iterator<char>{in}, std::istreambuf_iterator<char>{}};
  const std::vector<std::uint8_t> bytes{read.begin(), read.end()};
  auto map = locate::magneticMapFrom(bytes);
  if (!map) return failure(file + ": " + map.error().sentence.english());
  config.magnetic = std::make_shared<locate::MagneticMap>(std::move(*map));
  return {};
}

Result<void> keepMagneticMap(const std::string& file, const supervisor::Snapshot* last) {
  if (file.empty() || last == nullptr || !last->magnetic) return {};
  const std::vector<std::uint8_t> bytes = locate::bytesOf(*last->magnetic);
  return experiment::writeWhole(file, std::string{bytes.begin(), bytes.end()});
}

}  // namespace tessera::cli
