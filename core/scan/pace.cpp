#include "scan/pace.h"

namespace tessera::scan {

void Pace::registered(Seconds now) {
  if (last_ && now - *last_ <= kLongestBreath) took_.push_back(now - *last_);
  if (took_.size() > kRemembered) took_.pop_front();
  last_ = now;
}

std::optional<Seconds> Pace::perTag() const {
  if (took_.size() < 3) return std::nullopt;
  Seconds all{};
  for (const Seconds s : took_) all += s;
  return all / static_cast<double>(took_.size());
}

std::optional<Seconds> Pace::timeFor(std::size_t tags) const {
  const auto each = perTag();
  return each ? std::optional{static_cast<double>(tags) * *each} : std::nullopt;
}

}  // namespace tessera::scan
