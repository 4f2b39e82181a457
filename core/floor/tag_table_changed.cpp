// A table of tags made of another one in which a few are elsewhere: copied and mended instead of sorted and hashed.
#include <algorithm>

#include "floor/tag_table.h"

namespace tessera::floor {

std::shared_ptr<const TagTable> TagTable::changed(std::span<const TagUid> removed,
                                                  std::span<const PlacedTag> added) const {
  if (tags_.empty() || tags_.size() < removed.size()) return nullptr;
  const std::size_t count = tags_.size() - removed.size() + added.size();
  if (count == 0 || 2 * count + 2 > table_.size()) return nullptr;
  if (!std::all_of(added.begin(), added.end(), [this](const PlacedTag& tag) { return isInGrid(tag.place); }))
    return nullptr;
  std::vector<std::size_t> gone;
  for (const TagUid& uid : removed) {
    const auto place = find(uid);
    if (!place) return nullptr;
    gone.push_back(indexOf({uid, *place}));
  }
  std::sort(gone.begin(), gone.end());
  if (std::adjacent_find(gone.begin(), gone.end()) != gone.end()) return nullptr;

  std::shared_ptr<TagTable> table{new TagTable};
  table->grid_ = grid_;
  table->cellStart_ = cellStart_;
  table->table_ = table_;
  table->salt_ = salt_;
  for (const TagUid& uid : removed) table->takeOut(*table->freeSlot(uid));
  std::vector<PlacedTag> fresh{added.begin(), added.end()};
  std::stable_sort(fresh.begin(), fresh.end(),
                   [this](const PlacedTag& a, const PlacedTag& b) { return cellOf(a) < cellOf(b); });

  // Both lists are in the order of cells. A new tag stands behind those of its cell that were there before.
  table->tags_.reserve(count);
  auto nextGone = gone.begin();
  auto nextFresh = fresh.begin();
  std::size_t at = 0;
  while (at < tags_.size() || nextFresh != fresh.end()) {
    const std::size_t stop = nextGone == gone.end() ? tags_.size() : *nextGone;
    const std::size_t before = nextFresh == fresh.end() ? tags_.size() : cellStart_[cellOf(*nextFresh) + 1];
    const std::size_t end = std::min(stop, before);
    if (end > at) {
      table->tags_.insert(table->tags_.end(), tags_.begin() + static_cast<std::ptrdiff_t>(at),
                          tags_.begin() + static_cast<std::ptrdiff_t>(end));
      at = end;
    }
    if (nextFresh != fresh.end() && before <= at) {
      table->tags_.push_back(*nextFresh++);
    } else if (nextGone != gone.end() && *nextGone == at) {
      ++nextGone, ++at;
    }
  }

  std::vector<std::size_t> goneCells;
  for (const std::size_t index : gone) goneCells.push_back(cellOf(tags_[index]));
  auto nextGoneCell = goneCells.begin();
  nextFresh = fresh.begin();
  std::uint32_t shift = 0;  // modulo 2^32
  for (std::size_t cell = 0; cell + 1 < cellStart_.size(); ++cell) {
    for (; nextGoneCell != goneCells.end() && *nextGoneCell == cell; ++nextGoneCell) --shift;
    for (; nextFresh != fresh.end() && cellOf(*nextFresh) == cell; ++nextFresh) ++shift;
    table->cellStart_[cell + 1] += shift;
  }

  for (const PlacedTag& tag : fresh) {
    const auto slot = table->freeSlot(tag.uid);
    if (!slot || !table->table_[*slot].uid.empty()) return nullptr;
    table->table_[*slot] = {tag.uid, tag.place};
  }
  return table;
}

std::size_t TagTable::indexOf(const PlacedTag& tag) const {
  std::size_t index = cellStart_[cellOf(tag)];
  while (!(tags_[index].uid == tag.uid)) ++index;
  return index;
}

// Closes the gap behind it: with linear probing no look-up may meet an empty slot before its tag.
void TagTable::takeOut(std::size_t slot) {
  const std::size_t mask = table_.size() - 1;
  std::size_t gap = slot;
  for (std::size_t at = (gap + 1) & mask; !table_[at].uid.empty(); at = (at + 1) & mask) {
    const std::size_t home = table_[at].uid.hash(salt_) & mask;
    if (((at - home) & mask) < ((at - gap) & mask)) continue;  // it began its way behind the gap
    table_[gap] = table_[at];
    gap = at;
  }
  table_[gap] = {};
}

}  // namespace tessera::floor
