// A vehicle's settings: the parameters of core/wire/parameters.h with their ranges and defaults, and its key.
// The same code writes the EEPROM on the vehicle and the image with which a host commissions one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "wire/bytes.h"
#include "wire/messages.h"
#include "wire/parameters.h"
#include "wire/security.h"

namespace tessera::firmware {

/// Address of a vehicle that nobody has commissioned yet, or whose settings cannot be read.
inline constexpr std::uint8_t kUncommissionedAddress = 254;

inline constexpr std::uint8_t kSettingCount = 23;

/// Values are in the wire's units (wire::Parameter) and always within their ranges.
class Settings {
public:
  /// The defaults: wheels of 0.10 m, track 0.30 m, 200 counts a turn, 0.5 m/s, 1.5 rad/s, 0.5 m/s², three readers,
  /// radio channel 23 at 19.2 kbit/s and 115200 baud, uncalibrated compass, address 254, key of zeros.
  Settings();

  wire::Key key{};

  /// 0 for a parameter that is not a setting.
  [[nodiscard]] std::int32_t get(wire::Parameter parameter) const;
  /// Done, Unknown (not a setting) or OutOfRange; changes something only when Done.
  wire::Outcome set(wire::Parameter parameter, std::int32_t value);
  [[nodiscard]] static bool has(wire::Parameter parameter);
  /// Everything but address and key.
  void restoreDefaults();

  bool operator==(const Settings&) const = default;

private:
  std::array<std::int32_t, kSettingCount> values_{};
};

// The EEPROM's layout (AT24C32, 4096 bytes, pages of 32):
//
//   0x000  settings, copy A   one record of kRecordSize bytes, little-endian:
//   0x100  settings, copy B     0 "TS" · 2 version u8 (1) · 3 count u8 · 4 sequence u32 · 8 key, 16 bytes ·
//                              24 count values i32, parameter 1 first · CRC-16/CCITT-FALSE over all before
//   0x200  start counter      16 cells, one a page: count u32, its complement u32. Start n writes cell n modulo 16,
//                              so that each page is written once in 16 starts; the highest good cell counts.
//   0x400  free
//
// The copy with the higher sequence (modulo 2^32) is in force; saving writes the other one. A later firmware may append
// parameters: fewer values than known leave the defaults, values that are unknown or out of range are passed over.
inline constexpr std::size_t kEepromSize = 4096;
inline constexpr std::size_t kEepromPage = 32;
inline constexpr std::uint16_t kCopyAddress[2] = {0x000, 0x100};
inline constexpr std::size_t kRecordSize = 26 + 4 * std::size_t{kSettingCount};
inline constexpr std::size_t kRecordRoom = 0x100;
inline constexpr std::uint16_t kStartCells = 0x200;
inline constexpr std::uint16_t kStartCellCount = 16;
inline constexpr std::size_t kStartCellSize = 8;

struct Record {
  std::uint32_t sequence = 0;
  Settings settings;
};
[[nodiscard]] std::array<std::uint8_t, kRecordSize> encodeRecord(const Record& record);
/// From the bytes of one copy; nullopt when they are no whole, undamaged record.
[[nodiscard]] std::optional<Record> decodeRecord(wire::Bytes bytes);

[[nodiscard]] std::array<std::uint8_t, kStartCellSize> encodeStartCell(std::uint32_t count);
[[nodiscard]] std::optional<std::uint32_t> decodeStartCell(wire::Bytes bytes);

/// What to write into the EEPROM of a vehicle that is to have these settings, for host and simulator.
/// `starts`: what the start counter shall stand at.
[[nodiscard]] std::array<std::uint8_t, kEepromSize> makeEepromImage(const Settings& settings, std::uint32_t starts = 0);
/// The settings in an image; nullopt when neither copy is good, or the image is shorter than 0x200 bytes.
[[nodiscard]] std::optional<Settings> settingsFromImage(wire::Bytes image);

}  // namespace tessera::firmware
