#include "firmware/vehicle/settings.h"

#include <gtest/gtest.h>

namespace tessera::firmware::test {
namespace {

using wire::Outcome;
using wire::Parameter;

TEST(Settings, beginWithTheDefaultsThatAreDocumented) {
  const Settings s;
  EXPECT_EQ(s.get(Parameter::Address), 254);
  EXPECT_EQ(s.get(Parameter::WheelDiameter), 100'000);
  EXPECT_EQ(s.get(Parameter::TrackWidth), 300'000);
  EXPECT_EQ(s.get(Parameter::CountsPerTurn), 200);
  EXPECT_EQ(s.get(Parameter::MaxSpeed), 500);
  EXPECT_EQ(s.get(Parameter::MaxTurnRate), 1500);
  EXPECT_EQ(s.get(Parameter::Acceleration), 500);
  EXPECT_EQ(s.get(Parameter::ReaderCount), 3);
  EXPECT_EQ(s.get(Parameter::RadioChannel), 23);
  EXPECT_EQ(s.get(Parameter::RadioAirRate), 5);
  EXPECT_EQ(s.get(Parameter::RadioBaud), 7);
}

TEST(Settings, refuseValuesOutOfRangeAndUnknownParameters) {
  Settings s;
  const Settings before = s;
  EXPECT_EQ(s.set(Parameter::Address, 255), Outcome::OutOfRange);
  EXPECT_EQ(s.set(Parameter::Address, 0), Outcome::OutOfRange);
  EXPECT_EQ(s.set(Parameter::RadioBaud, -1), Outcome::OutOfRange);
  EXPECT_EQ(s.set(Parameter::StackFree, 1), Outcome::Unknown);
  EXPECT_EQ(s.set(static_cast<Parameter>(0), 1), Outcome::Unknown);
  EXPECT_EQ(s.set(static_cast<Parameter>(24), 1), Outcome::Unknown);
  EXPECT_EQ(s, before);
  EXPECT_EQ(s.set(Parameter::Address, 7), Outcome::Done);
  EXPECT_EQ(s.get(Parameter::Address), 7);
}

TEST(Settings, keepAddressAndKeyWhenDefaultsAreRestored) {
  Settings s;
  s.key[3] = 9;
  s.set(Parameter::Address, 7);
  s.set(Parameter::MaxSpeed, 100);
  s.restoreDefaults();
  EXPECT_EQ(s.get(Parameter::Address), 7);
  EXPECT_EQ(s.key[3], 9);
  EXPECT_EQ(s.get(Parameter::MaxSpeed), 500);
}

TEST(Settings, surviveTheirRecordAndNoDamageToIt) {
  Settings s;
  s.key = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  s.set(Parameter::CompassOffsetY, -61'234);
  auto bytes = encodeRecord({42, s});
  const auto record = decodeRecord(bytes);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->sequence, 42U);
  EXPECT_EQ(record->settings, s);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] ^= 0x10;
    EXPECT_FALSE(decodeRecord(bytes)) << "byte " << i;
    bytes[i] ^= 0x10;
  }
}

TEST(Settings, ofAnOlderFirmwareLeaveNewParametersAtTheirDefaults) {
  Settings s;
  s.set(Parameter::Address, 9);
  s.set(Parameter::HeadingLearning, 500);
  const auto whole = encodeRecord({1, s});
  std::vector<std::uint8_t> shorter{whole.begin(), whole.end() - 6};  // one value and the checksum less
  shorter[3] = kSettingCount - 1;
  const std::uint16_t crc = wire::crc16(shorter);
  shorter.push_back(static_cast<std::uint8_t>(crc));
  shorter.push_back(static_cast<std::uint8_t>(crc >> 8));
  const auto record = decodeRecord(shorter);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->settings.get(Parameter::Address), 9);
  EXPECT_EQ(record->settings.get(Parameter::HeadingLearning), Settings{}.get(Parameter::HeadingLearning));
}

TEST(EepromImage, holdsTheSettingsItWasMadeOf) {
  Settings s;
  s.set(Parameter::Address, 3);
  s.key[0] = 0xAB;
  const auto image = makeEepromImage(s, 77);
  EXPECT_EQ(settingsFromImage(image), s);
  const wire::Bytes cell = wire::Bytes{image}.subspan(kStartCells + 77 % kStartCellCount * kEepromPage, kStartCellSize);
  EXPECT_EQ(decodeStartCell(cell), 77U);
}

TEST(EepromImage, thatIsBlankOrShortHoldsNothing) {
  std::array<std::uint8_t, kEepromSize> blank;
  blank.fill(0xFF);
  EXPECT_FALSE(settingsFromImage(blank));
  EXPECT_FALSE(settingsFromImage(wire::Bytes{blank}.first(100)));
  EXPECT_FALSE(settingsFromImage({}));
}

}  // namespace
}  // namespace tessera::firmware::test
