// Keeps the settings and the start counter in the EEPROM. Two copies of the settings are written in turn and read back,
// so that the power may go at any instant: the vehicle starts with the old settings or with the new ones.
#pragma once

#include "firmware/vehicle/eeprom.h"
#include "firmware/vehicle/settings.h"

namespace tessera::firmware {

class SettingsStore {
public:
  explicit SettingsStore(Board& board) : eeprom_{board} {}

  /// Carries start-up and saving on; ready() some 10 ms after the start, at the latest 100 ms after it.
  void poll(Micros now);
  [[nodiscard]] bool ready() const { return state_ >= State::Ready; }

  /// The defaults where the EEPROM holds none.
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// In force at once; in the EEPROM some 30 ms later. Saves in between are merged into one.
  void save(const Settings& settings);
  [[nodiscard]] bool saving() const { return dirty_ || state_ > State::Ready; }

  /// The EEPROM holds settings: found at the start, or saved since.
  [[nodiscard]] bool found() const { return found_; }
  /// Nothing was found, or the last write did not read back.
  [[nodiscard]] bool faulty() const { return !found_ || !written_; }
  /// Starts of this vehicle, this one included; 0 when the EEPROM cannot count them.
  [[nodiscard]] std::uint32_t starts() const { return starts_; }

private:
  enum class State : std::uint8_t { Load, Count, CheckCount, Ready, Check };
  void load(Micros now);
  bool readAll();
  void checkCount();
  void startWriting();
  void checkCopy();

  Eeprom eeprom_;
  Settings settings_;
  State state_ = State::Load;
  Micros nextTry_{0};
  int tries_ = 0;
  std::uint32_t sequence_ = 0;
  std::uint32_t starts_ = 0;
  std::uint8_t copy_ = 1;  ///< the one in force
  bool found_ = false;
  bool written_ = true;
  bool dirty_ = false;
};

}  // namespace tessera::firmware
