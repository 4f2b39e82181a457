#include "locate/synthetic_drive.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <variant>

namespace tessera::test {
namespace {

constexpr double kStep = 0.005;
constexpr double kTurnRate = 1.0;

using Observation = std::variant<locate::Motion, locate::TagRead, locate::TagLeft>;

struct Delivery {
  double at;
  double made;
  std::vector<Observation> what;
};

struct Head {
  double nextAttempt = 0.0;
  std::optional<floor::TagUid> held;
  double lastGood = 0.0;
  int silent = 0;
};

class Drive {
public:
  Drive(const floor::SiteMap& map, const floor::VehicleSetup& vehicle, const DriveOptions& options)
      : map_{map}, vehicle_{vehicle}, o_{options}, random_{options.seed} {
    for (std::size_t i = 0; i < vehicle.readers.size(); ++i)
      heads_.push_back({uniform_(random_) * o_.pollPeriod, {}, 0.0, 0});
  }

  void run(const std::vector<Point>& vertices) {
    pose_ = {vertices.front(), direction(vertices[1] - vertices[0])};
    step(0.0, 0.0);
    for (std::size_t leg = 0; leg + 1 < vertices.size(); ++leg) {
      const Radians to = direction(vertices[leg + 1] - vertices[leg]);
      while (std::abs(turnBetween(pose_.heading, to).value()) > 1e-9)
        step(0.0, std::clamp(turnBetween(pose_.heading, to).value(), -kTurnRate * kStep, kTurnRate * kStep));
      for (double rest = distance(vertices[leg], vertices[leg + 1]).value(); rest > 1e-9;) {
        const double d = std::min(rest, o_.speed * kStep);
        step(d, 0.0);
        rest -= d;
      }
      if (o_.carriedAt && now_ > *o_.carriedAt) return carried();
    }
  }

  std::vector<Delivery> deliveries;
  std::map<double, Pose> truth;

private:
  // From here on it goes straight over another part of the floor; the carrying itself takes 2 s without tags.
  void carried() {
    lifted_ = true;
    for (int i = 0; i < 400; ++i) step(0.0, 0.0);
    lifted_ = false;
    pose_ = {{Metres{0.50}, Metres{1.62}}, Radians{-0.4}};
    for (int i = 0; i < 100; ++i) step(0.0, 0.0);
    for (double d = 0.0; d < 0.9; d += o_.speed * kStep) step(o_.speed * kStep, 0.0);
  }

  void step(double d, double turn) {
    now_ += kStep;
    pose_.position = pose_.position + turned({Metres{d}, Metres{}}, pose_.heading);
    pose_.heading = wrapped(pose_.heading + Radians{turn});
    wander_ += -wander_ * kStep + std::sqrt(2.0 * kStep) * normal_(random_);
    if (o_.iron) iron_ += (1.0 - std::exp(-kStep / locate::kCompassMemory)) * (o_.iron(pose_.position) - iron_);
    travel_ += d * (1.0 + o_.speedNoise * wander_);
    speed_ = d / kStep * (1.0 + o_.speedNoise * wander_);
    for (std::size_t i = 0; i < heads_.size(); ++i)
      if (now_ >= heads_[i].nextAttempt) attempt(i);
    if (now_ >= nextReport_) report();
  }

  void attempt(std::size_t i) {
    Head& head = heads_[i];
    head.nextAttempt += o_.pollPeriod;
    std::optional<floor::TagUid> seen;
    if (!lifted_ && uniform_(random_) < o_.detection)
      map_.forEachNear(placeOf(pose_, vehicle_.readers[i]), vehicle_.readerRadius,
                       [&](const floor::PlacedTag& tag) { seen = tag.uid; });
    const int reader = static_cast<int>(i);
    if (seen && head.held != seen) {
      if (head.held) tell(locate::TagLeft{reader, Seconds{head.lastGood}});
      tell(locate::TagRead{reader, known(*seen), Seconds{now_}});
      head.held = seen;
    } else if (seen && o_.everyRead) {
      tell(locate::TagRead{reader, known(*seen), Seconds{now_}});
    }
    if (seen) {
      head.lastGood = now_;
      head.silent = 0;
    } else if (head.held && ++head.silent == 2) {
      tell(locate::TagLeft{reader, Seconds{head.lastGood}});
      head.held.reset();
    }
  }

