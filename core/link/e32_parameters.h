// The parameters of an E32 module (SX1278, data sheet v1.2), as its registers hold them, and the words that read and
// write them. The firmware configures the vehicle's module by itself; this is for the host's own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tessera::link {

struct E32Parameters {
  std::uint16_t address = 0;       ///< all modules of a channel share one
  int channel = 23;                ///< 410 + channel MHz, 0 to 31
  int airRate = 5;                 ///< 0 to 5: 0.3, 1.2, 2.4, 4.8, 9.6, 19.2 kbit/s
  int baud = 115200;               ///< of the UART in normal mode: 1200 to 115200 bit/s, 8N1
  int power = 0;                   ///< 0 to 3: 20, 17, 14, 10 dBm
  bool fixedTransmission = false;  ///< the first three bytes of each packet are an address: not what vehicles expect
  bool forwardErrorCorrection = true;
  bool operator==(const E32Parameters&) const = default;
};

}  // namespace tessera::link
