// Where a vehicle is, and how well that is known, from its motion and the tags that it read. Not thread-safe; reads no
// clock; the same calls in the same order give the same estimates bit by bit.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/pose.h"
#include "base/result.h"
#include "floor/site_map.h"
#include "locate/magnetic_map.h"
#include "locate/observation.h"

namespace tessera::locate {

struct Estimate {
  Seconds at;
  Pose pose;  ///< of the middle between the driven wheels; the heading is the true one, the compass' bias taken out
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Zero();  ///< of x, y (m²) and heading (rad²); means nothing unless located
  /// What is unknown of the odometer's scale, as a share of it: its covariances with x, y (m) and heading (rad), and
  /// its variance. A vehicle that is rolled on from here comes by as much too far. Zero: the locator has no such state.
  Eigen::Vector4d scale = Eigen::Vector4d::Zero();
  /// Reported heading minus true heading. A vehicle holds its own compass' heading: send pose heading + headingBias.
  Radians headingBias;
  MetresPerSecond speed;  ///< along the heading, after the correction of the odometer's scale
  RadiansPerSecond turnRate;
  bool located = false;  ///< false: unknown place, contradicted by reads, or too uncertain to drive by
  bool doubted = false;  ///< located, but a tag speaks for another place: the covariance reaches as far

  /// Standard deviation of the place along its worst direction.
  [[nodiscard]] Metres positionSigma() const;
};

/// Since the locator was made.
struct LocatorCounters {
  std::uint32_t reads = 0;           ///< tag reads taken in, of whatever kind
  std::uint32_t unknownTags = 0;     ///< reads of a UID that the map does not have
  std::uint32_t rejected = 0;        ///< reads that contradict the estimate
  std::uint32_t tooLate = 0;         ///< observations older than the history kept
  std::uint32_t invalid = 0;         ///< observations with a number that is none, or of a reader that is not there
  std::uint32_t reacquisitions = 0;  ///< times the place was found anew after contradiction or ignorance
};

class Locator {
public:
  virtual ~Locator() = default;
  // Observations may come late and out of order; each is put in where it belongs, up to kHistory into the past.
  virtual void add(const Motion& motion) = 0;
  virtual void add(const TagRead& read) = 0;
  virtual void add(const TagLeft& left) = 0;
  /// Every tag event between the two instants has been passed on: what was not read then was not read. A locator may
  /// take that silence as evidence, or not.
  virtual void told(Seconds from, Seconds until) {
    static_cast<void>(from);
    static_cast<void>(until);
  }
  /// What the floor's iron does to the compass, as far as it is known; holds until told otherwise. A locator may make
  /// use of it, or not. The map is read while observations are added, and may change between them.
  virtual void expect(const MagneticOutlook& outlook) { static_cast<void>(outlook); }
  /// The estimate at an instant: between motions by interpolation, after the last one by dead reckoning at its speed
  /// and turn rate for kMaxCoast at most. For control, ask at(lastMotion()) and let drive::predict roll it forward:
  /// that knows the commands given since.
  [[nodiscard]] virtual Estimate at(Seconds now) const = 0;
  /// Instant of the newest motion; the time's zero before the first.
  [[nodiscard]] virtual Seconds lastMotion() const = 0;
  /// Forgets everything but the counters. With a pose: the vehicle was placed there (to about 5 cm); without: nobody
  /// knows.
  virtual void reset(std::optional<Pose> pose) = 0;
  /// Tags lie from now on where this map has them, in the same frame and to the same north. What is known stays: what
  /// was moved under the vehicle contradicts it, as a wrong map would. Never null.
  virtual void useMap(std::shared_ptr<const floor::SiteMap> map) = 0;
  /// Places that are thought possible, `most` of them at most, as often as they are likely: for a picture, at the
  /// instant lastMotion(). Empty: this locator holds no such guesses.
  [[nodiscard]] virtual std::vector<Point> guesses(std::size_t most) const {
    static_cast<void>(most);
    return {};
  }
  [[nodiscard]] virtual const LocatorCounters& counters() const = 0;
  [[nodiscard]] virtual std::string_view name() const = 0;

  static constexpr Seconds kHistory{5.0};
  static constexpr Seconds kMaxCoast{1.0};
};

/// Names that makeLocator knows; the first is the default.
[[nodiscard]] std::span<const std::string_view> locatorNames();

/// A locator that starts at the setup's start pose if that has one. Error: unknown name, or a vehicle without readers.
[[nodiscard]] Result<std::unique_ptr<Locator>> makeLocator(std::string_view name,
                                                           std::shared_ptr<const floor::SiteMap> map,
                                                           const floor::VehicleSetup& vehicle);

}  // namespace tessera::locate
