// Serial numbers by rule: a prefix and a number of so many digits, as "T-0001".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "floor/site.h"

namespace tessera::floor {

struct SerialRule {
  static constexpr int kMostDigits = 9;

  std::string prefix = "T-";
  int digits = 4;         ///< at least; larger numbers get as many as they need
  std::int64_t next = 1;  ///< numbers are taken from here on, those that are given left out
  bool operator==(const SerialRule&) const = default;
};

[[nodiscard]] std::string serialOf(const SerialRule& rule, std::int64_t number);

/// As the site's last tile with a number at its end is called, from the next number on; "T-0001" where there is none.
[[nodiscard]] SerialRule serialRuleOf(const Site& site);

/// Different ones that no tile of the site has, laid or not.
[[nodiscard]] std::vector<std::string> freeSerials(const Site& site, const SerialRule& rule, std::size_t count);

}  // namespace tessera::floor
