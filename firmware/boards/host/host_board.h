// The vehicle's electronics inside the world's process: the same board interface as the microcontroller's, with a clock
// that the world moves on. One object per vehicle; any number of them in a process.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "firmware/boards/host/i2c_devices.h"
#include "firmware/boards/host/paced_queue.h"
#include "firmware/vehicle/board.h"

namespace tessera::firmware {

/// What the world shows to pins and sensors.
struct HostInputs {
  std::array<std::int64_t, 2> encoderCounts{};  ///< left, right
  ChipField field{};                            ///< µT along the compass chip's axes
  std::array<double, kRangers> range{};         ///< m; 0 or less: nothing in reach; NaN: a dead ranger
  bool radioReady = true;                       ///< AUX
};

class HostBoard final : public Board {
public:
  static constexpr std::uint64_t kWatchdogTime = 500'000;  ///< µs

  explicit HostBoard(const EepromChip::Image& eeprom);

  // The world's side. Instants are µs of the world's clock.
  /// Switches on, or starts anew: every chip but the EEPROM forgets.
  void powerOn(std::uint64_t now, wire::ResetCause cause);
  void setInputs(const HostInputs& inputs);
  /// Moves the clock on to `now`; does nothing when the firmware's own work has taken it further already.
  void advanceTo(std::uint64_t now);
  [[nodiscard]] std::uint64_t now() const { return now_; }
  /// Bytes on the wire to this UART; they are received at the pace of its baud, or later.
  void receive(Uart port, std::span<const std::uint8_t> bytes);
  /// Bytes whose last bit has left this UART since the last call.
  [[nodiscard]] std::vector<std::uint8_t> takeSent(Uart port);
  [[nodiscard]] const std::array<int, 2>& duty() const { return duty_; }
  [[nodiscard]] RadioMode radioMode() const { return radioMode_; }
  /// The firmware asked for a restart, or has not fed the watchdog for too long.
  [[nodiscard]] bool restartDue() const { return restartAsked_ || watchdogExpired(); }
  [[nodiscard]] wire::ResetCause nextCause() const;
  [[nodiscard]] const EepromChip::Image& eeprom() const { return eeprom_.image(); }
  /// A chip that does not answer, for tests of what the firmware does then.
  void setCompassPresent(bool present) { compassPresent_ = present; }
  void setEepromPresent(bool present) { eepromPresent_ = present; }

  // The firmware's side. Calls that take time on the chip move the clock on.
  std::uint32_t micros() override;
  std::size_t read(Uart port, std::span<std::uint8_t> out) override;
  std::size_t write(Uart port, std::span<const std::uint8_t> data) override;
  bool sent(Uart port) override;
  void setBaud(Uart port, std::uint32_t baud) override;
  void setRadioMode(RadioMode mode) override;
  bool radioReady() override { return inputs_.radioReady; }
  bool i2cWrite(std::uint8_t address, std::span<const std::uint8_t> data) override;
  bool i2cRead(std::uint8_t address, std::span<std::uint8_t> out) override;
  void drive(Wheel wheel, std::int16_t permille) override;
  std::int32_t counts(Wheel wheel) override;
  void ping(std::size_t ranger) override;
  std::uint32_t echo(std::size_t ranger) override;
  void feedWatchdog() override { fedAt_ = now_; }
  wire::ResetCause resetCause() override { return cause_; }
  void restart() override { restartAsked_ = true; }
  std::uint8_t hardware() override { return 2; }
  std::uint32_t stackFree() override { return 0; }

private:
  struct Port {
    // The driver's ring buffers, as on the microcontroller.
    PacedQueue in{256};
    PacedQueue out{256};
    std::vector<std::uint8_t> left;  ///< sent, not yet taken by the world
  };
  struct Echo {
    std::uint64_t end = 0;
    std::uint32_t length = 0;
  };
  [[nodiscard]] std::uint64_t nanos() const { return now_ * 1000; }
  [[nodiscard]] bool watchdogExpired() const { return now_ > fedAt_ + kWatchdogTime; }
  void collectSent(Port& port);
  Port& port(Uart which) { return ports_[static_cast<std::size_t>(which)]; }
  void spendOnI2c(std::size_t bytes);

  std::array<Port, 2> ports_;
  CompassChip compass_;
  EepromChip eeprom_;
  bool compassPresent_ = true;
  bool eepromPresent_ = true;
  HostInputs inputs_;
  std::array<std::int64_t, 2> countsAtStart_{};
  std::array<int, 2> duty_{};
  std::array<Echo, kRangers> echoes_{};
  RadioMode radioMode_ = RadioMode::Normal;
  std::uint64_t now_ = 0;
  std::uint64_t startedAt_ = 0;
  std::uint64_t fedAt_ = 0;
  wire::ResetCause cause_ = wire::ResetCause::PowerOn;
  bool restartAsked_ = false;
};

}  // namespace tessera::firmware
