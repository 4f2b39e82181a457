#include "drive/route_follower.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "drive/control_point_aimer.h"
#include "drive/look_ahead_follower.h"
#include "drive/regulated_pure_pursuit.h"

namespace tessera::drive {
namespace {

constexpr std::array<std::string_view, 3> kNames{LookAheadFollower::kName, ControlPointAimer::kName,
                                                 RegulatedPurePursuit::kName};

Pattern because(SpeedReason reason) {
  switch (reason) {
    case SpeedReason::Requested:
      break;
    case SpeedReason::Leg:
      return phrase("Core", "no faster on this leg");
    case SpeedReason::SlowerLeg:
      return phrase("Core", "slowing down before a slower leg");
    case SpeedReason::Zone:
      return phrase("Core", "no faster in this slow zone");
    case SpeedReason::SlowZone:
      return phrase("Core", "slowing down before a slow zone");
    case SpeedReason::Gate:
      return phrase("Core", "slowing down, as the way ahead is not free");
    case SpeedReason::Bend:
      return phrase("Core", "no faster through this bend");
    case SpeedReason::Corner:
      return phrase("Core", "slowing down before the corner");
    case SpeedReason::End:
      return phrase("Core", "slowing down before the end");
    case SpeedReason::Delay:
      return phrase("Core", "no faster over this slow a radio");
    case SpeedReason::Uncertainty:
      return phrase("Core", "slowly, because its place is not well known");
    case SpeedReason::Heading:
      return phrase("Core", "slowly, until its nose points along the way");
  }
  return phrase("Core", "as asked for");
}

std::string number(double value, const char* format) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string checked(const FollowerSetup& setup) {
  const std::string which = "Route \"" + setup.route.name + "\"";
  for (const Point& p : setup.route.vertices)
    if (!std::isfinite(p.x.value()) || !std::isfinite(p.y.value())) return which + " has a point that is no number.";
  if (Polyline{setup.route.vertices}.legCount() == 0) return which + " needs at least two different points.";
  const double speed = setup.plan.requested.value();
  if (!(speed > 0.0) || speed > setup.ability.maxSpeed.value())
    return "A speed of " + number(speed, "%.3g") +
           " m/s cannot be asked for: the vehicle drives more than 0 and up to " +
           number(setup.ability.maxSpeed.value(), "%.3g") + " m/s.";
  return {};
}

}  // namespace

Sentence sentence(const Decision& d, const Polyline& route) {
  const std::string speed = number(d.command.speed.value(), "%.2f");
  switch (d.phase) {
    case Phase::Approaching:
      return phrase("Core", "On the way to the route: %1 m/s, %2.").with(speed, because(d.speedReason));
    case Phase::OnLeg:
      return phrase("Core", "On leg %1 of %2, %3 m to go: %4 m/s, %5.")
          .with(d.leg + 1, route.legCount(), number(d.remaining.value(), "%.2f"), speed, because(d.speedReason));
    case Phase::Turning:
      return phrase("Core", "Turning on the spot by %1° to leg %2 of %3.")
          .with(number(degrees(d.headingError), "%.0f"), d.leg + 1, route.legCount());
    case Phase::Waiting:
      return phrase("Core", "Waiting until the way ahead is free.");
    case Phase::Finished:
      return phrase("Core", "At the end of the route.");
    case Phase::Lost:
      return phrase("Core", "Standing still, because its place is unknown.");
  }
  return {};
}

Radians headingToTurn(RadiansPerSecond rate, Radians heading, Seconds delay, const VehicleAbility& ability) {
  const double late = std::isfinite(delay.value()) ? 0.5 * delay.value() : 0.0;
  return wrapped(heading + rate * Seconds{1.0 / ability.headingGain + late});
}

std::span<const std::string_view> followerNames() { return kNames; }

bool roundsCorners(std::string_view name) { return name == LookAheadFollower::kName; }

Result<std::unique_ptr<RouteFollower>> makeRouteFollower(std::string_view name, const FollowerSetup& setup) {
  if (std::string wrong = checked(setup); !wrong.empty()) return failure(std::move(wrong));
  if (name == LookAheadFollower::kName) return std::make_unique<LookAheadFollower>(setup);
  if (name == RegulatedPurePursuit::kName) return std::make_unique<RegulatedPurePursuit>(setup);
  if (name == ControlPointAimer::kName) {
    auto points = controlPoints(Polyline{setup.route.vertices}, setup.route.controlSpacing);
    if (!points) return tl::unexpected{points.error()};
    return std::make_unique<ControlPointAimer>(setup, std::move(*points));
  }
  std::string known;
  for (std::string_view n : kNames) known += (known.empty() ? "" : ", ") + std::string{n};
  return failure("There is no controller \"" + std::string{name} + "\"; there are: " + known + ".");
}

}  // namespace tessera::drive
