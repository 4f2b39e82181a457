// How much of the stack was ever used: it is painted at the start, and what still shows paint was never touched.
#pragma once

#include <cstdint>
#include <span>

namespace tessera::firmware::lm3s6965 {

inline constexpr std::uint32_t kPaint = 0xA5A5F00D;

/// The stack grows down; `stack` runs from its lowest word up.
[[nodiscard]] inline std::uint32_t paintedBytes(std::span<const volatile std::uint32_t> stack) {
  std::uint32_t words = 0;
  while (words < stack.size() && stack[words] == kPaint) ++words;
  return words * static_cast<std::uint32_t>(sizeof(std::uint32_t));
}

}  // namespace tessera::firmware::lm3s6965
