#include "firmware/boards/lm3s6965/uart.h"

#include "firmware/boards/lm3s6965/clock.h"
#include "firmware/boards/lm3s6965/interrupt_lock.h"

namespace tessera::firmware::lm3s6965 {
namespace {

constexpr std::uint32_t kFrBusy = 1U << 3, kFrRxEmpty = 1U << 4, kFrTxFull = 1U << 5;
constexpr std::uint32_t kDrErrors = 0xF00;  // overrun, break, parity, framing
constexpr std::uint32_t kLcrh8N1 = 3U << 5, kLcrhFifo = 1U << 4;
constexpr std::uint32_t kCtlEnable = 1U << 0, kCtlTransmit = 1U << 8, kCtlReceive = 1U << 9;
constexpr std::uint32_t kIntReceive = 1U << 4, kIntTransmit = 1U << 5, kIntReceiveTimeOut = 1U << 6;

}  // namespace

void UartPort::setBaud(std::uint32_t baud) {
  const InterruptLock lock;
  registers_.IM = 0;
  registers_.CTL = 0;
  registers_.LCRH = 0;  // flushes both hardware queues
  received_.clear();
  toSend_.clear();
  const std::uint32_t divisor = uartDivisor(kClockHz, baud);
  registers_.IBRD = divisor >> 6;
  registers_.FBRD = divisor & 63U;
  registers_.LCRH = kLcrh8N1 | kLcrhFifo;  // this write takes the divisor over
  registers_.IFLS = 0;                     // interrupt at one eighth: two bytes in, or two left to go out
  registers_.ICR = 0x7FF;
  registers_.IM = kIntReceive | kIntReceiveTimeOut;
  registers_.CTL = kCtlEnable | kCtlTransmit | kCtlReceive;
}

std::size_t UartPort::read(std::span<std::uint8_t> out) {
  std::size_t count = 0;
  while (count < out.size() && received_.take(out[count])) ++count;
  return count;
}

std::size_t UartPort::write(std::span<const std::uint8_t> data) {
  std::size_t count = 0;
  while (count < data.size() && toSend_.put(data[count])) ++count;
  // The transmit interrupt comes when the hardware queue drains to its mark, hence never for a queue that was not
  // filled above it: the first bytes are put by hand, with the handler kept from taking at the same time.
  registers_.IM = kIntReceive | kIntReceiveTimeOut;
  fillTransmitter();
  if (!toSend_.empty()) registers_.IM = kIntReceive | kIntReceiveTimeOut | kIntTransmit;
  return count;
}

bool UartPort::sent() const { return toSend_.empty() && (registers_.FR & kFrBusy) == 0; }

void UartPort::onInterrupt() {
  const std::uint32_t why = registers_.MIS;
  registers_.ICR = why;
  while ((registers_.FR & kFrRxEmpty) == 0) {
    const std::uint32_t word = registers_.DR;
    const bool kept = (word & kDrErrors) == 0 && received_.put(static_cast<std::uint8_t>(word));
    if (!kept) lost_ = lost_ + 1;
  }
  if ((why & kIntTransmit) != 0) {
    fillTransmitter();
    if (toSend_.empty()) registers_.IM = kIntReceive | kIntReceiveTimeOut;
  }
}

void UartPort::fillTransmitter() {
  std::uint8_t byte = 0;
  while ((registers_.FR & kFrTxFull) == 0 && toSend_.take(byte)) registers_.DR = byte;
}

}  // namespace tessera::firmware::lm3s6965
