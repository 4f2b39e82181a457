// A text from anywhere as a JSON document: bounded before it is parsed, and every failure a sentence.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "floor/json_node.h"

namespace tessera::floor {
namespace {

using nlohmann::json;

constexpr int kMaxDepth = 16;

// Brackets outside of texts; a document that nests deeper is none of ours, whatever else it holds.
bool tooDeep(std::string_view text) {
  int depth = 0;
  bool inText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inText && c == '\\') {
      ++i;
    } else if (c == '"') {
      inText = !inText;
    } else if (!inText && (c == '[' || c == '{')) {
      if (++depth > kMaxDepth) return true;
    } else if (!inText && (c == ']' || c == '}')) {
      --depth;
    }
  }
  return false;
}

Sentence lineAndColumn(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t start = before.rfind('\n');
  const std::size_t column = start == std::string_view::npos ? before.size() + 1 : before.size() - start;
  return phrase("Core", "line %1, column %2").with(line, column);
}

}  // namespace

Result<void> readDocument(std::string_view text, const std::string& name, const Sentence& what,
                          const std::function<void(const JsonNode&)>& read) {
  if (text.size() > kMostJson)
    return failure(phrase("Core", "%1: expected %2 of at most 64 MiB, found more.").with(name, what));
  if (tooDeep(text))
    return failure(phrase("Core", "%1: expected %2, found a text that nests deeper than 16 levels.").with(name, what));
  try {
    JsonErrors errors{name};
    const json document = parseJson(text, errors);
    read(JsonNode{errors, document});
    if (errors.first()) return tl::unexpected{*errors.first()};
    return {};
  } catch (const json::parse_error& e) {
    return failure(phrase("Core", "%1: %2: expected JSON (RFC 8259), found something else.")
                       .with(name, lineAndColumn(text, e.byte)));
  } catch (const json::exception&) {
    return failure(phrase("Core", "%1: expected JSON (RFC 8259) with numbers of usual size, found a number too large.")
                       .with(name));
  }
}

}  // namespace tessera::floor
