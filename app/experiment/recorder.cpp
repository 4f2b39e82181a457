#include "app/experiment/recorder.h"

#include <algorithm>
#include <cstdio>

namespace tessera::experiment {
namespace {

std::string clause(const supervisor::VehicleView& v) {
  char text[160];
  const char* waiting = v.waits.empty() ? "" : ", waiting";
  std::snprintf(text, sizeof text, "%.2f of %.2f m, %.1f cm beside the route%s", v.progress.value(), v.length.value(),
                abs(v.crossTrack).value() * 100.0, v.finished ? ", finished" : waiting);
  return v.name + " " + text;
}

}  // namespace

Recorder::Recorder(std::vector<Assignment> assignments)
    : assignments_{std::move(assignments)}, tracks_(assignments_.size()) {}

void Recorder::take(const supervisor::Snapshot& snapshot) {
  channel_ = snapshot.channel;
  progress_.clear();
  connected_ = 0;
  double done = 0;
  double total = 0;
  for (std::size_t i = 0; i < assignments_.size(); ++i) {
    const supervisor::VehicleView* view = snapshot.find(assignments_[i].vehicle);
    if (view == nullptr) continue;
    connected_ += view->contact == supervisor::Contact::Connected ? 1U : 0U;
    takeVehicle(tracks_[i], *view, snapshot.time);
    done += view->finished ? view->length.value() : view->progress.value();
    total += view->length.value();
    if (!progress_.empty()) progress_ += "; ";
    progress_ += clause(*view);
  }
  share_ = total > 0 ? std::clamp(done / total, 0.0, 1.0) : 0.0;
}

void Recorder::takeVehicle(Track& track, const supervisor::VehicleView& view, Seconds at) {
  Belief belief;
  belief.at = at;
  belief.pose = view.pose;
  belief.located = view.located;
  belief.doubted = view.doubted;
  belief.doubt = {view.covariance[0], view.covariance[4], view.covariance[1]};
  // Before it was located for the first time there is no estimate to judge.
  track.everLocated = track.everLocated || view.located;
  belief.driving = view.task == supervisor::Task::Running && track.everLocated;
  if (view.command) {
    belief.commandSpeed = view.command->speed;
    belief.commandHeading = view.command->heading;
  }
  track.finished = track.finished || view.finished;
  track.beliefs.push_back(belief);
}

bool Recorder::allFinished() const {
  return std::all_of(tracks_.begin(), tracks_.end(), [](const Track& t) { return t.finished; });
}

}  // namespace tessera::experiment
