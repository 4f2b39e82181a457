// Monte Carlo localisation of one vehicle (Dellaert, Fox, Burgard, Thrun, "Monte Carlo localization for mobile robots",
// ICRA 1999), with three additions that the tile floor asks for: a reader's silence counts as evidence, attempt by
// attempt; what comes late is weighed against each particle's place back then; and a read that contradicts the picture
// raises a rival belief that takes over when it explains more (the injection of Augmented MCL, "Probabilistic Robotics"
// 8.3.5, kept apart so that it cannot blur the picture that the vehicle is led by).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "locate/locator.h"
#include "locate/magnetic_foresight.h"
#include "locate/odometry.h"
#include "locate/particle_cloud.h"
#include "locate/poll_clock.h"
#include "locate/tag_intake.h"

namespace tessera::locate {

class ParticleLocator final : public Locator {
public:
  static constexpr std::string_view kName = "particles";

  ParticleLocator(std::shared_ptr<const floor::SiteMap> map, const floor::VehicleSetup& vehicle,
                  const ParticleOptions& options = {});

  void add(const Motion& motion) override;
  void add(const TagRead& read) override;
  void add(const TagLeft& left) override;
  void told(Seconds from, Seconds until) override;
  void expect(const MagneticOutlook& outlook) override { outlook_ = outlook; }
  [[nodiscard]] Estimate at(Seconds now) const override;
  [[nodiscard]] Seconds lastMotion() const override { return odometry_.last(); }
  void reset(std::optional<Pose> pose) override;
  void useMap(std::shared_ptr<const floor::SiteMap> map) override {
    intake_.useMap(map);
    map_ = std::move(map);
  }
  [[nodiscard]] const LocatorCounters& counters() const override { return intake_.counters; }
  [[nodiscard]] std::string_view name() const override { return kName; }
  [[nodiscard]] std::vector<Point> guesses(std::size_t most) const override;

private:
  /// What is known of one reader's doings, by its own attempts.
  struct Watch {
    bool holds = false;
    bool trusted = false;  ///< its read was believed, so its leaving is believed too
    Eigen::Vector2d tag = Eigen::Vector2d::Zero();
    double came = 0.0;
    std::optional<double> left;                            ///< told before the visit that it ends
    double accounted = 0.0;                                ///< attempts up to here are accounted for
    Eigen::Vector2d lastSilent = Eigen::Vector2d::Zero();  ///< odometer and heading at the last silent attempt weighed
  };
  struct Pending {
    TagRead read;
    Eigen::Vector2d tag;
  };

  /// Fills in what the map foresees of the bias, and moves `place` on.
  void foresee(CloudStep& step, Eigen::Vector2d& place);
  bool usable(int reader, Seconds at);
  void take(int reader, const Eigen::Vector2d& tag, double at);
  void endVisit(int reader, double lastGood);
  void silence(int reader, double attempt);
  void contradicted(int reader, const Eigen::Vector2d& tag, double at);
  /// What a read adds to lead_ that has these chances under the cloud and under the rival.
  [[nodiscard]] static double leadOf(double chance, double other);
  void judgeRival();
  void startFrom(int reader, const Eigen::Vector2d& tag, double at);
  void drawIn();
  /// Driven between two instants, by the reported headings.
  [[nodiscard]] Eigen::Vector2d wayBetween(double from, double to) const;
  [[nodiscard]] ReaderThen readerThen(int reader, double at) const;
  [[nodiscard]] bool standsSinceBelieved(double at) const;
  void doubt(Estimate& estimate) const;

  TagIntake intake_;
  std::shared_ptr<const floor::SiteMap> map_;
  floor::VehicleSetup vehicle_;
  ParticleOptions options_;
  MagneticOutlook outlook_;
  MagneticForesight foresight_;
  Odometry odometry_;
  PollClock clock_;
  ParticleCloud cloud_;
  ParticleCloud rival_;
  ParticleCloud::Moments moments_;       ///< of the cloud as it is now
  ParticleCloud::Moments rivalMoments_;  ///< and of the rival, if it stands for something
  std::vector<Watch> watches_;
  std::vector<Pending> pending_;       ///< reads from before the first motion
  std::vector<Eigen::Vector2d> near_;  ///< scratch
  bool placed_ = false;
  bool rivals_ = false;  ///< the rival stands for something
  int rejectedInRow_ = 0;
  Eigen::Vector2d rivalTag_ = Eigen::Vector2d::Zero();  ///< that raised it
  int rivalReads_ = 0;                                  ///< that the rival explains; the one that raised it included
  double lead_ = 0.0;            ///< log of how much better the cloud explains what came than the rival
  double evidenceTravel_ = 0.0;  ///< odometer at the last read believed, or at the start
  double lostUntil_ = 0.0;       ///< its place was wrong, and it says so up to then
  double firstMotion_ = 0.0;
  double cloudFrom_ = 0.0;  ///< instant at which the cloud's last motion began
  double toldFrom_ = 0.0;   ///< every event since then ...
  double toldUntil_ = 0.0;  ///< ... up to here has been told
};

}  // namespace tessera::locate
