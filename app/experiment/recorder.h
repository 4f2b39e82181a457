// Listens to the supervisor during a run: keeps what it believed at each tick and says when every vehicle is done.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/experiment/samples.h"
#include "supervisor/event.h"
#include "supervisor/snapshot.h"

namespace tessera::experiment {

/// One vehicle's part of an experiment.
struct Assignment {
  VehicleId vehicle;
  std::string route;
  bool operator==(const Assignment&) const = default;
};

class Recorder {
public:
  explicit Recorder(std::vector<Assignment> assignments);

  void take(const supervisor::Snapshot& snapshot);
  void take(const supervisor::Event& event) { events_.push_back(event); }

  [[nodiscard]] const std::vector<Assignment>& assignments() const { return assignments_; }
  /// In the order of the assignments.
  [[nodiscard]] const std::vector<Belief>& beliefs(std::size_t assignment) const { return tracks_[assignment].beliefs; }
  [[nodiscard]] bool finished(std::size_t assignment) const { return tracks_[assignment].finished; }
  [[nodiscard]] bool allFinished() const;
  [[nodiscard]] const std::vector<supervisor::Event>& events() const { return events_; }
  /// The channel as the last snapshot showed it.
  [[nodiscard]] const supervisor::ChannelView& channel() const { return channel_; }
  /// Every assigned vehicle has been identified and stands ready for orders.
  [[nodiscard]] bool allConnected() const { return connected_ == assignments_.size(); }
  /// "AGV 1 1.32 of 4.80 m, 3 cm beside the route", for a line of progress; one clause a vehicle.
  [[nodiscard]] const std::string& progress() const { return progress_; }
  /// 0 to 1, of all routes together.
  [[nodiscard]] double share() const { return share_; }

private:
  struct Track {
    std::vector<Belief> beliefs;
    bool finished = false;
    bool everLocated = false;
  };
  void takeVehicle(Track& track, const supervisor::VehicleView& view, Seconds at);

  std::vector<Assignment> assignments_;
  std::vector<Track> tracks_;
  std::vector<supervisor::Event> events_;
  supervisor::ChannelView channel_;
  std::size_t connected_ = 0;
  std::string progress_;
  double share_ = 0;
};

}  // namespace tessera::experiment
