// What the vehicle's logic knows of its electronics. One implementation touches the LM3S6965's registers, the other
// one joins the same logic to a simulated vehicle in the same process. Nothing here blocks for longer than stated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/messages.h"

namespace tessera::firmware {

enum class Uart : std::uint8_t { Radio = 0, Readers = 1 };
enum class Wheel : std::uint8_t { Left = 0, Right = 1 };
/// The E32's mode pins: M0 | M1 << 1.
enum class RadioMode : std::uint8_t { Normal = 0, WakeUp = 1, PowerSaving = 2, Configure = 3 };

inline constexpr std::size_t kRangers = 2;

class Board {
public:
  /// Free-running, wraps after 71 minutes.
  virtual std::uint32_t micros() = 0;

  /// Takes what has arrived, at most out.size() bytes; returns how many. Never waits.
  virtual std::size_t read(Uart port, std::span<std::uint8_t> out) = 0;
  /// Hands over bytes for sending; returns how many were taken. Never waits.
  virtual std::size_t write(Uart port, std::span<const std::uint8_t> data) = 0;
  /// True when every byte handed over has left.
  virtual bool sent(Uart port) = 0;
  /// 8N1 at the given rate; drops what was under way.
  virtual void setBaud(Uart port, std::uint32_t baud) = 0;

  virtual void setRadioMode(RadioMode mode) = 0;
  /// The E32's AUX pin: high when the module is idle.
  virtual bool radioReady() = 0;

  /// Writes to a device on I2C bus 0, closing with STOP. False when it does not answer. At most 1 ms at 400 kHz.
  virtual bool i2cWrite(std::uint8_t address, std::span<const std::uint8_t> data) = 0;
  /// Reads from a device on I2C bus 0, closing with STOP. False when it does not answer.
  virtual bool i2cRead(std::uint8_t address, std::span<std::uint8_t> out) = 0;

  /// PWM duty in 1/1000 with sign, -1000 to 1000; 0 brakes.
  virtual void drive(Wheel wheel, std::int16_t permille) = 0;
  /// Quadrature counts since start, forwards positive, wrapping.
  virtual std::int32_t counts(Wheel wheel) = 0;

  /// Sends a trigger pulse of at least 10 µs. The echo is measured in the background.
  virtual void ping(std::size_t ranger) = 0;
  /// Length in µs of the pulse that answered the last ping, some 38 ms when nothing was in reach; 0 while none has
  /// come to its end.
  virtual std::uint32_t echo(std::size_t ranger) = 0;

  /// To be called at least every 0.5 s, or the vehicle restarts.
  virtual void feedWatchdog() = 0;
  virtual wire::ResetCause resetCause() = 0;
  /// Ends this run; the vehicle starts anew.
  virtual void restart() = 0;
  /// Identity::hardware
  virtual std::uint8_t hardware() = 0;
  /// Bytes of stack never touched; 0 where unknown.
  virtual std::uint32_t stackFree() = 0;

protected:
  ~Board() = default;
};

}  // namespace tessera::firmware
