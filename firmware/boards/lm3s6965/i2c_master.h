// Master of the I2C bus with the compass and the EEPROM: whole transfers, each closed with STOP, none waits for ever.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/boards/lm3s6965/registers.h"

namespace tessera::firmware::lm3s6965 {

/// A register is read by writing its pointer, STOP, and reading: there is no repeated START here, as the parts on this
/// bus do not need it and some models of the controller do not have it.
class I2cMaster {
public:
  explicit I2cMaster(I2cRegisters& registers);

  /// False when nobody acknowledges, the bus is held by somebody else, or there is nothing to transfer.
  [[nodiscard]] bool write(std::uint8_t address, std::span<const std::uint8_t> data);
  [[nodiscard]] bool read(std::uint8_t address, std::span<std::uint8_t> out);

private:
  [[nodiscard]] bool busFree();
  [[nodiscard]] bool step(std::uint32_t command);
  [[nodiscard]] bool waitWhile(std::uint32_t status);
  void abandon();

  I2cRegisters& registers_;
};

}  // namespace tessera::firmware::lm3s6965
