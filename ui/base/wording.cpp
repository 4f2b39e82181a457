#include "ui/base/wording.h"

#include <QCoreApplication>
#include <array>
#include <utility>
#include <vector>

namespace tessera::ui {
namespace {

QString word(const char* english) { return QCoreApplication::translate("Wording", english); }

QString unknownWord() { return word(QT_TRANSLATE_NOOP("Wording", "Unknown")); }

}  // namespace

QString text(const Sentence& sentence) {
  const Pattern* pattern = sentence.pattern();
  if (pattern == nullptr) return QString::fromStdString(sentence.english());
  std::vector<std::string> arguments;
  for (const Sentence& argument : sentence.arguments()) arguments.push_back(text(argument).toStdString());
  const QString translated = QCoreApplication::translate(pattern->context(), pattern->english());
  return QString::fromStdString(filledIn(translated.toStdString(), arguments));
}

QString text(supervisor::Contact contact) {
  switch (contact) {
    case supervisor::Contact::Calling:
      return word(QT_TRANSLATE_NOOP("Wording", "Calling"));
    case supervisor::Contact::Connected:
      return word(QT_TRANSLATE_NOOP("Wording", "Connected"));
    case supervisor::Contact::Silent:
      return word(QT_TRANSLATE_NOOP("Wording", "Silent"));
    case supervisor::Contact::Refused:
      return word(QT_TRANSLATE_NOOP("Wording", "Refused"));
  }
  return unknownWord();
}

QString text(supervisor::Task task) {
  switch (task) {
    case supervisor::Task::None:
      return word(QT_TRANSLATE_NOOP("Wording", "Idle"));
    case supervisor::Task::Running:
      return word(QT_TRANSLATE_NOOP("Wording", "Running"));
    case supervisor::Task::Paused:
      return word(QT_TRANSLATE_NOOP("Wording", "Paused"));
    case supervisor::Task::Stopped:
      return word(QT_TRANSLATE_NOOP("Wording", "Stopped"));
    case supervisor::Task::Finished:
      return word(QT_TRANSLATE_NOOP("Wording", "Finished"));
    case supervisor::Task::Jogging:
      return word(QT_TRANSLATE_NOOP("Wording", "Driven by hand"));
  }
  return unknownWord();
}

QString text(supervisor::PortState state) {
  switch (state) {
    case supervisor::PortState::Closed:
      return word(QT_TRANSLATE_NOOP("Wording", "Closed"));
    case supervisor::PortState::Open:
      return word(QT_TRANSLATE_NOOP("Wording", "Open"));
    case supervisor::PortState::Lost:
      return word(QT_TRANSLATE_NOOP("Wording", "Lost"));
  }
  return unknownWord();
}

QString text(supervisor::CommandStatus status) {
  switch (status) {
    case supervisor::CommandStatus::Sent:
      return word(QT_TRANSLATE_NOOP("Wording", "Sent"));
    case supervisor::CommandStatus::Acknowledged:
      return word(QT_TRANSLATE_NOOP("Wording", "Acknowledged"));
    case supervisor::CommandStatus::Done:
      return word(QT_TRANSLATE_NOOP("Wording", "Done"));
    case supervisor::CommandStatus::Expired:
      return word(QT_TRANSLATE_NOOP("Wording", "Expired"));
  }
  return unknownWord();
}

QString text(supervisor::Severity severity) {
  switch (severity) {
    case supervisor::Severity::Info:
      return word(QT_TRANSLATE_NOOP("Wording", "Info"));
    case supervisor::Severity::Warning:
      return word(QT_TRANSLATE_NOOP("Wording", "Warning"));
    case supervisor::Severity::Error:
      return word(QT_TRANSLATE_NOOP("Wording", "Error"));
  }
  return unknownWord();
}

QString text(wire::VehicleState state) {
  switch (state) {
    case wire::VehicleState::Standing:
      return word(QT_TRANSLATE_NOOP("Wording", "Standing"));
    case wire::VehicleState::Driving:
      return word(QT_TRANSLATE_NOOP("Wording", "Driving"));
    case wire::VehicleState::Turning:
      return word(QT_TRANSLATE_NOOP("Wording", "Turning"));
    case wire::VehicleState::Obstacle:
      return word(QT_TRANSLATE_NOOP("Wording", "Before an obstacle"));
    case wire::VehicleState::Expired:
      return word(QT_TRANSLATE_NOOP("Wording", "Stopped by itself"));
    case wire::VehicleState::Calibrating:
      return word(QT_TRANSLATE_NOOP("Wording", "Calibrating"));
    case wire::VehicleState::Faulted:
      return word(QT_TRANSLATE_NOOP("Wording", "Faulted"));
  }
  return unknownWord();
}

QStringList faultTexts(std::uint16_t faults) {
  static constexpr std::array<std::pair<wire::Fault, const char*>, 13> kWords{{
      {wire::kFaultMotorStall, QT_TRANSLATE_NOOP("Wording", "Motor stalled")},
      {wire::kFaultEncoder, QT_TRANSLATE_NOOP("Wording", "Wheel encoder")},
      {wire::kFaultCompass, QT_TRANSLATE_NOOP("Wording", "No compass")},
      {wire::kFaultCompassRange, QT_TRANSLATE_NOOP("Wording", "Magnetic field")},
      {wire::kFaultReader, QT_TRANSLATE_NOOP("Wording", "Tag reader")},
      {wire::kFaultBattery, QT_TRANSLATE_NOOP("Wording", "Battery low")},
      {wire::kFaultEeprom, QT_TRANSLATE_NOOP("Wording", "Settings' memory")},
      {wire::kFaultWatchdog, QT_TRANSLATE_NOOP("Wording", "Restarted by watchdog")},
      {wire::kFaultRadio, QT_TRANSLATE_NOOP("Wording", "Radio module")},
      {wire::kFaultForged, QT_TRANSLATE_NOOP("Wording", "Forged command")},
      {wire::kFaultReplayed, QT_TRANSLATE_NOOP("Wording", "Replayed command")},
      {wire::kFaultEventsLost, QT_TRANSLATE_NOOP("Wording", "Tag reads dropped")},
      {wire::kFaultRanger, QT_TRANSLATE_NOOP("Wording", "Ranger")},
  }};
  QStringList texts;
  for (const auto& [bit, english] : kWords)
    if ((faults & bit) != 0) texts.push_back(word(english));
  return texts;
}

}  // namespace tessera::ui
