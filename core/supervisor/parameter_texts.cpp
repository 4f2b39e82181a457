#include "supervisor/parameter_texts.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "wire/parameters.h"

namespace tessera::supervisor {
namespace {

using wire::Parameter;

struct Text {
  Parameter parameter;
  std::string_view name;
  std::string_view unit;  ///< stands right behind the number
};

constexpr std::array<Text, 27> kTexts{{
    {Parameter::Address, "the address", ""},
    {Parameter::WheelDiameter, "the wheel diameter", " µm"},
    {Parameter::TrackWidth, "the track width", " µm"},
    {Parameter::CountsPerTurn, "the encoder's resolution", " counts a turn"},
    {Parameter::MaxSpeed, "the highest speed", " mm/s"},
    {Parameter::MaxTurnRate, "the highest turn rate", " mrad/s"},
    {Parameter::StopDistance, "the stop distance", " mm"},
    {Parameter::Declination, "the magnetic declination", "/65536 turn"},
    {Parameter::CompassOffsetX, "the compass' offset on x", " nT"},
    {Parameter::CompassOffsetY, "the compass' offset on y", " nT"},
    {Parameter::CompassMatrixXX, "the compass' matrix entry xx", "/10000"},
    {Parameter::CompassMatrixXY, "the compass' matrix entry xy", "/10000"},
    {Parameter::CompassMatrixYX, "the compass' matrix entry yx", "/10000"},
    {Parameter::CompassMatrixYY, "the compass' matrix entry yy", "/10000"},
    {Parameter::CompassMounting, "the compass' mounting angle", "/65536 turn"},
    {Parameter::ReaderCount, "the number of tag readers", ""},
    {Parameter::RadioChannel, "the radio's channel", ""},
    {Parameter::RadioAirRate, "the code of the radio's air rate", ""},
    {Parameter::RadioBaud, "the code of the radio's baud rate", ""},
    {Parameter::BatteryLow, "the voltage of a low battery", " mV"},
    {Parameter::Acceleration, "the acceleration", " mm/s²"},
    {Parameter::CompassRatio, "the compass' share in the heading", "/10000"},
    {Parameter::FramesRefused, "the count of refused frames", ""},
    {Parameter::FramesDamaged, "the count of damaged frames", ""},
    {Parameter::LongestTick, "the longest tick", " µs"},
    {Parameter::StackFree, "the stack never used", " bytes"},
    {Parameter::CalibrationOutcome, "the outcome code of the last compass calibration", ""},
}};

const Text* find(std::uint8_t number) {
  const auto* it = std::find_if(kTexts.begin(), kTexts.end(),
                                [&](const Text& t) { return static_cast<std::uint8_t>(t.parameter) == number; });
  return it == kTexts.end() ? nullptr : it;
}

}  // namespace

std::string parameterName(std::uint8_t number) {
  const Text* text = find(number);
  return text != nullptr ? std::string{text->name} : "parameter " + std::to_string(number);
}

std::string parameterValue(std::uint8_t number, std::int32_t value) {
  const Text* text = find(number);
  return std::to_string(value) + std::string{text != nullptr ? text->unit : ""};
}

std::string actionName(std::uint8_t number) {
  switch (static_cast<wire::Action>(number)) {
    case wire::Action::CalibrateCompass:
      return "calibrating the compass";
    case wire::Action::Restart:
      return "restarting";
    case wire::Action::RestoreDefaults:
      return "restoring the factory's settings";
  }
  return "action " + std::to_string(number);
}

}  // namespace tessera::supervisor
