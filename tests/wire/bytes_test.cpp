#include "wire/bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace tessera::wire {
namespace {

using ::testing::ElementsAre;

TEST(Bytes, areWrittenLittleEndian) {
  std::array<std::uint8_t, 9> out{};
  ByteWriter w{out};
  w.u8(0x01);
  w.u16(0x2345);
  w.u32(0x6789ABCD);
  w.i16(-2);
  EXPECT_THAT(w.written(), ElementsAre(0x01, 0x45, 0x23, 0xCD, 0xAB, 0x89, 0x67, 0xFE, 0xFF));
  EXPECT_FALSE(w.overrun());
  EXPECT_EQ(w.room(), 0U);
}

TEST(Bytes, comeBackWithTheirSigns) {
  const std::array<std::uint8_t, 6> in{0xFE, 0xFF, 0x00, 0x00, 0x00, 0x80};
  ByteReader r{in};
  EXPECT_EQ(r.i16(), -2);
  EXPECT_EQ(r.i32(), std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(r.remaining(), 0U);
  EXPECT_FALSE(r.overrun());
}

TEST(Bytes, writingPastTheEndIsMarkedAndHarmless) {
  std::array<std::uint8_t, 4> out{9, 9, 9, 9};
  ByteWriter w{std::span{out}.first(3)};
  w.u32(0x01020304);
  EXPECT_TRUE(w.overrun());
  EXPECT_EQ(out[3], 9);
}

TEST(Bytes, readingPastTheEndGivesZerosAndIsMarked) {
  const std::array<std::uint8_t, 3> in{1, 2, 3};
  ByteReader r{in};
  EXPECT_TRUE(r.bytes(4).empty());
  EXPECT_TRUE(r.overrun());
  ByteReader s{in};
  EXPECT_EQ(s.u32(), 0x00030201U);
  EXPECT_TRUE(s.overrun());
}

}  // namespace
}  // namespace tessera::wire
