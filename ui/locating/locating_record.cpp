#include "ui/locating/locating_record.h"

#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr Seconds kBeliefsKept{3.0};
constexpr Seconds kBeliefGap{0.25};  // between two pictures; in a longer one nobody knows what was believed
constexpr std::size_t kMostPending = 20;
constexpr int kFewestReads = 5;  // for a verdict

}  // namespace

void LocatingRecord::clear() {
  reads_.clear();
  misses_.clear();
}

bool LocatingRecord::take(const supervisor::Snapshot& snapshot) {
  const auto& watched = snapshot.watched;
  const supervisor::VehicleView* view = watched ? snapshot.find(watched->vehicle) : nullptr;
  if (view == nullptr || (vehicle_ == view->id && snapshot.time == now_)) return false;
  if (vehicle_ != view->id || snapshot.time < now_) {
    clear();
    beliefs_.clear();
    pending_.clear();
    lastRead_.reset();
    vehicle_ = view->id;
  }
  now_ = snapshot.time;
  if (view->located) beliefs_.push_back({now_, view->pose, view->covariance});
  while (!beliefs_.empty() && now_ - beliefs_.front().at > kBeliefsKept) beliefs_.pop_front();
  for (const locate::Innovation& i : watched->innovations) {
    if (lastRead_ && i.at <= *lastRead_) continue;
    lastRead_ = i.at;
    reads_.push_back({i.at, i.nis, 0.0});
    const auto n = std::min<std::size_t>(kWindow, reads_.size());
    for (std::size_t k = reads_.size() - n; k < reads_.size(); ++k)
      reads_.back().mean += reads_[k].nis / static_cast<double>(n);
    if (reads_.size() > kReads) reads_.pop_front();
  }
  judge();
  return true;
}

void LocatingRecord::take(const TruthSample& truth) {
  if (truth.vehicle != vehicle_) return;
  pending_.push_back(truth);
  if (pending_.size() > kMostPending) pending_.pop_front();
  judge();
}

// The truth is compared with what was believed at the same instant, between two pictures.
void LocatingRecord::judge() {
  while (!pending_.empty() && !beliefs_.empty() && pending_.front().at <= beliefs_.back().at) {
    const TruthSample truth = pending_.front();
    pending_.pop_front();
    const auto after =
        std::find_if(beliefs_.begin(), beliefs_.end(), [&](const Belief& b) { return b.at >= truth.at; });
    if (after == beliefs_.begin() || after == beliefs_.end()) continue;
    const Belief& a = *std::prev(after);
    const Belief& b = *after;
    if (b.at - a.at > kBeliefGap) continue;
    const double share = b.at == a.at ? 0.0 : (truth.at - a.at) / (b.at - a.at);
    const Point place = a.pose.position + share * (b.pose.position - a.pose.position);
    const Offset off = place - truth.pose.position;
    const double x = off.x.value();
    const double y = off.y.value();
    const double xx = b.covariance[0];
    const double xy = 0.5 * (b.covariance[1] + b.covariance[3]);
    const double yy = b.covariance[4];
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0.0)) continue;
    misses_.push_back({std::hypot(x, y), (yy * x * x - 2.0 * xy * x * y + xx * y * y) / determinant});
    if (misses_.size() > kErrors) misses_.pop_front();
  }
}

LocatingRecord::Verdict LocatingRecord::verdict() const {
  Verdict v;
  v.count = static_cast<int>(std::min<std::size_t>(kWindow, reads_.size()));
  v.bounds = locate::meanBounds(std::max(1, v.count));
  if (reads_.empty()) return v;
  v.mean = reads_.back().mean;
  if (v.count < kFewestReads) return v;
  v.is = v.mean > v.bounds.high  ? Verdict::Is::TooSure
         : v.mean < v.bounds.low ? Verdict::Is::TooCautious
                                 : Verdict::Is::Honest;
  return v;
}

LocatingRecord::Errors LocatingRecord::errors() const {
  Errors e;
  e.count = misses_.size();
  if (misses_.empty()) return e;
  std::vector<double> away;
  double sum = 0.0;
  for (const Miss& m : misses_) {
    away.push_back(m.away);
    sum += m.away;
    e.nees += m.nees / static_cast<double>(e.count);
  }
  e.now = Metres{away.back()};
  e.mean = Metres{sum / static_cast<double>(e.count)};
  const std::size_t rank = (e.count * 95 + 99) / 100 - 1;
  std::nth_element(away.begin(), away.begin() + static_cast<std::ptrdiff_t>(rank), away.end());
  e.p95 = Metres{away[rank]};
  return e;
}

}  // namespace tessera::ui
