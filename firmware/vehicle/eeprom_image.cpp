// The whole EEPROM at once, as host and simulator need it. The vehicle itself never holds 4096 bytes in memory.
#include <algorithm>

#include "firmware/vehicle/settings.h"

namespace tessera::firmware {

std::array<std::uint8_t, kEepromSize> makeEepromImage(const Settings& settings, std::uint32_t starts) {
  std::array<std::uint8_t, kEepromSize> image{};
  image.fill(0xFF);  // as a chip comes from the factory
  const auto record = encodeRecord({1, settings});
  std::copy(record.begin(), record.end(), image.begin() + kCopyAddress[0]);
  const auto cell = encodeStartCell(starts);
  std::copy(cell.begin(), cell.end(),
            image.begin() + kStartCells + static_cast<std::ptrdiff_t>((starts % kStartCellCount) * kEepromPage));
  return image;
}

std::optional<Settings> settingsFromImage(wire::Bytes image) {
  std::optional<Record> best;
  for (std::uint16_t address : kCopyAddress) {
    if (image.size() < address + kRecordRoom) return std::nullopt;
    const auto record = decodeRecord(image.subspan(address, kRecordRoom));
    if (!record) continue;
    if (!best || static_cast<std::int32_t>(record->sequence - best->sequence) > 0) best = record;
  }
  if (!best) return std::nullopt;
  return best->settings;
}

}  // namespace tessera::firmware
