// Failures that come from outside are values: a sentence that says what is wrong and where.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace tessera {

struct Error {
  std::string sentence;  ///< English, complete, names the file, field or port concerned
  bool operator==(const Error&) const = default;
};

template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> failure(std::string sentence) {
  return tl::unexpected<Error>{Error{std::move(sentence)}};
}

/// The failure of one result as that of another, whose value is of another type.
template <class T>
[[nodiscard]] tl::unexpected<Error> passOn(const Result<T>& failed) {
  return tl::unexpected<Error>{failed.error()};
}

}  // namespace tessera
