#include "supervisor/parameter_texts.h"

#include <algorithm>
#include <array>

#include "wire/parameters.h"

namespace tessera::supervisor {
namespace {

using wire::Parameter;

struct Text {
  Parameter parameter;
  Pattern name;
  Pattern value;
};

// What reads the same in every language.
consteval Pattern same(const char* value) { return {"", value}; }

constexpr std::array<Text, 28> kTexts{{
    {Parameter::Address, phrase("Core", "the address"), same("%1")},
    {Parameter::WheelDiameter, phrase("Core", "the wheel diameter"), same("%1 µm")},
    {Parameter::TrackWidth, phrase("Core", "the track width"), same("%1 µm")},
    {Parameter::CountsPerTurn, phrase("Core", "the encoder's resolution"), phrase("Core", "%1 counts a turn")},
    {Parameter::MaxSpeed, phrase("Core", "the highest speed"), same("%1 mm/s")},
    {Parameter::MaxTurnRate, phrase("Core", "the highest turn rate"), same("%1 mrad/s")},
    {Parameter::StopDistance, phrase("Core", "the stop distance"), same("%1 mm")},
    {Parameter::Declination, phrase("Core", "the magnetic declination"), phrase("Core", "%1/65536 turn")},
    {Parameter::CompassOffsetX, phrase("Core", "the compass' offset on x"), same("%1 nT")},
    {Parameter::CompassOffsetY, phrase("Core", "the compass' offset on y"), same("%1 nT")},
    {Parameter::CompassMatrixXX, phrase("Core", "the compass' matrix entry xx"), same("%1/10000")},
    {Parameter::CompassMatrixXY, phrase("Core", "the compass' matrix entry xy"), same("%1/10000")},
    {Parameter::CompassMatrixYX, phrase("Core", "the compass' matrix entry yx"), same("%1/10000")},
    {Parameter::CompassMatrixYY, phrase("Core", "the compass' matrix entry yy"), same("%1/10000")},
    {Parameter::CompassMounting, phrase("Core", "the compass' mounting angle"), phrase("Core", "%1/65536 turn")},
    {Parameter::ReaderCount, phrase("Core", "the number of tag readers"), same("%1")},
    {Parameter::RadioChannel, phrase("Core", "the radio's channel"), same("%1")},
    {Parameter::RadioAirRate, phrase("Core", "the code of the radio's air rate"), same("%1")},
    {Parameter::RadioBaud, phrase("Core", "the code of the radio's baud rate"), same("%1")},
    {Parameter::BatteryLow, phrase("Core", "the voltage of a low battery"), same("%1 mV")},
    {Parameter::Acceleration, phrase("Core", "the acceleration"), same("%1 mm/s²")},
    {Parameter::CompassRatio, phrase("Core", "the compass' share in the heading"), same("%1/10000")},
    {Parameter::HeadingLearning, phrase("Core", "the way along which unequal tyres are learned"), same("%1 mm")},
    {Parameter::FramesRefused, phrase("Core", "the count of refused frames"), same("%1")},
    {Parameter::FramesDamaged, phrase("Core", "the count of damaged frames"), same("%1")},
    {Parameter::LongestTick, phrase("Core", "the longest tick"), same("%1 µs")},
    {Parameter::StackFree, phrase("Core", "the stack never used"), phrase("Core", "%1 bytes")},
    {Parameter::CalibrationOutcome, phrase("Core", "the outcome code of the last compass calibration"), same("%1")},
}};

const Text* find(std::uint8_t number) {
  const auto* it = std::find_if(kTexts.begin(), kTexts.end(),
                                [&](const Text& t) { return static_cast<std::uint8_t>(t.parameter) == number; });
  return it == kTexts.end() ? nullptr : it;
}

}  // namespace

bool isCompassSample(std::uint8_t number) {
  const auto first = static_cast<std::uint8_t>(Parameter::CompassSample);
  return number >= first && number < first + wire::kCompassSamples;
}

Sentence parameterName(std::uint8_t number) {
  if (isCompassSample(number)) return phrase("Core", "the field in a direction of the compass' turn");
  const Text* text = find(number);
  return text != nullptr ? Sentence{text->name} : phrase("Core", "parameter %1").with(number);
}

bool isSample(const Event& event) {
  const auto& answer = event.answer;
  return answer && answer->request.type == wire::MessageType::Get && isCompassSample(answer->request.parameter) &&
         answer->value && answer->value->outcome == wire::Outcome::Done;
}

Sentence parameterValue(std::uint8_t number, std::int32_t value) {
  if (isCompassSample(number)) {
    const wire::CompassCounts c = wire::unpackCompass(value);
    return same("%1, %2 nT").with(c.x * wire::kCompassCountNanotesla, c.y * wire::kCompassCountNanotesla);
  }
  const Text* text = find(number);
  return text != nullptr ? text->value.with(value) : Sentence{value};
}

Sentence actionName(std::uint8_t number) {
  switch (static_cast<wire::Action>(number)) {
    case wire::Action::CalibrateCompass:
      return phrase("Core", "calibrating the compass");
    case wire::Action::Restart:
      return phrase("Core", "restarting");
    case wire::Action::RestoreDefaults:
      return phrase("Core", "restoring the factory's settings");
    case wire::Action::SurveyCompass:
      return phrase("Core", "turning on the spot to measure the field");
  }
  return phrase("Core", "action %1").with(number);
}

}  // namespace tessera::supervisor
