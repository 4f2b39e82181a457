// What is told of the one vehicle that somebody looks at: how it is located. And what its compass teaches of the floor.
#include "supervisor/vehicle_agent.h"

namespace tessera::supervisor {

void VehicleAgent::watch(bool watched) {
  if (watched == watched_) return;
  watched_ = watched;
  innovations_.clear();
}

void VehicleAgent::useMagneticMap(std::shared_ptr<const locate::MagneticMap> map, bool byIt) {
  magnetic_ = std::move(map);
  byMagnetic_ = byIt;
  learner_.restart();
}

void VehicleAgent::foresee() {
  if (magnetic_ && byMagnetic_) locator_->expect({magnetic_, learner_.own()});
}

// Before the locator learns of the read.
void VehicleAgent::noteInnovation(const ReadView& read) {
  if (!read.place || read.reader >= setup_.readers.size()) return;
  const locate::Estimate before = locator_->at(read.at - locate::kReadLag);
  if (!before.located) return;
  locate::Innovation innovation =
      locate::innovationOf(before, setup_.readers[read.reader], setup_.readerRadius, *read.place);
  innovation.at = read.at;
  innovation.reader = read.reader;
  if (innovations_.size() == LocatingView::kInnovations) innovations_.erase(innovations_.begin());
  innovations_.push_back(innovation);
}

std::shared_ptr<const LocatingView> VehicleAgent::locatingView() const {
  if (!watched_ || !last_ || !motion_) return nullptr;
  auto v = std::make_shared<LocatingView>();
  v->vehicle = id();
  v->locator = locator_->name();
  v->motion = *motion_;
  v->at = estimate_.at;
  v->estimate = estimate_.pose;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      v->covariance[static_cast<std::size_t>(3 * row + column)] = estimate_.covariance(row, column);
  v->located = estimate_.located;
  if (v->located) v->guesses = locator_->guesses(LocatingView::kGuesses);
  v->predicted = predicted_;
  v->effectiveAt = timing_.effectiveAt;
  v->hold = timing_.cycle + kUnpredictedDelay;
  for (std::size_t i = 0; i < LocatingView::kWay; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(LocatingView::kWay);
    v->way.push_back(expectedAt(v->at + share * v->delay()).state.pose);
  }
  v->way.push_back(predicted_);
  const bool led = task_ == Task::Running && decision_ && decision_->phase != drive::Phase::Finished &&
                   decision_->phase != drive::Phase::Lost;
  if (led) v->aim = decision_->target;
  v->innovations = innovations_;
  v->counters = locator_->counters();
  return v;
}

}  // namespace tessera::supervisor
