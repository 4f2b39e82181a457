// What an operator calls a vehicle's parameters and actions, and in what unit a parameter's number counts.
#pragma once

#include <cstdint>

#include "base/sentence.h"

namespace tessera::supervisor {

/// "the stop distance"; "parameter 99" for a number that the protocol does not have.
[[nodiscard]] Sentence parameterName(std::uint8_t number);
/// A parameter's value with its unit: "250 mm", "300/65536 turn"; the bare number where there is no unit.
[[nodiscard]] Sentence parameterValue(std::uint8_t number, std::int32_t value);
/// "calibrating the compass"; "action 99" for a number that the protocol does not have.
[[nodiscard]] Sentence actionName(std::uint8_t number);

}  // namespace tessera::supervisor
