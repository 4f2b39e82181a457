#include "floor/tag_table.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace tessera::floor {
Result<std::shared_ptr<const TagTable>> TagTable::build(std::vector<PlacedTag> tags) {
  if (tags.size() >= std::numeric_limits<std::uint32_t>::max() / 4)
    return failure(phrase("Core", "The site has too many tags."));
  std::shared_ptr<TagTable> table{new TagTable};
  table->sortIntoGrid(std::move(tags));
  if (auto hashed = table->hashTags(); !hashed) return tl::unexpected{std::move(hashed.error())};
  return table;
}

void TagTable::sortIntoGrid(std::vector<PlacedTag> tags) {
  if (tags.empty()) {
    cellStart_.assign(2, 0);
    return;
  }
  const auto byX = [](const PlacedTag& a, const PlacedTag& b) { return a.place.x < b.place.x; };
  const auto byY = [](const PlacedTag& a, const PlacedTag& b) { return a.place.y < b.place.y; };
  const auto [west, east] = std::minmax_element(tags.begin(), tags.end(), byX);
  const auto [south, north] = std::minmax_element(tags.begin(), tags.end(), byY);
  grid_.left = west->place.x.value();
  grid_.bottom = south->place.y.value();
  const double width = east->place.x.value() - grid_.left;
  const double height = north->place.y.value() - grid_.bottom;
  // A cell of 0.3 m holds a few tags of any usual floor. Where tags lie far apart it grows, so that the grid never
  // has many more cells than there are tags.
  const double most = 2.0 * static_cast<double>(tags.size()) + 16.0;
  grid_.cellSize = 0.3;
  while ((std::floor(width / grid_.cellSize) + 1.0) * (std::floor(height / grid_.cellSize) + 1.0) > most)
    grid_.cellSize *= 1.5;
  grid_.columns = static_cast<std::size_t>(width / grid_.cellSize) + 1;
  grid_.rows = static_cast<std::size_t>(height / grid_.cellSize) + 1;

  cellStart_.assign(grid_.columns * grid_.rows + 1, 0);
  for (const PlacedTag& tag : tags) ++cellStart_[cellOf(tag) + 1];
  for (std::size_t c = 1; c < cellStart_.size(); ++c) cellStart_[c] += cellStart_[c - 1];
  std::vector<std::uint32_t> next{cellStart_.begin(), cellStart_.end() - 1};
  tags_.resize(tags.size());
  for (const PlacedTag& tag : tags) tags_[next[cellOf(tag)]++] = tag;
}

// UIDs chosen to collide would make look-ups slow: a table with a long probe is laid out anew with another salt.
Result<void> TagTable::hashTags() {
  const std::size_t capacity = std::bit_ceil(2 * tags_.size() + 2);
  for (salt_ = 0; salt_ < 16; ++salt_) {
    std::size_t filled = 0;
    table_.assign(capacity, {});
    while (filled < tags_.size()) {
      const PlacedTag& tag = tags_[filled];
      const auto slot = freeSlot(tag.uid);
      if (!slot) break;
      if (!table_[*slot].uid.empty())
        return failure(phrase("Core", "Tag %1 is registered at two places.").with(tag.uid.text()));
      table_[*slot] = {tag.uid, tag.place};
      ++filled;
    }
    if (filled == tags_.size()) return {};
  }
  return failure(phrase("Core", "The UIDs of the site's tags cannot be told apart quickly."));
}

std::optional<std::size_t> TagTable::freeSlot(const TagUid& uid) const {
  constexpr std::size_t longestProbe = 256;
  const std::size_t mask = table_.size() - 1;
  std::size_t at = uid.hash(salt_) & mask;
  for (std::size_t probes = 0; probes <= longestProbe; ++probes, at = (at + 1) & mask)
    if (table_[at].uid.empty() || table_[at].uid == uid) return at;
  return std::nullopt;
}

std::optional<Point> TagTable::find(const TagUid& uid) const {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t at = uid.hash(salt_) & mask; !table_[at].uid.empty(); at = (at + 1) & mask)
    if (table_[at].uid == uid) return table_[at].place;
  return std::nullopt;
}

}  // namespace tessera::floor
