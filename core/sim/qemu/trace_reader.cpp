#include "sim/qemu/trace_reader.h"

#include <charconv>
#include <optional>

namespace tessera::sim {
namespace {

/// The text between `before` and `after`, nullopt when either is missing.
std::optional<std::string_view> between(std::string_view line, std::string_view before, std::string_view after) {
  const std::size_t start = line.find(before);
  if (start == std::string_view::npos) return std::nullopt;
  const std::string_view rest = line.substr(start + before.size());
  const std::size_t end = after.empty() ? rest.size() : rest.find(after);
  if (end == std::string_view::npos) return std::nullopt;
  return rest.substr(0, end);
}

std::optional<std::uint32_t> number(std::optional<std::string_view> text, int base) {
  if (!text) return std::nullopt;
  if (base == 16 && text->starts_with("0x")) text->remove_prefix(2);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value, base);
  if (error != std::errc{} || end != text->data() + text->size()) return std::nullopt;
  return value;
}

}  // namespace

TraceEvent parseTraceLine(std::string_view line) {
  if (line.starts_with("PWM: unimplemented device write")) {
    const auto offset = number(between(line, "offset ", ","), 16);
    const auto value = number(between(line, "value ", ")"), 16);
    if (offset && value) return PwmWrite{*offset, *value};
  } else if (line.starts_with("pl061_set_output ")) {
    const auto port = between(line, "pl061_set_output ", " ");
    const auto pin = number(between(line, "setting output ", " to "), 10);
    const auto level = number(between(line, " to ", ""), 10);
    if (port && pin && *pin < 8 && level && *level < 2) return PinLevel{std::string{*port}, *pin, *level == 1};
  } else if (line.starts_with("pl061_reset ")) {
    if (const auto port = between(line, "pl061_reset ", " ")) return PortReset{std::string{*port}};
  }
  return Remark{std::string{line}};
}

void LineCutter::feed(std::string_view bytes, const std::function<void(std::string_view)>& sink) {
  for (std::size_t end = bytes.find('\n'); end != std::string_view::npos; end = bytes.find('\n')) {
    rest_ += bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    if (rest_.ends_with('\r')) rest_.pop_back();
    sink(rest_);
    rest_.clear();
  }
  rest_ += bytes;
}

}  // namespace tessera::sim
