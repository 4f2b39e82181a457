// The vehicle's battery: its voltage sinks as charge is drawn, and under load at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "base/units.h"

namespace tessera::sim {

struct BatteryParameters {
  double fullVolts = 12.8;   ///< at rest
  double emptyVolts = 11.0;  ///< at rest; linear in between
  double ampereHours = 7.0;
  double ohms = 0.12;          ///< inner resistance
  double idleAmperes = 0.35;   ///< electronics, readers, radio
  double motorAmperes = 1.5;   ///< of one motor at full duty
  double chargeAtStart = 1.0;  ///< 0 empty to 1 full
};

class Battery {
public:
  explicit Battery(const BatteryParameters& parameters)
      : parameters_{parameters}, charge_{std::clamp(parameters.chargeAtStart, 0.0, 1.0)} {}

  void step(Seconds dt, const std::array<int, 2>& duty) {
    const double driven = (std::abs(duty[0]) + std::abs(duty[1])) / 1000.0;
    amperes_ = parameters_.idleAmperes + parameters_.motorAmperes * driven;
    charge_ = std::max(0.0, charge_ - amperes_ * dt.value() / 3600.0 / parameters_.ampereHours);
  }
  [[nodiscard]] double volts() const {
    const double atRest = parameters_.emptyVolts + (parameters_.fullVolts - parameters_.emptyVolts) * charge_;
    return atRest - amperes_ * parameters_.ohms;
  }
  [[nodiscard]] double charge() const { return charge_; }

private:
  BatteryParameters parameters_;
  double charge_;
  double amperes_ = 0.0;
};

}  // namespace tessera::sim
