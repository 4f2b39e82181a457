// The tick: bytes, orders and time in; bytes, events and a picture of the fleet out. Pure: no clock, no thread, no
// port. The same inputs at the same instants give the same outputs, byte for byte.
//
// Whoever owns the port does, in any order: portOpened / portLost when it changes, ingest when bytes arrive, post for
// orders, and tick whenever bytes came, an order was posted, or the instant that the last tick named has come.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "floor/site_map.h"
#include "locate/magnetic_map.h"
#include "supervisor/event.h"
#include "supervisor/order.h"
#include "supervisor/snapshot.h"

namespace tessera::supervisor {

struct Config {
  std::string locator;              ///< name for locate's factory; empty: its default
  std::string controller;           ///< name for drive's factory; empty: its default
  std::vector<VehicleId> vehicles;  ///< to look after; empty: all of the site
  std::uint64_t seed = 1;           ///< of the nonces and of the locators; from a true random source in a real run
  Seconds tick{0.02};               ///< longest time between two ticks
  /// Keys that vehicles may have by now instead of the site's: pairings whose end was not heard before the last run
  /// ended. Both are tried, and the event Paired tells which one it is.
  std::map<VehicleId, wire::Key> offeredKeys{};
  /// What is known of the floor's iron; null: nothing yet.
  std::shared_ptr<const locate::MagneticMap> magnetic{};
  bool byMagneticMap = false;  ///< vehicles are located by it as well
};

struct TickOutput {
  std::vector<std::uint8_t> bytes;           ///< for the port, one radio frame at most; to be written in one go
  std::shared_ptr<const Snapshot> snapshot;  ///< null: nothing changed since the last one
  std::vector<Event> events;
  Seconds wake;  ///< call tick again at this instant at the latest
};

class Supervisor {
public:
  /// Error: a site that contradicts itself, an unknown locator or controller, or a vehicle that the site does not have.
  [[nodiscard]] static Result<Supervisor> create(std::shared_ptr<const floor::SiteMap> map, Config config);
  Supervisor(Supervisor&&) noexcept;
  Supervisor& operator=(Supervisor&&) noexcept;
  ~Supervisor();

  /// The port stands open; what was on the air before is forgotten.
  void portOpened(std::string name, Seconds now);
  /// reason: the end of a sentence without its full stop, e.g. "the other end is gone".
  void portLost(const Sentence& reason, Seconds now);
  /// Bytes as they came, in pieces of any size; now: when the last of them came.
  void ingest(std::span<const std::uint8_t> bytes, Seconds now);
  /// Carried out by the next tick.
  void post(Order order);
  [[nodiscard]] TickOutput tick(Seconds now);
  /// True when every connected vehicle has acknowledged that it stands by a Stop; for closing down.
  [[nodiscard]] bool allStopped() const;

private:
  struct Impl;
  explicit Supervisor(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace tessera::supervisor
