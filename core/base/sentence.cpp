#include "base/sentence.h"

#include <optional>
#include <ostream>
#include <utility>

namespace tessera {

struct Sentence::Content {
  std::optional<Pattern> pattern;
  std::vector<Sentence> arguments;
  std::string english;
  std::string kept;  ///< a pattern that is no literal
};

namespace {

std::string englishOf(const char* pattern, std::span<const Sentence> arguments) {
  std::vector<std::string> words;
  words.reserve(arguments.size());
  for (const Sentence& argument : arguments) words.push_back(argument.english());
  return filledIn(pattern, words);
}

}  // namespace

Sentence::Sentence(Pattern pattern, std::vector<Sentence> arguments) {
  std::string english = englishOf(pattern.english(), arguments);
  content_ = std::make_shared<const Content>(Content{pattern, std::move(arguments), std::move(english), {}});
}

Sentence::Sentence(std::string text) {
  if (!text.empty()) content_ = std::make_shared<const Content>(Content{std::nullopt, {}, std::move(text), {}});
}

Sentence Sentence::restored(std::string pattern, std::vector<Sentence> arguments) {
  const auto content = std::make_shared<Content>();
  content->kept = std::move(pattern);
  content->pattern = Pattern{"Core", content->kept};
  content->english = englishOf(content->kept.c_str(), arguments);
  content->arguments = std::move(arguments);
  return Sentence{std::shared_ptr<const Content>{content}};
}

const std::string& Sentence::english() const {
  static const std::string kNothing;
  return content_ ? content_->english : kNothing;
}

const Pattern* Sentence::pattern() const { return content_ && content_->pattern ? &*content_->pattern : nullptr; }

std::span<const Sentence> Sentence::arguments() const {
  return content_ ? std::span<const Sentence>{content_->arguments} : std::span<const Sentence>{};
}

std::ostream& operator<<(std::ostream& out, const Sentence& sentence) { return out << sentence.english(); }

std::string filledIn(std::string_view pattern, std::span<const std::string> arguments) {
  std::string filled;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool number = pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' && pattern[i + 1] <= '9';
    const std::size_t which = number ? static_cast<std::size_t>(pattern[i + 1] - '1') : arguments.size();
    if (which < arguments.size()) {
      filled += arguments[which];
      ++i;
    } else {
      filled += pattern[i];
    }
  }
  return filled;
}

}  // namespace tessera
