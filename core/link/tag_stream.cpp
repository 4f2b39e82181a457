#include "link/tag_stream.h"

namespace tessera::link {

TagStream::Taken TagStream::take(const wire::Report& report, Seconds sampledAt) {
  Taken taken;
  if (!synchronous_) next_ = report.firstEvent;
  synchronous_ = true;
  for (std::size_t i = 0; i < report.eventCount; ++i) {
    const auto number = static_cast<std::uint8_t>(report.firstEvent + i);
    // Numbers are modulo 256: the nearer way round tells old from new.
    const auto ahead = static_cast<std::int8_t>(static_cast<std::uint8_t>(number - next_));
    if (ahead < 0) continue;
    taken.lost += static_cast<unsigned>(ahead);
    const wire::TagEvent& event = report.events[i];
    const Seconds age{event.age * wire::kAgeUnitMs / 1000.0};
    taken.fresh.push_back({event, sampledAt - age, event.age == 255});
    next_ = static_cast<std::uint8_t>(number + 1);
  }
  return taken;
}

}  // namespace tessera::link
