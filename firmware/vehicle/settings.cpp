#include "firmware/vehicle/settings.h"

#include <algorithm>

namespace tessera::firmware {
namespace {

using wire::Parameter;

struct Range {
  std::int32_t lowest;
  std::int32_t highest;
  std::int32_t standard;
};

// In the order of the parameters' numbers, 1 first.
constexpr std::array<Range, kSettingCount> kRanges{{
    {1, 254, kUncommissionedAddress},  // Address
    {20'000, 1'000'000, 100'000},      // WheelDiameter
    {50'000, 3'000'000, 300'000},      // TrackWidth
    {4, 100'000, 200},                 // CountsPerTurn
    {10, 3'000, 500},                  // MaxSpeed
    {50, 6'000, 1'500},                // MaxTurnRate
    {0, 3'000, 300},                   // StopDistance; 0 never stops
    {-32'768, 65'535, 0},              // Declination
    {-400'000, 400'000, 0},            // CompassOffsetX
    {-400'000, 400'000, 0},            // CompassOffsetY
    {-100'000, 100'000, 10'000},       // CompassMatrixXX
    {-100'000, 100'000, 0},            // CompassMatrixXY
    {-100'000, 100'000, 0},            // CompassMatrixYX
    {-100'000, 100'000, 10'000},       // CompassMatrixYY
    {-32'768, 65'535, 0},              // CompassMounting
    {1, 8, 3},                         // ReaderCount
    {0, 31, 23},                       // RadioChannel
    {0, 5, 5},                         // RadioAirRate
    {0, 7, 7},                         // RadioBaud
    {0, 60'000, 10'500},               // BatteryLow
    {50, 5'000, 500},                  // Acceleration
    {0, 10'000, 300},                  // CompassRatio: slip of 2 % bends the heading by 0.5 degrees at 0.2 m/s
    {0, 100'000, 10'000},              // HeadingLearning; 0 does not learn
}};

constexpr std::uint8_t kMagic[2] = {'T', 'S'};
constexpr std::uint8_t kVersion = 1;
constexpr std::size_t kHead = 24;

std::size_t indexOf(Parameter p) { return static_cast<std::size_t>(p) - 1; }

}  // namespace

Settings::Settings() {
  for (std::size_t i = 0; i < kSettingCount; ++i) values_[i] = kRanges[i].standard;
}

bool Settings::has(Parameter parameter) {
  const auto number = static_cast<std::uint8_t>(parameter);
  return number >= 1 && number <= kSettingCount;
}

std::int32_t Settings::get(Parameter parameter) const { return has(parameter) ? values_[indexOf(parameter)] : 0; }

wire::Outcome Settings::set(Parameter parameter, std::int32_t value) {
  if (!has(parameter)) return wire::Outcome::Unknown;
  const Range& range = kRanges[indexOf(parameter)];
  if (value < range.lowest || value > range.highest) return wire::Outcome::OutOfRange;
  values_[indexOf(parameter)] = value;
  return wire::Outcome::Done;
}

void Settings::restoreDefaults() {
  const std::int32_t address = get(Parameter::Address);
  for (std::size_t i = 0; i < kSettingCount; ++i) values_[i] = kRanges[i].standard;
  values_[indexOf(Parameter::Address)] = address;
}

std::array<std::uint8_t, kRecordSize> encodeRecord(const Record& record) {
  std::array<std::uint8_t, kRecordSize> out{};
  wire::ByteWriter w{out};
  w.bytes(kMagic);
  w.u8(kVersion);
  w.u8(kSettingCount);
  w.u32(record.sequence);
  w.bytes(record.settings.key);
  for (std::uint8_t n = 1; n <= kSettingCount; ++n) w.i32(record.settings.get(static_cast<Parameter>(n)));
  w.u16(wire::crc16(w.written()));
  return out;
}

std::optional<Record> decodeRecord(wire::Bytes bytes) {
  wire::ByteReader r{bytes};
  if (r.u8() != kMagic[0] || r.u8() != kMagic[1] || r.u8() != kVersion) return std::nullopt;
  const std::uint8_t count = r.u8();
  const std::size_t size = kHead + 4 * std::size_t{count} + 2;
  if (bytes.size() < size) return std::nullopt;
  if (wire::ByteReader{bytes.subspan(size - 2, 2)}.u16() != wire::crc16(bytes.first(size - 2))) return std::nullopt;
  Record record;
  record.sequence = r.u32();
  const wire::Bytes key = r.bytes(record.settings.key.size());
  std::copy(key.begin(), key.end(), record.settings.key.begin());
  for (unsigned n = 1; n <= count; ++n) record.settings.set(static_cast<Parameter>(n), r.i32());
  return record;
}

std::array<std::uint8_t, kStartCellSize> encodeStartCell(std::uint32_t count) {
  std::array<std::uint8_t, kStartCellSize> out{};
  wire::ByteWriter w{out};
  w.u32(count);
  w.u32(~count);
  return out;
}

std::optional<std::uint32_t> decodeStartCell(wire::Bytes bytes) {
  wire::ByteReader r{bytes};
  const std::uint32_t count = r.u32();
  const std::uint32_t complement = r.u32();
  if (r.overrun() || complement != ~count) return std::nullopt;
  return count;
}

}  // namespace tessera::firmware
