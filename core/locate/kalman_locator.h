// The default locator: a Kalman filter over the vehicle's odometry, corrected by an edge model of the readers' discs,
// with a short history into which late observations are put where they belong, and finding itself anew after
// contradiction.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "locate/kalman_filter.h"
#include "locate/locator.h"
#include "locate/tag_intake.h"

namespace tessera::locate {

class KalmanLocator final : public Locator {
public:
  static constexpr std::string_view kName = "kalman";
  static constexpr std::size_t kMaxReaders = 16;

  KalmanLocator(std::shared_ptr<const floor::SiteMap> map, const floor::VehicleSetup& vehicle,
                const KalmanOptions& options = {}, DiscModel model = {});

  void add(const Motion& motion) override;
  void add(const TagRead& read) override;
  void add(const TagLeft& left) override;
  [[nodiscard]] Estimate at(Seconds now) const override;
  [[nodiscard]] Seconds lastMotion() const override { return odometry_.last(); }
  void reset(std::optional<Pose> pose) override;
  void useMap(std::shared_ptr<const floor::SiteMap> map) override { intake_.useMap(std::move(map)); }
  [[nodiscard]] const LocatorCounters& counters() const override { return intake_.counters; }
  [[nodiscard]] std::string_view name() const override { return kName; }

private:
  enum class Kind : std::uint8_t { Motion, Read, Left, Found };
  enum class Verdict : std::uint8_t { Unused, Accepted, Rejected };
  struct Held {
    bool any = false;
    bool trusted = false;  ///< its read was accepted, so its leaving is believed too
    Eigen::Vector2d tag = Eigen::Vector2d::Zero();
  };
  /// Everything that a replay has to restore.
  struct State {
    KalmanFilter filter;
    std::array<Held, kMaxReaders> held{};
    bool doubted = false;         ///< too many reads contradict it, and they do not agree with each other
    int rejectedInRow = 0;        ///< reads since the last accepted one
    double evidenceTravel = 0.0;  ///< odometer at the last read accepted, or at the start
  };
  struct Record {
    double at = 0.0;
    Kind kind = Kind::Motion;
    int reader = 0;
    Eigen::Vector2d tag = Eigen::Vector2d::Zero();
    Verdict verdict = Verdict::Unused;
    State after;
  };

  bool usable(int reader, Seconds at);
  std::size_t insert(Record record);
  void replay(std::size_t from);
  void apply(std::size_t index);
  void applyRead(std::size_t index, State& state);
  void applyLeft(const Record& record, State& state) const;
  void prune();
  [[nodiscard]] SilentAttempts silentAttempts(int reader, double at, double direction, const State& state) const;
  /// Looks for a place that explains the reads which contradict the estimate, and starts anew from it.
  void findAnew(std::size_t latest);
  /// False when a single read is better evidence than the estimate.
  [[nodiscard]] bool trusted(const State& state) const;
  [[nodiscard]] bool agree(const Record& earlier, const Record& later, double bias) const;
  void startFrom(const Record& read);
  [[nodiscard]] Eigen::Vector2d lever(int reader, double heading) const;

  TagIntake intake_;
  floor::VehicleSetup vehicle_;
  KalmanOptions options_;
  DiscModel model_;
  Odometry odometry_;
  State base_;           ///< before the first record
  double baseAt_ = 0.0;  ///< its instant; observations from before cannot be placed
  std::vector<Record> records_;
};

}  // namespace tessera::locate
