#include "floor/json_parse.h"

#include <utility>
#include <vector>

namespace tessera::floor {
namespace {

using nlohmann::json;

// Takes the parser's events and makes the tree itself: the library's own way of being told of each key copies every
// value once more, which doubles the time of a large floor.
class TreeMaker {
public:
  TreeMaker(ParsedJson& result, JsonErrors& errors) : result_{result}, errors_{errors} {}

  bool null() { return put(nullptr); }
  bool boolean(bool v) { return put(v); }
  bool number_integer(json::number_integer_t v) { return put(v); }
  bool number_unsigned(json::number_unsigned_t v) { return put(v); }
  bool number_float(json::number_float_t v, const json::string_t& /*text*/) { return put(v); }
  bool string(json::string_t& v) { return put(std::move(v)); }
  bool binary(json::binary_t& /*v*/) { return false; }  // does not occur in a text
  bool start_object(std::size_t /*size*/) { return open(json::object()); }
  bool start_array(std::size_t /*size*/) { return open(json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(json::string_t& key) {
    const auto [entry, isNew] = open_.back()->get_ref<json::object_t&>().try_emplace(key);
    if (!isNew) errors_.add(pointerTo(key), phrase("Core", "this key stands twice in one object."));
    awaited_ = &entry->second;
    return true;
  }
  bool parse_error(std::size_t position, const std::string& /*token*/, const json::exception& error) {
    constexpr int numberOverflow = 406;  // the library's number for it
    result_.outcome = error.id == numberOverflow ? JsonOutcome::NumberTooLarge : JsonOutcome::NoJson;
    result_.byte = position;
    return false;
  }

private:
  json* place(json&& value) {
    if (open_.empty()) return &(result_.value = std::move(value));
    if (open_.back()->is_array()) return &open_.back()->emplace_back(std::move(value));
    return &(*awaited_ = std::move(value));
  }
  bool put(json&& value) {
    place(std::move(value));
    return true;
  }
  bool open(json&& value) {
    if (open_.size() == kMaxJsonDepth) {
      result_.outcome = JsonOutcome::TooDeep;
      return false;
    }
    open_.push_back(place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  // What is open is the last element of an array, but any value of an object.
  [[nodiscard]] std::string pointerTo(const std::string& key) const {
    std::string s;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      if (open_[i]->is_array()) {
        s += "/" + std::to_string(open_[i]->size() - 1);
        continue;
      }
      for (const auto& [name, value] : open_[i]->items())
        if (&value == open_[i + 1]) s += "/" + escapedKey(name);
    }
    return s + "/" + escapedKey(key);
  }

  ParsedJson& result_;
  JsonErrors& errors_;
  std::vector<json*> open_;  ///< arrays and objects that have begun, the outermost first
  json* awaited_ = nullptr;  ///< the value of the key just read
};

}  // namespace

ParsedJson parseJson(std::string_view text, JsonErrors& errors) {
  ParsedJson result;
  TreeMaker maker{result, errors};
  static_cast<void>(json::sax_parse(text, &maker));  // false: the outcome says it
  return result;
}

std::string escapedKey(std::string_view key) {
  std::string s;
  for (char c : key) s += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return s;
}

}  // namespace tessera::floor
