#include "supervisor/sentences.h"

#include <charconv>

#include "supervisor/parameter_texts.h"

namespace tessera::supervisor {
namespace {

Sentence requestText(const wire::Request& request) {
  switch (request.type) {
    case wire::MessageType::Get:
      return phrase("Core", "reading %1").with(parameterName(request.parameter));
    case wire::MessageType::Set:
      return phrase("Core", "setting %1 to %2")
          .with(parameterName(request.parameter), parameterValue(request.parameter, request.value));
    default:
      return actionName(request.parameter);
  }
}

Sentence outcomeText(const wire::Request& request, const wire::Value& value) {
  const bool ofParameter = request.type == wire::MessageType::Get || request.type == wire::MessageType::Set;
  switch (value.outcome) {
    case wire::Outcome::Done:
      if (!ofParameter) return phrase("Core", "done");
      return phrase("Core", "done, the value is %1").with(parameterValue(request.parameter, value.value));
    case wire::Outcome::Started:
      return phrase("Core", "started");
    case wire::Outcome::Unknown:
      return phrase("Core", "refused, the vehicle does not know it");
    case wire::Outcome::OutOfRange:
      return phrase("Core", "refused, the value is out of range");
    case wire::Outcome::Busy:
      return phrase("Core", "refused, the vehicle is busy");
    case wire::Outcome::Failed:
      return phrase("Core", "failed on the vehicle");
  }
  return phrase("Core", "answered in an unknown way");
}

}  // namespace

const std::array<FaultText, 13>& faultTexts() {
  static constexpr Seconds kSoon{1.0};
  // Bits that say "since the last report" come and go from report to report.
  static constexpr Seconds kFlicker{5.0};
  static constexpr std::array<FaultText, 13> kTexts{{
      {wire::kFaultMotorStall, true, kSoon,
       phrase("Core", "%1 stopped: a wheel does not turn although it is driven. Free it, then clear."),
       phrase("Core", "%1 drives its wheels again.")},
      {wire::kFaultEncoder, true, kSoon,
       phrase("Core", "%1 stopped: a wheel encoder contradicts the drive. Check it, then clear."),
       phrase("Core", "%1 trusts its wheel encoders again.")},
      {wire::kFaultCompass, false, kSoon,
       phrase("Core", "%1 gets no answer from its compass and keeps its heading by the wheels."),
       phrase("Core", "%1 hears its compass again.")},
      {wire::kFaultCompassRange, false, kSoon,
       phrase("Core", "%1 measures a magnetic field that cannot be right and keeps its heading by the wheels."),
       phrase("Core", "%1 measures a plausible magnetic field again.")},
      {wire::kFaultReader, false, kSoon, phrase("Core", "%1 gets no answer from one of its tag readers."),
       phrase("Core", "%1 hears all its tag readers again.")},
      {wire::kFaultBattery, false, kSoon, phrase("Core", "%1 has a low battery."),
       phrase("Core", "%1 has enough battery again.")},
      {wire::kFaultEeprom, true, kSoon,
       phrase("Core",
              "%1 cannot read or write its settings; what was set is lost at the next start. It stands, even when "
              "cleared, if it could not read them."),
       phrase("Core", "%1 reads and writes its settings again.")},
      {wire::kFaultWatchdog, true, kSoon,
       phrase("Core", "%1 was restarted by its watchdog and stands until it is cleared."),
       phrase("Core", "%1 was cleared after its watchdog's restart.")},
      {wire::kFaultRadio, false, kSoon, phrase("Core", "%1 has a radio module that does not take its parameters."),
       phrase("Core", "%1 has a radio module that takes its parameters again.")},
      {wire::kFaultForged, false, kFlicker,
       phrase("Core",
              "%1 refused a command that does not bear its key: a changed byte, or somebody else on the channel."),
       phrase("Core", "%1 gets no more forged commands.")},
      {wire::kFaultReplayed, false, kFlicker,
       phrase("Core", "%1 refused a command that it had seen before: somebody repeats old frames."),
       phrase("Core", "%1 gets no more replayed commands.")},
      {wire::kFaultEventsLost, false, kFlicker,
       phrase("Core", "%1 dropped tag reads because they were not fetched in time."),
       phrase("Core", "%1 has its tag reads fetched in time again.")},
      {wire::kFaultRanger, false, kSoon,
       phrase("Core", "%1 gets no answer from one of its rangers and does not drive forwards."),
       phrase("Core", "%1 hears all its rangers again.")},
  }};
  return kTexts;
}

Sentence answerSentence(const Sentence& vehicle, const link::Answered& answered) {
  const Sentence what = requestText(answered.request);
  if (!answered.value) return phrase("Core", "%1 did not answer: %2 is not confirmed.").with(vehicle, what);
  return phrase("Core", "%1, %2: %3.").with(vehicle, what, outcomeText(answered.request, *answered.value));
}

Sentence pairingSentence(const Sentence& vehicle, link::PairingEnd how) {
  switch (how) {
    case link::PairingEnd::NewKey:
      return phrase("Core", "%1 has the new key.").with(vehicle);
    case link::PairingEnd::OldKey:
      return phrase("Core", "%1 did not hear the new key and has the old one still: bring it nearer and try again.")
          .with(vehicle);
    case link::PairingEnd::Busy:
      return phrase("Core", "%1 takes no other key while it drives: stop it and try again.").with(vehicle);
    case link::PairingEnd::Garbled:
      return phrase("Core", "The new key did not reach %1 whole; it has the old one still: try again.").with(vehicle);
    case link::PairingEnd::Failed:
      return phrase("Core",
                    "%1 could not keep the new key, as its memory fails, and may start with either: keep both keys and "
                    "have its EEPROM looked at.")
          .with(vehicle);
    case link::PairingEnd::Unknown:
      break;
  }
  return phrase("Core", "%1 has not confirmed the new key; it is called with both keys until it answers. Keep both.")
      .with(vehicle);
}

Pattern causeText(wire::ResetCause cause) {
  switch (cause) {
    case wire::ResetCause::PowerOn:
      return phrase("Core", "its power was switched on");
    case wire::ResetCause::Watchdog:
      return phrase("Core", "its watchdog ended a hang");
    case wire::ResetCause::Software:
      return phrase("Core", "it was told to");
    case wire::ResetCause::Other:
      break;
  }
  return phrase("Core", "the cause is unknown");
}

Sentence vehicleName(const floor::VehicleSetup& setup) {
  return setup.name.empty() ? phrase("Core", "Vehicle %1").with(setup.id.value) : Sentence{setup.name};
}

std::string decimal(double value, int decimals) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
  return std::string{text.data(), end};
}

}  // namespace tessera::supervisor
