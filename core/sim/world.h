// The simulated world: vehicles on a floor, the air between their radios and the host's, and the wire from the host's
// module to the supervisor. Virtual time: whoever calls advance() decides how fast it runs. Through hostBytes() and
// takeHostBytes() pass the very bytes that would pass through a serial port, and nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/air.h"
#include "sim/e32.h"
#include "sim/truth_log.h"
#include "sim/vehicle_body.h"

namespace tessera::sim {

struct WorldConfig {
  floor::RadioSetup radio;  ///< as the host's module is set
  AirSettings air;
  Scene scene;  ///< what reflects sound, the vehicles themselves apart
  std::uint64_t seed = 1;
  Seconds start;  ///< the world's clock at the beginning
};

/// Vehicles are named by their address; the operations that take one answer false when there is none.
class World {
public:
  static constexpr Seconds kStep{0.001};
  static constexpr Seconds kTruthPeriod{0.02};

  explicit World(const WorldConfig& config);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  /// Ends every vehicle's host.
  ~World();

  /// Takes a vehicle in, switched off, its radio module as from the factory. extent: radius of the circle as which
  /// other vehicles' rangers see it.
  void add(std::unique_ptr<VehicleBody> vehicle, Metres extent);
  /// Switches a vehicle on. Error: there is none, or its host's reason.
  Result<void> start(VehicleId vehicle);
  /// Switches all vehicles on, stopping at the first that fails.
  Result<void> startAll();

  /// Moves on in steps of kStep, up to `now`. A call takes as long as it takes: real-time callers ask for little at
  /// once.
  void advance(Seconds now);
  /// Moves the clock on without running the steps in between, for a caller that could not keep up. Vehicles roll on.
  void skipTo(Seconds now);
  [[nodiscard]] Seconds time() const { return time_; }

  // The host's serial port.
  /// Takes bytes for the radio; those that do not fit into a port's buffer of kPortRoom are dropped, see hostRoom().
  void hostBytes(std::span<const std::uint8_t> bytes);
  /// How many bytes the port takes now.
  [[nodiscard]] std::size_t hostRoom() const;
  [[nodiscard]] std::vector<std::uint8_t> takeHostBytes();
  static constexpr std::size_t kPortRoom = 1024;
  /// Sets the jumpers M0 and M1 of the host's module; it changes over when it has nothing left to send or to tell.
  void setHostMode(firmware::RadioMode mode);

  // The truth.
  [[nodiscard]] std::vector<VehicleId> vehicles() const;
  [[nodiscard]] std::optional<TrueState> truth(VehicleId vehicle) const;
  /// True states of all vehicles go there each kTruthPeriod from now on.
  void setTruthLog(TruthLog log) { truthLog_ = std::move(log); }
  /// What went wrong by itself since the last call: a vehicle's host that ended, a full disk. Sentences.
  [[nodiscard]] std::vector<std::string> takeTroubles();

  // What may happen.
  /// Its battery is pulled.
  bool kill(VehicleId vehicle);
  [[nodiscard]] bool running(VehicleId vehicle) const;
  /// Lifted and set down elsewhere: by an offset in site axes and a turn.
  bool push(VehicleId vehicle, Offset by, Radians turn);
  void addObstacle(const Post& post);
  void clearObstacles();
  /// A stranger's bytes on the channel.
  void inject(std::span<const std::uint8_t> bytes);
  /// `count` random bytes on the channel, seeded.
  void noise(std::size_t count);
  [[nodiscard]] ChannelTap& tap() { return air_.tap(); }

  [[nodiscard]] const Air& air() const { return air_; }
  [[nodiscard]] const E32& hostRadio() const { return host_; }
  /// Nullptr: no such vehicle.
  [[nodiscard]] const E32* radio(VehicleId vehicle) const;
  [[nodiscard]] VehicleBody* body(VehicleId vehicle);

private:
  struct Vehicle {
    std::unique_ptr<VehicleBody> body;
    E32 radio;
    Metres extent;
    bool wanted = false;  ///< switched on and not killed
  };
  [[nodiscard]] Vehicle* find(VehicleId id) const;
  void step(Seconds now);
  void stepVehicle(Vehicle& vehicle, Seconds now);
  void deliver(Seconds now);
  void writeTruth();
  void showObstacles();

  WorldConfig config_;
  Air air_;
  E32 host_;
  RandomStream noise_;
  std::vector<std::unique_ptr<Vehicle>> vehicles_;
  std::vector<Post> obstacles_;
  std::optional<TruthLog> truthLog_;
  std::vector<std::string> troubles_;
  Seconds epoch_;            ///< of the step count
  std::uint64_t steps_ = 0;  ///< since the epoch; keeps time free of summed rounding
  std::uint64_t ticks_ = 0;  ///< steps in all
  Seconds time_;
};

}  // namespace tessera::sim
