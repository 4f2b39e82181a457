#include "link/e32_parameters.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace tessera::link {
namespace {

constexpr std::uint8_t kKeep = 0xC0;
constexpr std::uint8_t kForget = 0xC2;
constexpr std::uint8_t kVersionHead = 0xC3;

std::optional<unsigned> bitsOfBaud(int baud) {
  const auto* const at = std::find(kE32Bauds.begin(), kE32Bauds.end(), baud);
  if (at == kE32Bauds.end()) return std::nullopt;
  return static_cast<unsigned>(at - kE32Bauds.begin());
}

bool within(int value, int highest) { return value >= 0 && value <= highest; }

}  // namespace

Result<E32Parameters> e32ParametersFor(int channel, double airBitsPerSecond, int baud) {
  const auto* const rate = std::find_if(kE32AirRates.begin(), kE32AirRates.end(),
                                        [&](double r) { return std::abs(r - airBitsPerSecond) < 0.5; });
  if (rate == kE32AirRates.end())
    return failure("The module has no air rate of " + std::to_string(std::lround(airBitsPerSecond)) +
                   " bit/s: it knows 300, 1200, 2400, 4800, 9600 and 19200.");
  E32Parameters parameters;
  parameters.channel = channel;
  parameters.airRate = static_cast<int>(rate - kE32AirRates.begin());
  parameters.baud = baud;
  if (auto possible = encodeE32(parameters); !possible) return tl::unexpected{possible.error()};
  return parameters;
}

Result<E32Registers> encodeE32(const E32Parameters& p, bool keep) {
  const auto baud = bitsOfBaud(p.baud);
  if (!within(p.channel, 31))
    return failure("The module has no channel " + std::to_string(p.channel) + ": they go from 0 to 31.");
  if (!within(p.airRate, 5))
    return failure("The module has no air rate number " + std::to_string(p.airRate) + ": they go from 0 to 5.");
  if (!baud)
    return failure("The module has no baud of " + std::to_string(p.baud) +
                   ": it knows 1200, 2400, 4800, 9600, 19200, 38400, 57600 and 115200.");
  if (!within(p.power, 3))
    return failure("The module has no power step " + std::to_string(p.power) +
                   ": they go from 0 (20 dBm) to 3 (10 dBm).");
  if (!within(p.wakeUp, 7))
    return failure("The module has no wake-up step " + std::to_string(p.wakeUp) + ": they go from 0 to 7.");
  const auto number = [](auto v) { return static_cast<unsigned>(v); };
  const unsigned speed = number(p.parity) << 6 | *baud << 3 | number(p.airRate);
  const unsigned option = number(p.fixedTransmission) << 7 | number(p.pushPull) << 6 | number(p.wakeUp) << 3 |
                          number(p.forwardErrorCorrection) << 2 | number(p.power);
  const auto byte = [](unsigned v) { return static_cast<std::uint8_t>(v); };
  return E32Registers{keep ? kKeep : kForget,  byte(p.address >> 8U), byte(p.address), byte(speed),
                      byte(number(p.channel)), byte(option)};
}

std::optional<E32Parameters> decodeE32(wire::Bytes bytes) {
  if (bytes.size() != kE32RegistersSize || (bytes[0] != kKeep && bytes[0] != kForget) || bytes[4] > 31)
    return std::nullopt;
  const unsigned speed = bytes[3];
  const unsigned option = bytes[5];
  E32Parameters p;
  p.address = static_cast<std::uint16_t>(bytes[1] << 8 | bytes[2]);
  p.channel = bytes[4];
  p.airRate = static_cast<int>(std::min(speed & 7U, 5U));  // 6 and 7 mean 19.2k as well
  p.baud = kE32Bauds[speed >> 3U & 7U];
  const unsigned parity = speed >> 6U;
  p.parity = parity == 3 ? E32Parameters::Parity::None : static_cast<E32Parameters::Parity>(parity);  // 3 means 8N1
  p.fixedTransmission = (option & 0x80U) != 0;
  p.pushPull = (option & 0x40U) != 0;
  p.wakeUp = static_cast<int>(option >> 3U & 7U);
  p.forwardErrorCorrection = (option & 0x04U) != 0;
  p.power = static_cast<int>(option & 3U);
  return p;
}

std::optional<E32Version> decodeE32Version(wire::Bytes bytes) {
  if (bytes.size() != 4 || bytes[0] != kVersionHead) return std::nullopt;
  return E32Version{bytes[1], bytes[2], bytes[3]};
}

}  // namespace tessera::link
