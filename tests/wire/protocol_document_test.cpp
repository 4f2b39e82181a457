// docs/protocol.md is held to the program: each worked example in it has exactly the bytes that core/wire makes.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "wire/messages.h"
#include "wire/parameters.h"
#include "wire/protocol_examples.h"

namespace tessera::wire {
namespace {

std::string hexOf(const std::vector<std::uint8_t>& bytes) {
  std::ostringstream s;
  for (std::uint8_t b : bytes)
    s << (s.tellp() > 0 ? " " : "") << "0123456789ABCDEF"[b >> 4] << "0123456789ABCDEF"[b & 15];
  return s.str();
}

std::string documentText() {
  std::ifstream in{TESSERA_PROTOCOL_MD};
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

// "<!-- example: NAME -->", then a fenced block whose lines are bytes, and behind a '|' words about them.
std::map<std::string, std::string> examplesOf(std::istringstream document) {
  std::map<std::string, std::string> found;
  std::string name;
  bool inside = false;
  for (std::string line; std::getline(document, line);) {
    const std::string mark = "<!-- example: ";
    if (line.starts_with(mark)) {
      name = line.substr(mark.size(), line.find(" -->") - mark.size());
      EXPECT_FALSE(found.contains(name)) << name << " stands there twice";
      found[name];
    } else if (line.starts_with("```")) {
      if (inside) name.clear();
      inside = !inside;
    } else if (inside && !name.empty()) {
      std::istringstream words{line.substr(0, line.find('|'))};
      for (std::string byte; words >> byte;) found[name] += (found[name].empty() ? "" : " ") + byte;
    }
  }
  return found;
}

TEST(ProtocolDocument, itsExamplesAreWhatTheProgramSends) {
  const auto written = examplesOf(std::istringstream{documentText()});
  std::set<std::string> known;
  for (const Example& example : protocolExamples()) {
    known.insert(example.name);
    const auto found = written.find(example.name);
    EXPECT_EQ(found == written.end() ? "missing" : found->second, hexOf(example.bytes)) << example.name;
  }
  for (const auto& [name, bytes] : written) EXPECT_TRUE(known.contains(name)) << name << " is not known";
}

TEST(ProtocolDocument, everyFrameOfTheExamplesIsWhole) {
  for (const Example& example : protocolExamples()) {
    if (example.bytes.front() != kSync) continue;
    int frames = 0;
    FrameDecoder decoder;
    decoder.feed(example.bytes, [&frames](const Frame&) { ++frames; });
    EXPECT_EQ(frames, 1) << example.name;
    EXPECT_EQ(decoder.counters().skipped, 0U) << example.name;
  }
}

// A table row "| NUMBER | `NAME` |" for each enumerator keeps document and headers side by side.
bool hasRow(const std::string& document, unsigned number, const std::string& name) {
  return document.find("| " + std::to_string(number) + " | `" + name + "` |") != std::string::npos;
}

TEST(ProtocolDocument, namesEveryParameterActionStateAndFault) {
  const std::string document = documentText();
  const auto row = [&document](auto number, const char* name) {
    EXPECT_TRUE(hasRow(document, static_cast<unsigned>(number), name)) << name;
  };
  row(Parameter::Address, "Address");
  row(Parameter::WheelDiameter, "WheelDiameter");
  row(Parameter::TrackWidth, "TrackWidth");
  row(Parameter::CountsPerTurn, "CountsPerTurn");
  row(Parameter::MaxSpeed, "MaxSpeed");
  row(Parameter::MaxTurnRate, "MaxTurnRate");
  row(Parameter::StopDistance, "StopDistance");
  row(Parameter::Declination, "Declination");
  row(Parameter::CompassOffsetX, "CompassOffsetX");
  row(Parameter::CompassMatrixXX, "CompassMatrixXX");
  row(Parameter::CompassMounting, "CompassMounting");
  row(Parameter::ReaderCount, "ReaderCount");
  row(Parameter::RadioChannel, "RadioChannel");
  row(Parameter::RadioAirRate, "RadioAirRate");
  row(Parameter::RadioBaud, "RadioBaud");
  row(Parameter::BatteryLow, "BatteryLow");
  row(Parameter::Acceleration, "Acceleration");
  row(Parameter::CompassRatio, "CompassRatio");
  row(Parameter::HeadingLearning, "HeadingLearning");
  row(Parameter::FramesRefused, "FramesRefused");
  row(Parameter::FramesDamaged, "FramesDamaged");
  row(Parameter::LongestTick, "LongestTick");
  row(Parameter::StackFree, "StackFree");
  row(Parameter::CalibrationOutcome, "CalibrationOutcome");
  row(Parameter::CompassSample, "CompassSample");
  row(Action::SurveyCompass, "SurveyCompass");
  row(Action::CalibrateCompass, "CalibrateCompass");
  row(Action::Restart, "Restart");
  row(Action::RestoreDefaults, "RestoreDefaults");
  const std::array states{"Standing", "Driving", "Turning", "Obstacle", "Expired", "Calibrating", "Faulted"};
  for (std::size_t i = 0; i < states.size(); ++i) row(i, states[i]);
  const std::array faults{"MotorStall", "Encoder", "Compass", "CompassRange", "Reader",     "Battery", "Eeprom",
                          "Watchdog",   "Radio",   "Forged",  "Replayed",     "EventsLost", "Ranger"};
  for (std::size_t i = 0; i < faults.size(); ++i) row(i, faults[i]);
  const std::array outcomes{"Done", "Started", "Unknown", "OutOfRange", "Busy", "Failed"};
  for (std::size_t i = 0; i < outcomes.size(); ++i) row(i, outcomes[i]);
}

}  // namespace
}  // namespace tessera::wire
