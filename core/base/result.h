// Failures that come from outside are values: a sentence that says what is wrong and where.
#pragma once

#include <tl/expected.hpp>
#include <utility>

#include "base/sentence.h"

namespace tessera {

struct Error {
  Sentence sentence;  ///< complete, names the file, field or port concerned; the window says it in its own language
  bool operator==(const Error&) const = default;
};

template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> failure(Sentence sentence) {
  return tl::unexpected<Error>{Error{std::move(sentence)}};
}

/// The failure of one result as that of another, whose value is of another type.
template <class T>
[[nodiscard]] tl::unexpected<Error> passOn(const Result<T>& failed) {
  return tl::unexpected<Error>{failed.error()};
}

}  // namespace tessera
