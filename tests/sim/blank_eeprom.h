// An EEPROM that was never written.
#pragma once

#include "firmware/boards/host/i2c_devices.h"

namespace tessera::firmware {

inline EepromChip::Image blank() {
  EepromChip::Image image;
  image.fill(0xFF);
  return image;
}

}  // namespace tessera::firmware
