// The parameters of an E32 module (SX1278, data sheet v1.2), as its registers hold them, and the words that read and
// write them. The firmware configures the vehicle's module by itself; this is for the host's own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/result.h"
#include "wire/bytes.h"

namespace tessera::link {

struct E32Parameters {
  enum class Parity : std::uint8_t { None, Odd, Even };

  std::uint16_t address = 0;       ///< all modules of a channel share one
  int channel = 23;                ///< 410 + channel MHz, 0 to 31
  int airRate = 5;                 ///< 0 to 5: 0.3, 1.2, 2.4, 4.8, 9.6, 19.2 kbit/s
  int baud = 115200;               ///< of the UART in normal mode: 1200 to 115200 bit/s, 8N1
  int power = 0;                   ///< 0 to 3: 20, 17, 14, 10 dBm
  bool fixedTransmission = false;  ///< the first three bytes of each packet are an address: not what vehicles expect
  bool forwardErrorCorrection = true;
  Parity parity = Parity::None;  ///< of the UART in normal mode
  bool pushPull = true;          ///< TXD and AUX drive both ways; false: open collector, needs outside resistors
  int wakeUp = 0;                ///< 0 to 7: 250 to 2000 ms, for the power-saving modes that Tessera does not use
  bool operator==(const E32Parameters&) const = default;
};

inline constexpr std::array<double, 6> kE32AirRates{300, 1200, 2400, 4800, 9600, 19200};
inline constexpr std::array<int, 8> kE32Bauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
inline constexpr std::array<int, 4> kE32Powers{20, 17, 14, 10};  ///< dBm

/// What a site's channel asks of every module on it. Error: a value that the module does not have, named.
[[nodiscard]] Result<E32Parameters> e32ParametersFor(int channel, double airBitsPerSecond, int baud);

// What is said to a module in mode 3 (M0 = M1 = 1), always at 9600 8N1.
inline constexpr std::array<std::uint8_t, 3> kE32Read{0xC1, 0xC1, 0xC1};
inline constexpr std::array<std::uint8_t, 3> kE32AskVersion{0xC3, 0xC3, 0xC3};
inline constexpr std::size_t kE32RegistersSize = 6;
using E32Registers = std::array<std::uint8_t, kE32RegistersSize>;

/// C0 (kept without power) or C2 (forgotten), ADDH, ADDL, SPED, CHAN, OPTION. Error: a value out of range, named.
[[nodiscard]] Result<E32Registers> encodeE32(const E32Parameters& parameters, bool keep = true);
/// From a module's answer, which has the same form. Nullopt: these six bytes are none.
[[nodiscard]] std::optional<E32Parameters> decodeE32(wire::Bytes bytes);

/// A module's answer to kE32AskVersion: C3, then these.
struct E32Version {
  std::uint8_t band = 0;  ///< 0x32: 433 MHz
  std::uint8_t version = 0;
  std::uint8_t features = 0;
  bool operator==(const E32Version&) const = default;
};
[[nodiscard]] std::optional<E32Version> decodeE32Version(wire::Bytes bytes);

}  // namespace tessera::link
