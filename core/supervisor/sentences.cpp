#include "supervisor/sentences.h"

#include <charconv>

#include "supervisor/parameter_texts.h"

namespace tessera::supervisor {
namespace {

std::string requestText(const wire::Request& request) {
  switch (request.type) {
    case wire::MessageType::Get:
      return "reading " + parameterName(request.parameter);
    case wire::MessageType::Set:
      return "setting " + parameterName(request.parameter) + " to " + parameterValue(request.parameter, request.value);
    default:
      return actionName(request.parameter);
  }
}

std::string outcomeText(const wire::Request& request, const wire::Value& value) {
  const bool ofParameter = request.type == wire::MessageType::Get || request.type == wire::MessageType::Set;
  switch (value.outcome) {
    case wire::Outcome::Done:
      return ofParameter ? "done, the value is " + parameterValue(request.parameter, value.value) : "done";
    case wire::Outcome::Started:
      return "started";
    case wire::Outcome::Unknown:
      return "refused, the vehicle does not know it";
    case wire::Outcome::OutOfRange:
      return "refused, the value is out of range";
    case wire::Outcome::Busy:
      return "refused, the vehicle is busy";
    case wire::Outcome::Failed:
      return "failed on the vehicle";
  }
  return "answered in an unknown way";
}

}  // namespace

const std::array<FaultText, 13>& faultTexts() {
  static constexpr Seconds kSoon{1.0};
  // Bits that say "since the last report" come and go from report to report.
  static constexpr Seconds kFlicker{5.0};
  static constexpr std::array<FaultText, 13> kTexts{{
      {wire::kFaultMotorStall, true, kSoon,
       "stopped: a wheel does not turn although it is driven. Free it, then clear.", "drives its wheels again."},
      {wire::kFaultEncoder, true, kSoon, "stopped: a wheel encoder contradicts the drive. Check it, then clear.",
       "trusts its wheel encoders again."},
      {wire::kFaultCompass, false, kSoon, "gets no answer from its compass and keeps its heading by the wheels.",
       "hears its compass again."},
      {wire::kFaultCompassRange, false, kSoon,
       "measures a magnetic field that cannot be right and keeps its heading by the wheels.",
       "measures a plausible magnetic field again."},
      {wire::kFaultReader, false, kSoon, "gets no answer from one of its tag readers.",
       "hears all its tag readers again."},
      {wire::kFaultBattery, false, kSoon, "has a low battery.", "has enough battery again."},
      {wire::kFaultEeprom, true, kSoon,
       "cannot read or write its settings; what was set is lost at the next start. It stands, even when cleared, if it "
       "could not read them.",
       "reads and writes its settings again."},
      {wire::kFaultWatchdog, true, kSoon, "was restarted by its watchdog and stands until it is cleared.",
       "was cleared after its watchdog's restart."},
      {wire::kFaultRadio, false, kSoon, "has a radio module that does not take its parameters.",
       "has a radio module that takes its parameters again."},
      {wire::kFaultForged, false, kFlicker,
       "refused a command that does not bear its key: a changed byte, or somebody else on the channel.",
       "gets no more forged commands."},
      {wire::kFaultReplayed, false, kFlicker, "refused a command that it had seen before: somebody repeats old frames.",
       "gets no more replayed commands."},
      {wire::kFaultEventsLost, false, kFlicker, "dropped tag reads because they were not fetched in time.",
       "has its tag reads fetched in time again."},
      {wire::kFaultRanger, false, kSoon, "gets no answer from one of its rangers and does not drive forwards.",
       "hears all its rangers again."},
  }};
  return kTexts;
}

std::string answerSentence(const std::string& vehicle, const link::Answered& answered) {
  const std::string what = requestText(answered.request);
  if (!answered.value) return vehicle + " did not answer: " + what + " is not confirmed.";
  return vehicle + ", " + what + ": " + outcomeText(answered.request, *answered.value) + ".";
}

std::string_view causeText(wire::ResetCause cause) {
  switch (cause) {
    case wire::ResetCause::PowerOn:
      return "its power was switched on";
    case wire::ResetCause::Watchdog:
      return "its watchdog ended a hang";
    case wire::ResetCause::Software:
      return "it was told to";
    case wire::ResetCause::Other:
      break;
  }
  return "the cause is unknown";
}

std::string decimal(double value, int decimals) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
  return std::string{text.data(), end};
}

}  // namespace tessera::supervisor
