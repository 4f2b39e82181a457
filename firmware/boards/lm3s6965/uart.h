// One serial port (PL011) with a queue each way, served by its interrupt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/boards/lm3s6965/registers.h"
#include "firmware/boards/lm3s6965/ring.h"

namespace tessera::firmware::lm3s6965 {

class UartPort {
public:
  /// The port is idle until setBaud().
  explicit UartPort(UartRegisters& registers) : registers_{registers} {}

  /// 8N1 at `baud`, 50 to 3,000,000; what was under way in either direction is dropped.
  void setBaud(std::uint32_t baud);
  std::size_t read(std::span<std::uint8_t> out);
  std::size_t write(std::span<const std::uint8_t> data);
  [[nodiscard]] bool sent() const;
  /// Bytes that were dropped: queue full, or damaged on the line.
  [[nodiscard]] std::uint32_t lost() const { return lost_; }

  void onInterrupt();

private:
  void fillTransmitter();

  static constexpr std::size_t kQueue = 256;
  UartRegisters& registers_;
  Ring<kQueue> received_;
  Ring<kQueue> toSend_;
  std::uint32_t lost_ = 0;
};

/// The baud rate divisor in 1/64: IBRD above the lower six bits, FBRD in them.
[[nodiscard]] constexpr std::uint32_t uartDivisor(std::uint32_t clockHz, std::uint32_t baud) {
  return (clockHz * 4U + baud / 2U) / baud;
}

}  // namespace tessera::firmware::lm3s6965
