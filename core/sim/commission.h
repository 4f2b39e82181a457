// Makes a vehicle's EEPROM as its integrator would: settings and key from its setup, and the compass calibration that
// the firmware measured itself, turning on the bench, errors included.
#pragma once

#include <array>
#include <cstdint>

#include "base/result.h"
#include "firmware/vehicle/settings.h"
#include "floor/site.h"
#include "sim/vehicle_body.h"

namespace tessera::sim {

using EepromImage = std::array<std::uint8_t, firmware::kEepromSize>;

/// What the setup says in the firmware's own terms. Error: a value that the firmware does not take; names it.
/// The declination is 0: the site's angle to north holds it.
[[nodiscard]] Result<firmware::Settings> settingsFor(const floor::VehicleSetup& setup, const floor::RadioSetup& radio,
                                                     const BodyParameters& body);

/// Runs the vehicle on a bench without magnetic spots, in virtual time (about half a minute of it), and has it
/// calibrate its compass. Same parameters and seed as in the world: it is the same body. Error: a sentence.
[[nodiscard]] Result<EepromImage> commissionEeprom(const floor::VehicleSetup& setup, const floor::Site& site,
                                                   const BodyParameters& body, std::uint64_t seed);

}  // namespace tessera::sim
