// The words that stand for enumerators in reports and journals.
#include <array>
#include <utility>

#include "supervisor/event.h"
#include "supervisor/snapshot.h"

namespace tessera::supervisor {

std::string_view nameOf(Severity severity) {
  switch (severity) {
    case Severity::Info:
      return "info";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "unknown";
}

std::string_view nameOf(EventKind kind) {
  switch (kind) {
    case EventKind::PortOpened:
      return "port-opened";
    case EventKind::PortLost:
      return "port-lost";
    case EventKind::Identified:
      return "identified";
    case EventKind::WrongKey:
      return "wrong-key";
    case EventKind::WrongVersion:
      return "wrong-version";
    case EventKind::Silent:
      return "silent";
    case EventKind::Restarted:
      return "restarted";
    case EventKind::Located:
      return "located";
    case EventKind::Lost:
      return "lost";
    case EventKind::Doubted:
      return "doubted";
    case EventKind::Fault:
      return "fault";
    case EventKind::Obstacle:
      return "obstacle";
    case EventKind::Expired:
      return "expired";
    case EventKind::DamagedFrames:
      return "damaged-frames";
    case EventKind::ForgedFrames:
      return "forged-frames";
    case EventKind::ReplayedFrames:
      return "replayed-frames";
    case EventKind::StrangeFrames:
      return "strange-frames";
    case EventKind::TagEventsLost:
      return "tag-events-lost";
    case EventKind::UnknownTag:
      return "unknown-tag";
    case EventKind::RouteStarted:
      return "route-started";
    case EventKind::RouteFinished:
      return "route-finished";
    case EventKind::StoppedAll:
      return "stopped-all";
    case EventKind::RouteStopped:
      return "route-stopped";
    case EventKind::DrivenByHand:
      return "driven-by-hand";
    case EventKind::Paused:
      return "paused";
    case EventKind::Resumed:
      return "resumed";
    case EventKind::OrderRefused:
      return "order-refused";
    case EventKind::Paired:
      return "paired";
    case EventKind::Answer:
      return "answer";
  }
  return "unknown";
}

std::string_view nameOf(PortState state) {
  switch (state) {
    case PortState::Closed:
      return "closed";
    case PortState::Open:
      return "open";
    case PortState::Lost:
      return "lost";
  }
  return "unknown";
}

std::string_view nameOf(Contact contact) {
  switch (contact) {
    case Contact::Calling:
      return "calling";
    case Contact::Connected:
      return "connected";
    case Contact::Silent:
      return "silent";
    case Contact::Refused:
      return "refused";
  }
  return "unknown";
}

std::string_view nameOf(Task task) {
  switch (task) {
    case Task::None:
      return "none";
    case Task::Running:
      return "running";
    case Task::Paused:
      return "paused";
    case Task::Stopped:
      return "stopped";
    case Task::Jogging:
      return "jogging";
    case Task::Finished:
      return "finished";
  }
  return "unknown";
}

std::string_view nameOf(CommandStatus status) {
  switch (status) {
    case CommandStatus::Sent:
      return "sent";
    case CommandStatus::Acknowledged:
      return "acknowledged";
    case CommandStatus::Done:
      return "done";
    case CommandStatus::Expired:
      return "expired";
  }
  return "unknown";
}

std::string_view nameOf(wire::VehicleState state) {
  switch (state) {
    case wire::VehicleState::Standing:
      return "standing";
    case wire::VehicleState::Driving:
      return "driving";
    case wire::VehicleState::Turning:
      return "turning";
    case wire::VehicleState::Obstacle:
      return "obstacle";
    case wire::VehicleState::Expired:
      return "expired";
    case wire::VehicleState::Calibrating:
      return "calibrating";
    case wire::VehicleState::Faulted:
      return "faulted";
  }
  return "unknown";
}

std::vector<std::string_view> namesOfFaults(std::uint16_t faults) {
  static constexpr std::array<std::pair<wire::Fault, std::string_view>, 13> kNames{{
      {wire::kFaultMotorStall, "motor-stall"},
      {wire::kFaultEncoder, "encoder"},
      {wire::kFaultCompass, "compass"},
      {wire::kFaultCompassRange, "compass-range"},
      {wire::kFaultReader, "reader"},
      {wire::kFaultBattery, "battery"},
      {wire::kFaultEeprom, "eeprom"},
      {wire::kFaultWatchdog, "watchdog"},
      {wire::kFaultRadio, "radio"},
      {wire::kFaultForged, "forged"},
      {wire::kFaultReplayed, "replayed"},
      {wire::kFaultEventsLost, "events-lost"},
      {wire::kFaultRanger, "ranger"},
  }};
  std::vector<std::string_view> names;
  for (const auto& [bit, name] : kNames)
    if ((faults & bit) != 0) names.push_back(name);
  return names;
}

}  // namespace tessera::supervisor
