#include "sitecheck/serial_index.h"

#include <bit>
#include <functional>

namespace tessera::sitecheck {
namespace {

std::size_t hashOf(std::string_view serial) { return std::hash<std::string_view>{}(serial); }

}  // namespace

SerialIndex::SerialIndex(const std::vector<floor::Tile>& tiles) {
  hashes_.reserve(tiles.size());
  for (const floor::Tile& tile : tiles) hashes_.push_back(hashOf(tile.serial));
  fill(tiles);
}

void SerialIndex::fill(const std::vector<floor::Tile>& tiles) {
  table_.assign(std::bit_ceil(2 * tiles.size() + 2), 0);
  twins_.clear();
  for (std::uint32_t i = 0; i < tiles.size(); ++i) {
    const std::size_t slot = slotOf(tiles, tiles[i].serial, hashes_[i]);
    if (table_[slot] == 0)
      table_[slot] = i + 1;
    else
      twins_.emplace_back(table_[slot] - 1, i);
  }
}

std::size_t SerialIndex::slotOf(const std::vector<floor::Tile>& tiles, std::string_view serial,
                                std::size_t hash) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t at = hash & mask;
  while (table_[at] != 0 && (hashes_[table_[at] - 1] != hash || tiles[table_[at] - 1].serial != serial))
    at = (at + 1) & mask;
  return at;
}

std::uint32_t SerialIndex::find(const std::vector<floor::Tile>& tiles, std::string_view serial) const {
  if (table_.empty()) return kGone;
  const std::uint32_t found = table_[slotOf(tiles, serial, hashOf(serial))];
  return found == 0 ? kGone : found - 1;
}

void SerialIndex::follow(const Alignment& change, const std::vector<floor::Tile>& now) {
  std::vector<std::size_t> hashes(now.size());
  for (std::size_t i = 0; i < now.size(); ++i)
    hashes[i] = change.wasAt[i] == kGone ? hashOf(now[i].serial) : hashes_[change.wasAt[i]];
  hashes_ = std::move(hashes);
  fill(now);
}

}  // namespace tessera::sitecheck
