// Finds tiles by serial number, and goes along when tiles come and go. It holds no names: the site does.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "floor/site.h"
#include "sitecheck/alignment.h"

namespace tessera::sitecheck {

class SerialIndex {
public:
  SerialIndex() = default;
  explicit SerialIndex(const std::vector<floor::Tile>& tiles);

  /// Index of the first tile of that serial number, or kGone. `tiles`: those that the index was made of or follows.
  [[nodiscard]] std::uint32_t find(const std::vector<floor::Tile>& tiles, std::string_view serial) const;
  void follow(const Alignment& change, const std::vector<floor::Tile>& now);
  /// Tiles of one serial number: indices of the first and of each later one.
  [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::uint32_t>>& twins() const { return twins_; }

private:
  void fill(const std::vector<floor::Tile>& tiles);
  [[nodiscard]] std::size_t slotOf(const std::vector<floor::Tile>& tiles, std::string_view serial,
                                   std::size_t hash) const;

  std::vector<std::size_t> hashes_;   ///< of each tile's serial number
  std::vector<std::uint32_t> table_;  ///< open addressing, at most half full: index plus one, 0 = empty
  std::vector<std::pair<std::uint32_t, std::uint32_t>> twins_;
};

}  // namespace tessera::sitecheck
