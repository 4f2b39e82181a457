#include "floor/json_node.h"

#include <algorithm>
#include <cmath>

#include "floor/json_parse.h"

namespace tessera::floor {
namespace {

using nlohmann::json;

std::string shortened(std::string s) {
  constexpr std::size_t longest = 60;
  if (s.size() <= longest) return s;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(s[end]) & 0xC0U) == 0x80U) --end;  // not inside a UTF-8 character
  return s.substr(0, end) + "...";
}

Sentence described(const json* value) {
  if (value == nullptr) return phrase("Core", "nothing");
  if (value->is_object()) return phrase("Core", "an object");
  if (value->is_array()) return phrase("Core", "an array of %1").with(value->size());
  return shortened(value->dump(-1, ' ', false, json::error_handler_t::replace));
}

// 0.6 as "0.6".
std::string plain(double v) { return json(v).dump(); }

bool contains(std::initializer_list<std::string_view> keys, std::string_view key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

void JsonErrors::add(const std::string& pointer, const Sentence& sentence) {
  if (first_) return;
  const Sentence place = pointer.empty() ? Sentence{phrase("Core", "the document")} : Sentence{pointer};
  first_ = Error{phrase("Core", "%1: %2: %3").with(document_, place, sentence)};
}

std::string JsonNode::pointer() const {
  if (parent_ == nullptr) return {};
  return parent_->pointer() + "/" + (key_.empty() ? std::to_string(index_) : escapedKey(key_));
}

void JsonNode::fail(const Sentence& expected) const {
  errors_.add(pointer(), phrase("Core", "expected %1, found %2.").with(expected, described(value_)));
}

void JsonNode::secretFail(const Sentence& expected) const {
  errors_.add(pointer(), phrase("Core", "expected %1, found something else.").with(expected));
}

void JsonNode::object(std::initializer_list<std::string_view> required,
                      std::initializer_list<std::string_view> optional) {
  if (value_ == nullptr || !value_->is_object()) return fail(phrase("Core", "an object"));
  for (const auto& [key, value] : value_->items()) {
    if (contains(required, key) || contains(optional, key)) continue;
    std::string known;
    for (auto keys : {required, optional}) {
      for (std::string_view k : keys) known += (known.empty() ? "" : ", ") + std::string{k};
    }
    return errors_.add(pointer() + "/" + escapedKey(shortened(key)),
                       phrase("Core", "there is no such key here; expected one of %1.").with(known));
  }
  objectWith(required);
}

void JsonNode::objectWith(std::initializer_list<std::string_view> required) const {
  if (value_ == nullptr || !value_->is_object()) return fail(phrase("Core", "an object"));
  for (std::string_view key : required) {
    if (!value_->contains(key)) {
      return errors_.add(pointer() + "/" + escapedKey(key), phrase("Core", "expected this key, which is missing."));
    }
  }
}

JsonNode JsonNode::operator[](std::string_view key) const {
  const json* child = nullptr;
  if (value_ != nullptr && value_->is_object()) {
    if (const auto found = value_->find(key); found != value_->end()) child = &*found;
  }
  return {*this, child, key, 0};
}

JsonNode JsonNode::operator[](std::size_t index) const {
  const bool inside = value_ != nullptr && value_->is_array() && index < value_->size();
  return {*this, inside ? &(*value_)[index] : nullptr, {}, index};
}

bool JsonNode::isNull() const { return value_ != nullptr && value_->is_null(); }

double JsonNode::number(double low, double high, const Sentence& unit) const {
  if (value_ != nullptr && value_->is_number()) {
    const double v = value_->get<double>();
    if (v >= low && v <= high) return v == 0.0 ? 0.0 : v;  // no minus zero
  }
  fail(phrase("Core", "a number of %1 from %2 to %3").with(unit, plain(low), plain(high)));
  return low;
}

int JsonNode::integer(int low, int high) const {
  if (value_ != nullptr && value_->is_number()) {
    // 3.0 is as much of an integer as 3, as JSON Schema sees it.
    const double v = value_->get<double>();
    if (v >= low && v <= high && v == std::floor(v)) return static_cast<int>(v);
  }
  fail(phrase("Core", "a whole number from %1 to %2").with(low, high));
  return low;
}

bool JsonNode::boolean() const {
  if (value_ != nullptr && value_->is_boolean()) return value_->get<bool>();
  fail(phrase("Core", "true or false"));
  return false;
}

std::string JsonNode::text(std::size_t shortest, std::size_t longest) const {
  if (value_ != nullptr && value_->is_string()) {
    const auto& s = value_->get_ref<const std::string&>();
    const auto characters = static_cast<std::size_t>(
        std::count_if(s.begin(), s.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    if (characters >= shortest && characters <= longest) return s;
  }
  fail(phrase("Core", "a text of %1 to %2 characters").with(shortest, longest));
  return {};
}

std::size_t JsonNode::choice(const std::vector<std::string_view>& choices) const {
  if (value_ != nullptr && value_->is_string()) {
    const auto found = std::find(choices.begin(), choices.end(), value_->get_ref<const std::string&>());
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  }
  std::string known;
  for (std::string_view c : choices) known += (known.empty() ? "\"" : ", \"") + std::string{c} + "\"";
  fail(phrase("Core", "one of %1").with(known));
  return 0;
}

std::size_t JsonNode::array(std::size_t fewest, std::size_t most) const {
  if (value_ != nullptr && value_->is_array() && value_->size() >= fewest && value_->size() <= most) {
    return value_->size();
  }
  fail(phrase("Core", "an array of %1 to %2 elements").with(fewest, most));
  return 0;
}

}  // namespace tessera::floor
