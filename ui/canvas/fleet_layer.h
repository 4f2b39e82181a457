// What the canvas knows of the vehicles between two snapshots: where to draw them now, their trails, the tags just
// read.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "supervisor/snapshot.h"
#include "ui/canvas/trail.h"

namespace tessera::ui {

/// How a vehicle stands with its orders, as far as the picture tells it by shape.
enum class VehicleLook { Fine, Waiting, Paused, Obstacle, Fault, Silent };
[[nodiscard]] VehicleLook lookOf(const supervisor::VehicleView& v);

/// Where a vehicle is `since` after its snapshot: straight on at the reported speed, for at most kSmoothing, and not
/// at all when the report behind the snapshot is old.
inline constexpr Seconds kSmoothing{0.2};
inline constexpr Seconds kOldReport{0.8};
[[nodiscard]] Pose poseAfter(const supervisor::VehicleView& v, Seconds since);
/// Whether poseAfter() changes with time.
[[nodiscard]] bool isMoving(const supervisor::VehicleView& v);

class FleetLayer {
public:
  static constexpr Seconds kFlash{0.5};

  struct Flash {
    Point place;
    Seconds since;  ///< the snapshot's clock
    VehicleId vehicle;
  };

  void setSnapshot(std::shared_ptr<const supervisor::Snapshot> snapshot);
  /// Trails and flashes of another site mean nothing here.
  void clear();

  [[nodiscard]] const supervisor::Snapshot* snapshot() const { return snapshot_.get(); }
  /// Nullptr: never drawn.
  [[nodiscard]] const Trail* trail(VehicleId id) const;
  [[nodiscard]] const std::vector<Flash>& flashes() const { return flashes_; }
  /// `sinceSnapshot` has passed: flashes that are over are dropped. True while anything moves or fades by itself.
  bool advance(Seconds sinceSnapshot);

private:
  void takeReads(const supervisor::VehicleView& vehicle);

  std::shared_ptr<const supervisor::Snapshot> snapshot_;
  std::unordered_map<VehicleId, Trail> trails_;
  std::unordered_map<VehicleId, Seconds> lastRead_;
  std::vector<Flash> flashes_;
};

}  // namespace tessera::ui
