// A sentence for people that remembers how it was made, so that the window can show it in another language: a pattern,
// which is looked up, and the arguments that go into it. It reads as English by itself.
//
// Patterns are written as phrase("Core", "..."), each a whole sentence or a whole part of one, always with two plain
// literals. Qt's lupdate collects them all under the context Core with
//   lupdate -tr-function-alias QT_TRANSLATE_NOOP+=phrase ...
// and the window translates them (ui/base/wording.h).
#pragma once

#include <concepts>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tessera {

class Sentence;

/// English with %1 to %9 where the arguments go.
class Pattern {
public:
  consteval Pattern(const char* context, const char* english) : context_{context}, english_{english} {}
  [[nodiscard]] constexpr const char* context() const { return context_; }
  [[nodiscard]] constexpr const char* english() const { return english_; }
  /// Arguments are names and numbers as text, integers, and other sentences or patterns, which are translated too.
  template <class... Arguments>
  [[nodiscard]] Sentence with(const Arguments&... arguments) const;

private:
  friend class Sentence;
  constexpr Pattern(const char* context, const std::string& kept) : context_{context}, english_{kept.c_str()} {}

  const char* context_;
  const char* english_;
};

[[nodiscard]] consteval Pattern phrase(const char* context, const char* english) { return {context, english}; }

/// Immutable; a copy shares its content and costs next to nothing. Any thread may keep and read one.
class Sentence {
public:
  Sentence() = default;
  // NOLINTBEGIN(google-explicit-constructor): a text of any kind is meant wherever a sentence is asked for.
  Sentence(Pattern pattern) : Sentence{pattern, {}} {}
  Sentence(Pattern pattern, std::vector<Sentence> arguments);
  /// A sentence that was kept, in a journal say, as its pattern (of the context Core) and its arguments.
  [[nodiscard]] static Sentence restored(std::string pattern, std::vector<Sentence> arguments);
  // What is shown as it is, in every language: a name, a number, a text from elsewhere.
  Sentence(std::string text);
  Sentence(const char* text) : Sentence{std::string{text}} {}
  // NOLINTEND(google-explicit-constructor)
  template <std::integral Number>
  explicit Sentence(Number number) : Sentence{std::to_string(number)} {}

  [[nodiscard]] const std::string& english() const;
  operator const std::string&() const { return english(); }  // NOLINT(google-explicit-constructor): the same way back
  [[nodiscard]] bool empty() const { return english().empty(); }
  /// Nullptr: a text that is shown as it is.
  [[nodiscard]] const Pattern* pattern() const;
  /// For %1, %2 and so on.
  [[nodiscard]] std::span<const Sentence> arguments() const;

  /// Equal when they read the same.
  friend bool operator==(const Sentence& a, const Sentence& b) { return a.english() == b.english(); }
  template <class Text>
  requires(std::convertible_to<const Text&, std::string_view> && !std::derived_from<Text, Sentence>) friend bool
  operator==(const Sentence& a, const Text& b) {
    return std::string_view{a.english()} == std::string_view{b};
  }
  friend std::ostream& operator<<(std::ostream& out, const Sentence& sentence);

private:
  struct Content;
  explicit Sentence(std::shared_ptr<const Content> content) : content_{std::move(content)} {}
  std::shared_ptr<const Content> content_;  ///< null: empty
};

/// Puts arguments for %1 to %9 into a pattern, in one go: what an argument contains is not looked at again. A number
/// without an argument stays.
[[nodiscard]] std::string filledIn(std::string_view pattern, std::span<const std::string> arguments);

template <class... Arguments>
Sentence Pattern::with(const Arguments&... arguments) const {
  return {*this, {Sentence(arguments)...}};
}

}  // namespace tessera
