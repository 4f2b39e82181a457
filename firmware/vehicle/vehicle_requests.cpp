// What the host asks of the vehicle besides driving: parameters and actions.
#include "firmware/vehicle/vehicle.h"

namespace tessera::firmware {
namespace {

using wire::Outcome;
using wire::Parameter;

constexpr Micros kRestartPatience = 300ms;  // for the answer to leave and the settings to be written

}  // namespace

void Vehicle::handle(const wire::Request& request, Micros now) {
  std::int32_t value = 0;
  Outcome outcome = Outcome::Unknown;
  const auto parameter = static_cast<Parameter>(request.parameter);
  switch (request.type) {
    case wire::MessageType::Get:
      outcome = get(parameter, value);
      break;
    case wire::MessageType::Set:
      outcome = set(parameter, request.value);
      get(parameter, value);
      break;
    default:
      outcome = act(static_cast<wire::Action>(request.parameter), now);
      break;
  }
  session_.answer(outcome, value);
}

Outcome Vehicle::get(Parameter parameter, std::int32_t& value) {
  value = 0;
  switch (parameter) {
    case Parameter::FramesRefused:
      value = static_cast<std::int32_t>(session_.framesRefused());
      return Outcome::Done;
    case Parameter::FramesDamaged:
      value = static_cast<std::int32_t>(radio_.damagedFrames());
      return Outcome::Done;
    case Parameter::LongestTick:
      value = static_cast<std::int32_t>(longestTick_);
      return Outcome::Done;
    case Parameter::StackFree:
      value = static_cast<std::int32_t>(board_.stackFree());
      return Outcome::Done;
    case Parameter::CalibrationOutcome:
      value = static_cast<std::int32_t>(pilot_.calibrationOutcome());
      return Outcome::Done;
    default:
      break;
  }
  const auto direction = static_cast<std::size_t>(parameter) - static_cast<std::size_t>(Parameter::CompassSample);
  if (direction < wire::kCompassSamples) {
    value = pilot_.compassSample(direction);
    return Outcome::Done;
  }
  if (!Settings::has(parameter)) return Outcome::Unknown;
  value = store_.settings().get(parameter);
  return Outcome::Done;
}

// Done means in force; the EEPROM has it some 30 ms later, and kFaultEeprom tells when it could not be written.
Outcome Vehicle::set(Parameter parameter, std::int32_t value) {
  Settings settings = store_.settings();
  const Outcome outcome = settings.set(parameter, value);
  if (outcome == Outcome::Done && settings != store_.settings()) {
    store_.save(settings);
    use(settings);
  }
  return outcome;
}

Outcome Vehicle::act(wire::Action action, Micros now) {
  switch (action) {
    case wire::Action::CalibrateCompass:
      return pilot_.calibrate(now, true);
    case wire::Action::SurveyCompass:
      return pilot_.calibrate(now, false);
    case wire::Action::Restart:
      restartAt_ = now + kRestartPatience;
      return Outcome::Done;
    case wire::Action::RestoreDefaults: {
      Settings settings = store_.settings();
      settings.restoreDefaults();
      store_.save(settings);
      use(settings);
      return Outcome::Done;
    }
  }
  return Outcome::Unknown;
}

// A Pair that is repeated finds its key in force, or on its way into the EEPROM, and changes nothing.
void Vehicle::pair(const Heard& heard, Micros now) {
  Settings settings = store_.settings();
  const bool known = settings.key == heard.newKey;
  if (keyBefore_ && !known) return;
  session_.pairingBegun(heard.pairing);
  if (keyBefore_) return;
  const wire::VehicleState state = pilot_.state();
  const bool stands = state == wire::VehicleState::Standing || state == wire::VehicleState::Expired ||
                      state == wire::VehicleState::Faulted;
  if (known || !stands) return session_.pairingEnded(known ? Outcome::Done : Outcome::Busy, now);
  keyBefore_ = settings.key;
  settings.key = heard.newKey;
  store_.save(settings);
}

// The new key is in force, and answered with, only once it has been read back: whoever hears it answered has it.
void Vehicle::carryPairingOn(Micros now) {
  if (!keyBefore_ || store_.saving()) return;
  Settings settings = store_.settings();
  if (!store_.faulty()) {
    session_.rekey(settings.key);
    session_.pairingEnded(Outcome::Done, now);
  } else {
    settings.key = *keyBefore_;
    store_.save(settings);
    session_.pairingEnded(Outcome::Failed, now);
  }
  keyBefore_.reset();
}

// Address and radio parameters are looked at in start() only.
void Vehicle::use(const Settings& settings) {
  pilot_.configure(settings);
  readers_.start(settings.get(Parameter::ReaderCount));
}

void Vehicle::keepCalibration() {
  const auto correction = pilot_.takeCalibration();
  if (!correction) return;
  Settings settings = store_.settings();
  if (!keepCorrection(*correction, settings)) return;
  store_.save(settings);
  use(settings);
}

void Vehicle::restartWhenDue(Micros now) {
  if (restartAt_ && now >= *restartAt_) {
    restartAt_.reset();
    board_.restart();
  }
}

}  // namespace tessera::firmware
