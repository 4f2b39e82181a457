// The vehicle: all its parts put together over one board. main() calls poll() as often as it can and tick() 100 times
// a second; nothing else happens, and neither ever waits.
#pragma once

#include "firmware/vehicle/board.h"

namespace tessera::firmware {

class Vehicle {
public:
  explicit Vehicle(Board& board);
  Vehicle(const Vehicle&) = delete;
  Vehicle& operator=(const Vehicle&) = delete;

  /// Bytes in and out: radio, reader bus, EEPROM. To be called at least once a millisecond.
  void poll();
  /// Sensing and driving. To be called every 10 ms.
  void tick();

private:
  Board& board_;
};

}  // namespace tessera::firmware
