#include "exchange/file_format.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace tessera::exchange {
namespace {

std::string inSmallLetters(std::string_view name) {
  std::string small{name};
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return small;
}

// Reads on until the outermost object is known to have the key, or not; keeps nothing.
class KeyAtTop : public nlohmann::json_sax<nlohmann::json> {
public:
  explicit KeyAtTop(std::string_view key) : key_{key} {}
  [[nodiscard]] bool found() const { return found_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool key(string_t& key) override {
    found_ = depth_ == 1 && key == key_;
    return !found_;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

private:
  bool enter() {
    ++depth_;
    return true;
  }
  bool leave() {
    --depth_;
    return true;
  }
  std::string_view key_;
  std::size_t depth_ = 0;
  bool found_ = false;
};

}  // namespace

std::optional<Format> formatOfName(std::string_view name) {
  const std::string small = inSmallLetters(name);
  if (small.ends_with(".csv")) return Format::TagTable;
  if (small.ends_with(".lif") || small.ends_with(".lif.json")) return Format::Layout;
  if (small.ends_with(".json")) return Format::Site;
  return std::nullopt;
}

Format formatOf(std::string_view name, std::string_view text) {
  const Format format = formatOfName(name).value_or(Format::Site);
  if (format != Format::Site || inSmallLetters(name).ends_with(".tessera.json")) return format;
  KeyAtTop layouts{"layouts"};
  nlohmann::json::sax_parse(text, &layouts, nlohmann::json::input_format_t::json, false);
  return layouts.found() ? Format::Layout : Format::Site;
}

}  // namespace tessera::exchange
