#include "sitecheck/wording.h"

#include <array>
#include <cstdio>

namespace tessera::sitecheck {

std::string figure(double value, int decimals) {
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value == 0.0 ? 0.0 : value);
  return text.data();
}

std::string placeText(Point p) { return "(" + inMetres(p.x) + ", " + inMetres(p.y) + ")"; }

void FaultList::close() {
  if (count_ <= most_) return;
  into_.push_back({kind_,
                   severity_,
                   phrase("Core", "More faults of this kind, not listed one by one: %1.").with(count_ - most_),
                   rest_,
                   {},
                   {},
                   count_ - most_});
}

}  // namespace tessera::sitecheck
