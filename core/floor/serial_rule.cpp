#include "floor/serial_rule.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

namespace tessera::floor {

std::string serialOf(const SerialRule& rule, std::int64_t number) {
  const std::string digits = std::to_string(number);
  const auto least = static_cast<std::size_t>(std::max(rule.digits, 0));
  return rule.prefix + std::string(least > digits.size() ? least - digits.size() : 0, '0') + digits;
}

SerialRule serialRuleOf(const Site& site) {
  for (auto tile = site.tiles.rbegin(); tile != site.tiles.rend(); ++tile) {
    const std::string_view serial = tile->serial;
    std::size_t from = serial.size();
    // No more digits than a number can hold: what stands before them belongs to the prefix.
    while (from > 0 && serial.size() - from < SerialRule::kMostDigits && serial[from - 1] >= '0' &&
           serial[from - 1] <= '9')
      --from;
    if (from == serial.size()) continue;
    const std::string digits{serial.substr(from)};
    return {std::string{serial.substr(0, from)}, static_cast<int>(digits.size()), std::stoll(digits) + 1};
  }
  return {};
}

std::vector<std::string> freeSerials(const Site& site, const SerialRule& rule, std::size_t count) {
  std::unordered_set<std::string_view> taken;
  taken.reserve(site.tiles.size());
  for (const Tile& tile : site.tiles) taken.insert(tile.serial);
  std::vector<std::string> serials;
  serials.reserve(count);
  for (std::int64_t number = std::max<std::int64_t>(rule.next, 0); serials.size() < count; ++number) {
    std::string serial = serialOf(rule, number);
    if (!taken.contains(serial)) serials.push_back(std::move(serial));
  }
  return serials;
}

}  // namespace tessera::floor
