// A text from anywhere as a JSON document: bounded before it is parsed, and every failure a sentence.
#include <algorithm>

#include "floor/json_parse.h"

namespace tessera::floor {
namespace {

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
  JsonErrors errors{name};
  const ParsedJson document = parseJson(text, errors);
  switch (document.outcome) {
    case JsonOutcome::TooDeep:
      return failure(
          phrase("Core", "%1: expected %2, found a text that nests deeper than 16 levels.").with(name, what));
    case JsonOutcome::NoJson:
      return failure(phrase("Core", "%1: %2: expected JSON (RFC 8259), found something else.")
                         .with(name, lineAndColumn(text, document.byte)));
    case JsonOutcome::NumberTooLarge:
      return failure(
          phrase("Core", "%1: expected JSON (RFC 8259) with numbers of usual size, found a number too large.")
              .with(name));
    case JsonOutcome::Good:
      break;
  }
  read(JsonNode{errors, document.value});
  if (errors.first()) return tl::unexpected{*errors.first()};
  return {};
}

}  // namespace tessera::floor
