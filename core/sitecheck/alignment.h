// Which items of a list are still there after an edit, and which have come or gone: for edits that touch some of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tessera::sitecheck {

inline constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();

struct Alignment {
  std::vector<std::uint32_t> nowAt;  ///< of each item before: its index now, or kGone; ascending
  std::vector<std::uint32_t> wasAt;  ///< of each item now: its index before, or kGone
  std::vector<std::uint32_t> gone;   ///< indices before
  std::vector<std::uint32_t> fresh;  ///< indices now
};

/// Nothing: too much is another to be worth it, or items were taken out and put in at once. An item that was replaced
/// in its place counts as gone and fresh.
template <class Item, class Same>
std::optional<Alignment> aligned(const std::vector<Item>& before, const std::vector<Item>& now, const Same& same) {
  const std::size_t shorter = std::min(before.size(), now.size());
  std::size_t head = 0;
  while (head < shorter && same(before[head], now[head])) ++head;
  std::size_t tail = 0;
  while (tail < shorter - head && same(before[before.size() - 1 - tail], now[now.size() - 1 - tail])) ++tail;
  const std::size_t most = std::max<std::size_t>(64, shorter / 8);
  Alignment a{std::vector<std::uint32_t>(before.size(), kGone), std::vector<std::uint32_t>(now.size(), kGone), {}, {}};
  const auto pair = [&a](std::size_t i, std::size_t j) {
    a.nowAt[i] = static_cast<std::uint32_t>(j);
    a.wasAt[j] = static_cast<std::uint32_t>(i);
  };
  for (std::size_t i = 0; i < head; ++i) pair(i, i);
  for (std::size_t i = 1; i <= tail; ++i) pair(before.size() - i, now.size() - i);
  std::size_t i = head;
  std::size_t j = head;
  const std::size_t beforeEnd = before.size() - tail;
  const std::size_t nowEnd = now.size() - tail;
  while ((i < beforeEnd || j < nowEnd) && a.gone.size() + a.fresh.size() <= most) {
    if (i < beforeEnd && j < nowEnd && same(before[i], now[j])) {
      pair(i++, j++);
      continue;
    }
    // As many after as before: they were changed in their places. Else the longer list has what the other lacks.
    const std::size_t left = beforeEnd - i;
    const std::size_t right = nowEnd - j;
    if (left >= right && left > 0) a.gone.push_back(static_cast<std::uint32_t>(i++));
    if (right >= left && right > 0) a.fresh.push_back(static_cast<std::uint32_t>(j++));
  }
  if (i < beforeEnd || j < nowEnd) return std::nullopt;
  return a;
}

}  // namespace tessera::sitecheck
