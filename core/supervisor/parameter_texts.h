// What an operator calls a vehicle's parameters and actions, and in what unit a parameter's number counts.
#pragma once

#include <cstdint>
#include <string>

namespace tessera::supervisor {

/// "the stop distance"; "parameter 99" for a number that the protocol does not have.
[[nodiscard]] std::string parameterName(std::uint8_t number);
/// A parameter's value with its unit: "250 mm", "300/65536 turn"; the bare number where there is no unit.
[[nodiscard]] std::string parameterValue(std::uint8_t number, std::int32_t value);
/// "calibrating the compass"; "action 99" for a number that the protocol does not have.
[[nodiscard]] std::string actionName(std::uint8_t number);

}  // namespace tessera::supervisor
