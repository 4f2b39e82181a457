// One vehicle in the world: wheels, sensors, battery and reader row around a host that runs its firmware. The radio's
// bytes are handed in and out; what carries them is somebody else's. True values are for the world and the truth log.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/pose.h"
#include "floor/site.h"
#include "floor/site_map.h"
#include "sim/battery.h"
#include "sim/compass_field.h"
#include "sim/plant.h"
#include "sim/rangers.h"
#include "sim/reader_row.h"
#include "sim/vehicle_host.h"

namespace tessera::sim {

/// How well the parts of one vehicle's body work.
struct BodyParameters {
  PlantParameters plant;
  CompassParameters compass;
  ReaderParameters readers;
  RangerParameters rangers;
  BatteryParameters battery;
  std::optional<Metres> headingLearning;  ///< of the firmware's settings (Parameter::HeadingLearning); its own default
};

/// The defaults, with the sizes that the vehicle's setup states.
[[nodiscard]] BodyParameters bodyParametersFor(const floor::VehicleSetup& setup);

struct VehicleWorldConfig {
  floor::VehicleSetup setup;
  BodyParameters body;
  Pose start;
  std::shared_ptr<const floor::SiteMap> map;  ///< the tags that lie there; none where null
  Radians northToY;                           ///< see floor::Site
  std::vector<MagneticSpot> spots;
  Scene scene;
  std::uint64_t seed = 1;  ///< of the world; the vehicle's address makes each vehicle differ
};

class VehicleBody {
public:
  VehicleBody(const VehicleWorldConfig& config, std::unique_ptr<VehicleHost> host);

  /// Switches the vehicle on; the world's clock stands at `now`.
  Result<void> start(Seconds now);
  /// Moves on to `now`, in one step: 1 ms in a running world.
  void step(Seconds now);

  // The radio's wires.
  [[nodiscard]] std::vector<std::uint8_t> takeRadioBytes();
  void giveRadioBytes(std::span<const std::uint8_t> bytes);
  [[nodiscard]] firmware::RadioMode radioMode() const { return radioMode_; }
  void setRadioReady(bool ready) { signals_.radioReady = ready; }

  // The truth.
  [[nodiscard]] VehicleId id() const { return id_; }
  [[nodiscard]] const Pose& pose() const { return plant_.pose(); }
  [[nodiscard]] MetresPerSecond speed() const { return plant_.speed(); }
  [[nodiscard]] RadiansPerSecond turnRate() const { return plant_.turnRate(); }
  [[nodiscard]] const std::array<int, 2>& duty() const { return duty_; }
  [[nodiscard]] double batteryVolts() const { return battery_.volts(); }

  // What may happen to a vehicle.
  /// Lifted and set down elsewhere.
  void setPose(const Pose& pose) { plant_.setPose(pose); }
  /// What its rangers see from now on, other vehicles included.
  void setScene(Scene scene) { scene_ = std::move(scene); }
  [[nodiscard]] Plant& plant() { return plant_; }
  [[nodiscard]] ReaderRow& readers() { return readers_; }
  [[nodiscard]] Rangers& rangers() { return rangers_; }
  [[nodiscard]] VehicleHost& host() { return *host_; }
  [[nodiscard]] const VehicleHost& host() const { return *host_; }

private:
  VehicleId id_;
  Plant plant_;
  CompassField compass_;
  ReaderRow readers_;
  Rangers rangers_;
  Battery battery_;
  Scene scene_;
  std::unique_ptr<VehicleHost> host_;
  Signals signals_;
  std::array<int, 2> duty_{};
  firmware::RadioMode radioMode_ = firmware::RadioMode::Normal;
  std::vector<std::uint8_t> fromVehicle_;
  std::vector<std::uint8_t> toVehicle_;
  Seconds now_;
  Seconds nextRanging_;
};

}  // namespace tessera::sim
