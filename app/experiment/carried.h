// A vehicle lifted and set down elsewhere in the middle of its drive: where, and how far it then drove until the
// locator had it again.
#pragma once

#include <optional>
#include <vector>

#include "app/experiment/samples.h"

namespace tessera::experiment {

inline constexpr Metres kFoundWithin{0.05};  ///< error of the place ...
inline constexpr Seconds kFoundFor{1.0};     ///< ... and for how long it must not be exceeded

/// True way from `at` to the instant from which on the locator said "located", without doubt, and was right for
/// kFoundFor. Nullopt: never.
[[nodiscard]] std::optional<Metres> foundAfter(const std::vector<Sample>& samples, Seconds at);

/// Ticks after `at` at which the locator said "located", without doubt, while it was off by more than 10 cm, in
/// seconds.
[[nodiscard]] Seconds wronglySure(const std::vector<Sample>& samples, Seconds at);

}  // namespace tessera::experiment
