// Reading JSON with an error that names the place: a node knows its JSON pointer (RFC 6901) and what was expected of
// it. Reading goes on after an error with harmless values; the first error is the one that is told.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace tessera::floor {

/// The first error met in one document.
class JsonErrors {
public:
  explicit JsonErrors(std::string document) : document_{std::move(document)} {}
  void add(const std::string& pointer, const Sentence& sentence);
  [[nodiscard]] const std::optional<Error>& first() const { return first_; }

private:
  std::string document_;
  std::optional<Error> first_;
};

/// One value of a document, or the absence of one. Parents and errors must outlive it.
class JsonNode {
public:
  JsonNode(JsonErrors& errors, const nlohmann::json& root) : errors_{errors}, value_{&root} {}

  /// Expects an object that has all the required keys and, beyond the optional ones, no others.
  void object(std::initializer_list<std::string_view> required, std::initializer_list<std::string_view> optional = {});
  /// The same for formats that allow keys which are not known here.
  void objectWith(std::initializer_list<std::string_view> required) const;
  [[nodiscard]] JsonNode operator[](std::string_view key) const;
  [[nodiscard]] JsonNode operator[](std::size_t index) const;
  [[nodiscard]] bool present() const { return value_ != nullptr; }
  [[nodiscard]] bool isNull() const;

  /// A number in [low, high], `unit` for the error sentence.
  [[nodiscard]] double number(double low, double high, const Sentence& unit) const;
  [[nodiscard]] int integer(int low, int high) const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string text(std::size_t shortest, std::size_t longest) const;
  /// Index of the text among the choices; 0 with an error when it is none.
  [[nodiscard]] std::size_t choice(const std::vector<std::string_view>& choices) const;
  /// Number of elements; 0 with an error when it is no array of that many.
  [[nodiscard]] std::size_t array(std::size_t fewest, std::size_t most) const;
  /// Reads every element by read(JsonNode); stops at the first error.
  template <class Read>
  auto list(std::size_t fewest, std::size_t most, Read read) const {
    std::vector<decltype(read(*this))> items;
    const std::size_t n = array(fewest, most);
    items.reserve(n);
    for (std::size_t i = 0; i < n && !errors_.first(); ++i) items.push_back(read((*this)[i]));
    return items;
  }

  /// "expected <expected>, found <what stands there>".
  void fail(const Sentence& expected) const;
  /// The same for a value that must not be shown.
  void secretFail(const Sentence& expected) const;
  [[nodiscard]] bool failed() const { return errors_.first().has_value(); }
  [[nodiscard]] std::string pointer() const;

private:
  JsonNode(const JsonNode& parent, const nlohmann::json* value, std::string_view key, std::size_t index)
      : errors_{parent.errors_}, value_{value}, parent_{&parent}, key_{key}, index_{index} {}

  JsonErrors& errors_;
  const nlohmann::json* value_;
  const JsonNode* parent_ = nullptr;
  std::string_view key_;  ///< in an object; empty in an array
  std::size_t index_ = 0;
};

/// The longest text of a document, in bytes.
inline constexpr std::size_t kMostJson = std::size_t{64} << 20;

/// Parses a text from anywhere and hands its root to `read`. Error: names `name` (the file), and the JSON pointer or
/// the line and column. what: "a site".
[[nodiscard]] Result<void> readDocument(std::string_view text, const std::string& name, const Sentence& what,
                                        const std::function<void(const JsonNode&)>& read);

}  // namespace tessera::floor
