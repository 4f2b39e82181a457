// What an operator (or a programme) asks of the supervisor. Plain values, posted from any thread, carried out at the
// next tick. An order that cannot be carried out becomes an event with the reason; none is dropped in silence.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "base/ids.h"
#include "base/units.h"
#include "floor/site_map.h"
#include "locate/magnetic_map.h"
#include "wire/messages.h"

namespace tessera::supervisor {

/// Drive along a route of the site, from wherever the vehicle stands near it, at most this fast. Replaces a running
/// one.
struct RunRoute {
  VehicleId vehicle;
  std::string route;
  MetresPerSecond speed;  ///< above 0; limited to the vehicle's own maximum
  bool operator==(const RunRoute&) const = default;
};

/// Stand, and keep the route: Resume goes on from here.
struct Pause {
  VehicleId vehicle;
  bool operator==(const Pause&) const = default;
};
struct Resume {
  VehicleId vehicle;
  bool operator==(const Resume&) const = default;
};

/// Stand and give the route up. Goes before everything else on the air. Nothing moves again without a new RunRoute.
struct Stop {
  VehicleId vehicle;
  bool operator==(const Stop&) const = default;
};
struct StopAll {
  bool operator==(const StopAll&) const = default;
};

/// Forget latched faults whose cause is gone.
struct Clear {
  VehicleId vehicle;
  bool operator==(const Clear&) const = default;
};

/// Read or write a parameter, or start an action. The answer comes as an event of kind Answer.
struct Ask {
  VehicleId vehicle;
  wire::Request request;
  bool operator==(const Ask&) const = default;
};

/// Give the vehicle another long-term key over the air. It must be connected and stand. Whoever orders this keeps the
/// new key in a safe place first, as the vehicle may have it from then on; the event Paired tells which key it has.
struct Pair {
  VehicleId vehicle;
  wire::Key newKey{};
  bool operator==(const Pair&) const = default;
};

/// A Jog holds this long; the vehicle stops when no other has come by then.
inline constexpr Seconds kJogHolds{0.3};
/// By hand no vehicle drives faster than this.
inline constexpr MetresPerSecond kJogFastest{0.15};

/// Drive by hand while a key is held; to be repeated about every 100 ms. Needs no known place. Speed 0 turns on the
/// spot. Refused while a route runs, and after a Stop until the keys have been let go for kJogHolds.
struct Jog {
  VehicleId vehicle;
  MetresPerSecond speed;      ///< negative backwards; limited to kJogFastest and the vehicle's maximum
  RadiansPerSecond turnRate;  ///< positive counter-clockwise; limited to the vehicle's maximum
  bool operator==(const Jog&) const = default;
};

/// Tell of this vehicle how it is located, in each snapshot from now on (Snapshot::watched); nullopt: of none. There is
/// one at a time.
struct Watch {
  std::optional<VehicleId> who;
  bool operator==(const Watch&) const = default;
};

/// Go on with an edited site: its routes can be run at once, a running one goes on as it was given. Refused when its
/// vehicles (but for their names and start places) or its radio are others.
struct UseSite {
  std::shared_ptr<const floor::SiteMap> map;
  bool operator==(const UseSite&) const = default;  ///< the same map, not an equal one
};

/// Go on with this magnetic map of the floor instead of the one learned so far; null: with an empty one. It is
/// Snapshot::magnetic until something is learned.
struct UseMagneticMap {
  std::shared_ptr<const locate::MagneticMap> map;
  bool operator==(const UseMagneticMap&) const = default;  ///< the same map, not an equal one
};

using Order =
    std::variant<RunRoute, Pause, Resume, Stop, StopAll, Clear, Ask, Pair, Jog, Watch, UseSite, UseMagneticMap>;

}  // namespace tessera::supervisor
