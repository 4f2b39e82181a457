#include "app/cli/site_output.h"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace tessera::cli {
namespace {

nlohmann::json boxOf(const std::optional<Box>& place) {
  if (!place) return nullptr;
  return {{"low_m", {place->low.x.value(), place->low.y.value()}},
          {"high_m", {place->high.x.value(), place->high.y.value()}}};
}

}  // namespace

nlohmann::json jsonOf(const sitecheck::Fault& fault) {
  nlohmann::json objects = nlohmann::json::array();
  for (const sitecheck::Object& object : fault.objects)
    objects.push_back({{"kind", codeOf(object.kind)}, {"name", object.name}});
  return {{"kind", codeOf(fault.kind)},
          {"severity", codeOf(fault.severity)},
          {"sentence", fault.sentence.english()},
          {"place", boxOf(fault.place)},
          {"objects", objects},
          {"fix", fault.fix ? nlohmann::json(fault.fix->sentence.english()) : nlohmann::json(nullptr)}};
}

nlohmann::json jsonOf(const sitediff::Change& change) {
  return {{"kind", codeOf(change.kind)},
          {"subject", codeOf(change.subject)},
          {"name", change.name},
          {"sentence", change.sentence.english()},
          {"place", boxOf(change.place)}};
}

nlohmann::json jsonOf(const std::vector<Sentence>& sentences) {
  nlohmann::json list = nlohmann::json::array();
  for (const Sentence& sentence : sentences) list.push_back(sentence.english());
  return list;
}

std::string lineOf(const sitecheck::Fault& fault) {
  std::string line{codeOf(fault.severity)};
  line.resize(9, ' ');
  line += codeOf(fault.kind);
  if (fault.place) {
    const Point middle = middleOf(*fault.place);
    char text[700];
    std::snprintf(text, sizeof text, " at (%.2f, %.2f) m", middle.x.value(), middle.y.value());
    line += text;
  }
  line += ": " + fault.sentence.english();
  if (fault.fix) line += " (Fix: " + fault.fix->sentence.english() + ".)";
  return line;
}

std::string stemOf(const std::string& file) {
  const std::string name = std::filesystem::path{file}.filename().string();
  const std::size_t dot = name.find('.', 1);
  return dot == std::string::npos ? name : name.substr(0, dot);
}

}  // namespace tessera::cli
