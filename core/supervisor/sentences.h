// The supervisor's English: every sentence that an operator reads about faults, requests and waiting stands here.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/sentence.h"
#include "base/units.h"
#include "floor/site.h"
#include "link/link_event.h"
#include "wire/messages.h"
#include "wire/parameters.h"

namespace tessera::supervisor {

/// What is told about one bit of Report::faults; %1 is the vehicle's name.
struct FaultText {
  wire::Fault bit;
  bool error;     ///< it stops the vehicle or spoils its work
  Seconds quiet;  ///< how long it must stay away to be over
  Pattern begins;
  Pattern ends;
};
[[nodiscard]] const std::array<FaultText, 13>& faultTexts();

/// A vehicle's answer to a request, or that there was none. `vehicle`: its name.
[[nodiscard]] Sentence answerSentence(const Sentence& vehicle, const link::Answered& answered);

/// How the giving of another key has ended, and what to do about it. `vehicle`: its name.
[[nodiscard]] Sentence pairingSentence(const Sentence& vehicle, link::PairingEnd how);

/// Why a vehicle started anew: "its power was switched on", "its watchdog ended a hang" and so on.
[[nodiscard]] Pattern causeText(wire::ResetCause cause);

/// A vehicle's name for people; its address where it has none.
[[nodiscard]] Sentence vehicleName(const floor::VehicleSetup& setup);

/// A number with a fixed count of decimals, independent of the locale.
[[nodiscard]] std::string decimal(double value, int decimals);

}  // namespace tessera::supervisor