  floor::TagUid known(const floor::TagUid& uid) {
    if (uniform_(random_) >= o_.unknownTags) return uid;
    return *floor::TagUid::parse("DEADBEEF");
  }

  void tell(const Observation& observation) {
    if (uniform_(random_) >= o_.lostEvents) pending_.push_back(observation);
  }

  void report() {
    nextReport_ += o_.reportPeriod;
    const double heading = (o_.compassBias + o_.compassNoise * normal_(random_)) * kPi / 180.0 + iron_;
    const locate::Motion motion{Seconds{now_}, Metres{travel_}, MetresPerSecond{speed_},
                                pose_.heading + Radians{heading}};
    pending_.insert(pending_.begin(), motion);
    if (o_.shuffled) std::reverse(pending_.begin(), pending_.end());
    const bool late = o_.shuffled && ++reports_ % 3 == 0;
    deliveries.push_back({now_ + o_.delay + (late ? 1.0 : 0.0), now_, pending_});
    pending_.clear();
    truth[now_] = pose_;
  }

  const floor::SiteMap& map_;
  const floor::VehicleSetup& vehicle_;
  DriveOptions o_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  std::vector<Head> heads_;
  std::vector<Observation> pending_;
  Pose pose_;
  double now_ = 0.0, travel_ = 0.0, speed_ = 0.0, wander_ = 0.0, nextReport_ = 0.0, iron_ = 0.0;
  bool lifted_ = false;
  int reports_ = 0;
};

}  // namespace

std::vector<Sample> drive(const floor::SiteMap& map, const floor::VehicleSetup& vehicle,
                          const std::vector<Point>& vertices, const DriveOptions& options, locate::Locator& locator) {
  Drive world{map, vehicle, options};
  world.run(vertices);
  std::stable_sort(world.deliveries.begin(), world.deliveries.end(),
                   [](const Delivery& a, const Delivery& b) { return a.at < b.at; });
  // Silence is told only where every event arrives, and in its order.
  const bool complete = options.lostEvents == 0.0 && !options.shuffled;
  double toldUntil = 0.0;
  std::vector<Sample> samples;
  for (const Delivery& delivery : world.deliveries) {
    for (const Observation& observation : delivery.what) {
      const double at = std::visit([](const auto& o) { return o.at.value(); }, observation);
      if (complete && !options.silenceLast && !std::holds_alternative<locate::Motion>(observation) && at > toldUntil) {
        locator.told(Seconds{toldUntil}, Seconds{at});
        toldUntil = at;
      }
      std::visit([&](const auto& o) { locator.add(o); }, observation);
    }
    if (complete) locator.told(Seconds{toldUntil}, Seconds{delivery.made});
    toldUntil = delivery.made;
    const Seconds last = locator.lastMotion();
    if (const auto truth = world.truth.find(last.value()); truth != world.truth.end())
      samples.push_back({last.value(), truth->second, locator.at(last)});
  }
  return samples;
}

ErrorSummary summarise(const std::vector<Sample>& samples, double from, double to) {
  ErrorSummary summary;
  std::vector<double> errors;
  double heading = 0.0;
  std::size_t located = 0;
  for (const Sample& sample : samples) {
    if (sample.at < from || sample.at > to) continue;
    errors.push_back(distance(sample.truth.position, sample.estimate.pose.position).value());
    const double turn = turnBetween(sample.truth.heading, sample.estimate.pose.heading).value();
    heading += turn * turn;
    if (sample.estimate.located) ++located;
  }
  if (errors.empty()) return summary;
  const auto n = static_cast<double>(errors.size());
  for (double e : errors) summary.mean += e / n;
  std::sort(errors.begin(), errors.end());
  summary.p95 = errors[static_cast<std::size_t>(0.95 * (n - 1.0))];
  summary.headingRms = std::sqrt(heading / n);
  summary.locatedShare = static_cast<double>(located) / n;
  return summary;
}

}  // namespace tessera::test
