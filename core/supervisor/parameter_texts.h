// What an operator calls a vehicle's parameters and actions, and in what unit a parameter's number counts.
#pragma once

#include <cstdint>

#include "base/sentence.h"
#include "supervisor/event.h"

namespace tessera::supervisor {

/// "the stop distance"; "parameter 99" for a number that the protocol does not have.
[[nodiscard]] Sentence parameterName(std::uint8_t number);
/// A parameter's value with its unit: "250 mm", "300/65536 turn"; the bare number where there is no unit.
[[nodiscard]] Sentence parameterValue(std::uint8_t number, std::int32_t value);
/// "calibrating the compass"; "action 99" for a number that the protocol does not have.
[[nodiscard]] Sentence actionName(std::uint8_t number);
/// Of wire::Parameter::CompassSample and those after it.
[[nodiscard]] bool isCompassSample(std::uint8_t number);
/// One of the many answers of a measurement, which a program collects and nobody reads in a list.
[[nodiscard]] bool isSample(const Event& event);

}  // namespace tessera::supervisor
