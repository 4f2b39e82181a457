// A text as a tree of JSON values, with what JSON leaves open decided: no key twice in an object, no deep nesting.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "floor/json_node.h"

namespace tessera::floor {

enum class JsonOutcome { Good, NoJson, NumberTooLarge, TooDeep };

struct ParsedJson {
  nlohmann::json value;  ///< whole when Good
  JsonOutcome outcome = JsonOutcome::Good;
  std::size_t byte = 0;  ///< NoJson: where the parser stopped, counted from 1
};

/// Deeper than this no document of ours nests.
inline constexpr std::size_t kMaxJsonDepth = 16;

/// The first key that stands twice in one object is added to `errors`: JSON leaves open which of the two counts.
[[nodiscard]] ParsedJson parseJson(std::string_view text, JsonErrors& errors);

/// A key as a JSON pointer (RFC 6901) writes it.
[[nodiscard]] std::string escapedKey(std::string_view key);

}  // namespace tessera::floor
