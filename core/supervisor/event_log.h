// Collects the events of one tick.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "supervisor/event.h"

namespace tessera::supervisor {

class EventLog {
public:
  void setTime(Seconds now) { now_ = now; }
  void tell(Severity severity, EventKind kind, std::optional<VehicleId> vehicle, Sentence sentence, bool over = false) {
    events_.push_back({now_, severity, vehicle, kind, over, std::move(sentence), std::nullopt, std::nullopt});
  }
  void tellAnswer(Severity severity, VehicleId vehicle, Sentence sentence, AskAnswer answer) {
    events_.push_back(
        {now_, severity, vehicle, EventKind::Answer, false, std::move(sentence), std::move(answer), std::nullopt});
  }
  void tellPairing(Severity severity, VehicleId vehicle, Sentence sentence, link::PairingEnd how) {
    events_.push_back({now_, severity, vehicle, EventKind::Paired, false, std::move(sentence), std::nullopt, how});
  }
  // What is told here is a phrase(), so that it can be shown in every language.
  void tell(Severity, EventKind, std::optional<VehicleId>, const char*, bool = false) = delete;
  void tell(Severity, EventKind, std::optional<VehicleId>, const std::string&, bool = false) = delete;
  [[nodiscard]] Seconds now() const { return now_; }
  [[nodiscard]] bool empty() const { return events_.empty(); }
  [[nodiscard]] std::vector<Event> take() { return std::exchange(events_, {}); }

private:
  Seconds now_;
  std::vector<Event> events_;
};

}  // namespace tessera::supervisor
