#include "region/box_finder.h"

#include <numeric>

namespace tessera::region {

BoxFinder::BoxFinder(const std::vector<Box>& boxes) : tree_{boxes}, nowAt_(boxes.size()) {
  std::iota(nowAt_.begin(), nowAt_.end(), 0U);
}

void BoxFinder::remember(std::span<const std::uint32_t> nowAt) {
  for (std::uint32_t& at : nowAt_)
    if (at != kGone) at = nowAt[at];
  std::erase_if(changed_, [&](auto& one) { return (one.second = nowAt[one.second]) == kGone; });
}

}  // namespace tessera::region
