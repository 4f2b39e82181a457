// The vehicle: all its parts put together over one board. main() calls poll() as often as it can and tick() 100 times
// a second; nothing else happens, and neither ever waits.
#pragma once

#include <optional>

#include "firmware/vehicle/board.h"
#include "firmware/vehicle/pilot.h"
#include "firmware/vehicle/radio.h"
#include "firmware/vehicle/reader_row.h"
#include "firmware/vehicle/session.h"
#include "firmware/vehicle/settings_store.h"
#include "firmware/vehicle/tag_log.h"

namespace tessera::firmware {

class Vehicle {
public:
  explicit Vehicle(Board& board);
  Vehicle(const Vehicle&) = delete;
  Vehicle& operator=(const Vehicle&) = delete;

  /// Bytes in and out: radio, reader bus, EEPROM. To be called at least once a millisecond.
  void poll();
  /// Sensing and driving. To be called every 10 ms. The watchdog is fed here, and only when poll() has run since.
  void tick();

private:
  void start(Micros now);
  void hear(const Heard& heard, Micros now);
  void reply(Micros now);
  [[nodiscard]] wire::Report report(Micros now);
  [[nodiscard]] std::uint16_t faults();
  void keepCalibration();
  void restartWhenDue(Micros now);

  // Requests of the host (vehicle_requests.cpp): each returns its outcome and puts the value of the answer in `value`.
  void handle(const wire::Request& request, Micros now);
  wire::Outcome get(wire::Parameter parameter, std::int32_t& value);
  wire::Outcome set(wire::Parameter parameter, std::int32_t value);
  wire::Outcome act(wire::Action action, Micros now);
  void use(const Settings& settings);
  // Another key (vehicle_requests.cpp): kept in the EEPROM first, then in force, then answered.
  void pair(const Heard& heard, Micros now);
  void carryPairingOn(Micros now);

  Board& board_;
  Clock clock_;
  SettingsStore store_;
  Radio radio_;
  Session session_;
  ReaderRow readers_;
  TagLog tags_;
  Pilot pilot_;
  bool started_ = false;
  bool polled_ = false;
  bool batteryLow_ = false;
  std::optional<wire::Key> keyBefore_;  ///< while another one is being written
  std::uint32_t longestTick_ = 0;
  std::optional<Micros> restartAt_;
};

}  // namespace tessera::firmware
