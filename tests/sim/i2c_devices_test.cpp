#include "firmware/boards/host/i2c_devices.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim/blank_eeprom.h"

namespace tessera::firmware {
namespace {

constexpr ChipField kField{60.0, 45.0, 50.0};

struct Compass {
  CompassChip chip;
  std::uint64_t now = 0;

  Compass() {
    chip.powerOn(0);
    run(20'000, kField);  // the measurement after switching on
    EXPECT_EQ(axes()[0], 654);
  }
  void set(std::uint8_t index, std::uint8_t value) {
    const std::array<std::uint8_t, 2> bytes{index, value};
    EXPECT_TRUE(chip.write(bytes, now));
  }
  std::vector<std::uint8_t> get(std::uint8_t index, std::size_t count) {
    const std::array<std::uint8_t, 1> pointer{index};
    EXPECT_TRUE(chip.write(pointer, now));
    std::vector<std::uint8_t> out(count);
    EXPECT_TRUE(chip.read(out));
    return out;
  }
  /// As the chip orders them: x, z, y.
  std::array<int, 3> axes() {
    const auto raw = get(3, 6);
    const auto word = [&](std::size_t i) { return static_cast<std::int16_t>(raw[i] << 8 | raw[i + 1]); };
    return {word(0), word(2), word(4)};
  }
  void run(std::uint64_t micros, const ChipField& field) {
    for (const std::uint64_t end = now + micros; now < end; now += 1000) chip.step(now, field);
  }
};

TEST(CompassChip, identifiesItselfAndHasTheDataSheetsDefaults) {
  Compass c;
  EXPECT_EQ(c.get(10, 3), (std::vector<std::uint8_t>{'H', '4', '3'}));
  EXPECT_EQ(c.get(0, 2), (std::vector<std::uint8_t>{0x10, 0x20}));
}

TEST(CompassChip, givesTheAxesInTheOrderXZYAt1090CountsAGauss) {
  Compass c;
  EXPECT_EQ(c.axes(), (std::array<int, 3>{654, 545, 491}));  // 60, 50, 45 µT
}

TEST(CompassChip, measuresOnceInSingleModeAndThenIdles) {
  Compass c;
  c.run(100'000, {10.0, 10.0, 10.0});
  EXPECT_EQ(c.axes()[0], 654);
  EXPECT_EQ(c.get(2, 1)[0] & 3, 2);
  c.set(2, 0x01);
  c.run(3'000, {10.0, 10.0, 10.0});
  EXPECT_EQ(c.get(9, 1)[0] & 1, 0);
  c.run(5'000, {10.0, 10.0, 10.0});
  EXPECT_EQ(c.get(9, 1)[0] & 1, 1);
  EXPECT_EQ(c.axes()[0], 109);
}

TEST(CompassChip, measures75TimesASecondWhenToldSo) {
  Compass c;
  c.set(0, 0x18);
  c.set(2, 0x00);
  int fresh = 0;
  for (int ms = 0; ms < 1000; ++ms) {
    c.run(1000, kField);
    if ((c.get(9, 1)[0] & 1) != 0) {
      ++fresh;
      c.axes();
    }
  }
  EXPECT_NEAR(fresh, 75, 1);
}

TEST(CompassChip, answersOverflowWithMinus4096) {
  Compass c;
  c.set(2, 0x01);
  c.run(10'000, {190.0, -200.0, 50.0});
  EXPECT_EQ(c.axes(), (std::array<int, 3>{-4096, 545, -4096}));
}

TEST(CompassChip, usesANewGainFromTheSecondMeasurementOn) {
  Compass c;
  c.set(1, 0x00);
  c.set(2, 0x01);
  c.run(10'000, kField);
  EXPECT_EQ(c.axes()[0], 654);
  c.set(2, 0x01);
  c.run(10'000, kField);
  EXPECT_EQ(c.axes()[0], 822);
}

TEST(CompassChip, holdsAResultUntilAllSixBytesAreRead) {
  Compass c;
  c.set(0, 0x18);
  c.set(2, 0x00);
  c.run(20'000, kField);
  const auto half = c.get(3, 2);
  EXPECT_EQ(c.get(9, 1)[0] & 2, 2);
  c.run(50'000, {10.0, 10.0, 10.0});
  EXPECT_EQ(c.get(3, 2), half);
  c.get(7, 2);  // the last of the six
  c.run(50'000, {10.0, 10.0, 10.0});
  EXPECT_EQ(c.axes()[0], 109);
}

TEST(CompassChip, letsNobodyWriteItsDataOrIdentification) {
  Compass c;
  c.set(3, 0x55);
  c.set(10, 0x55);
  EXPECT_EQ(c.axes()[0], 654);
  EXPECT_EQ(c.get(10, 1)[0], 'H');
}

std::vector<std::uint8_t> readAt(EepromChip& chip, std::size_t address, std::size_t count, std::uint64_t now) {
  const std::array<std::uint8_t, 2> pointer{static_cast<std::uint8_t>(address >> 8U),
                                            static_cast<std::uint8_t>(address)};
  EXPECT_TRUE(chip.write(pointer, now));
  std::vector<std::uint8_t> out(count);
  EXPECT_TRUE(chip.read(out, now));
  return out;
}

TEST(EepromChip, rollsOverInsideItsPage) {
  EepromChip chip{blank()};
  // Four bytes at the last two places of the second page: the third and fourth come to its beginning.
  const std::vector<std::uint8_t> bytes{0x00, 0x3E, 1, 2, 3, 4};
  ASSERT_TRUE(chip.write(bytes, 0));
  const std::uint64_t later = EepromChip::kWriteCycle;
  EXPECT_EQ(readAt(chip, 0x3E, 3, later), (std::vector<std::uint8_t>{1, 2, 0xFF}));
  EXPECT_EQ(readAt(chip, 0x20, 3, later), (std::vector<std::uint8_t>{3, 4, 0xFF}));
}

TEST(EepromChip, isDeafDuringItsWriteCycle) {
  EepromChip chip{blank()};
  const std::vector<std::uint8_t> bytes{0x01, 0x00, 42};
  ASSERT_TRUE(chip.write(bytes, 1000));
  std::vector<std::uint8_t> out(1);
  EXPECT_FALSE(chip.write(bytes, 1001));
  EXPECT_FALSE(chip.read(out, 5999));
  EXPECT_EQ(readAt(chip, 0x100, 1, 6000)[0], 42);
}

TEST(EepromChip, readsOnFromItsPointerAndRoundTheEnd) {
  EepromChip::Image image = blank();
  image[4095] = 7;
  image[0] = 8;
  image[1] = 9;
  EepromChip chip{image};
  EXPECT_EQ(readAt(chip, 4095, 2, 0), (std::vector<std::uint8_t>{7, 8}));
  std::vector<std::uint8_t> next(1);
  EXPECT_TRUE(chip.read(next, 0));
  EXPECT_EQ(next[0], 9);
}

}  // namespace
}  // namespace tessera::firmware
