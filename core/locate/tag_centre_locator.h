// The publication's locator, kept as the baseline: the vehicle is where its reader would stand over the middle of the
// last tag read, and moves on from there by dead reckoning with the heading as reported.
#pragma once

#include "locate/locator.h"
#include "locate/odometry.h"
#include "locate/tag_intake.h"

namespace tessera::locate {

class TagCentreLocator final : public Locator {
public:
  static constexpr std::string_view kName = "tag-centre";

  TagCentreLocator(std::shared_ptr<const floor::SiteMap> map, const floor::VehicleSetup& vehicle);

  void add(const Motion& motion) override;
  void add(const TagRead& read) override;
  /// The tag's middle says nothing about its rim: only checked.
  void add(const TagLeft& left) override;
  [[nodiscard]] Estimate at(Seconds now) const override;
  [[nodiscard]] Seconds lastMotion() const override { return odometry_.last(); }
  void reset(std::optional<Pose> pose) override;
  void useMap(std::shared_ptr<const floor::SiteMap> map) override { intake_.useMap(std::move(map)); }
  [[nodiscard]] const LocatorCounters& counters() const override { return intake_.counters; }
  [[nodiscard]] std::string_view name() const override { return kName; }

private:
  [[nodiscard]] Point after(Seconds until) const;

  TagIntake intake_;
  floor::VehicleSetup vehicle_;
  Odometry odometry_;
  bool known_ = false;
  bool pending_ = false;  ///< the anchor is a tag under `reader_`, read before any heading was reported
  int reader_ = 0;
  Point anchor_;
  Seconds anchorAt_;
};

}  // namespace tessera::locate
