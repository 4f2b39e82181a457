#include "wire/frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace tessera::wire {
namespace {

using ::testing::ElementsAre;

Bytes bytesOf(std::string_view text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

TEST(Crc16, hasTheCheckValueOfTheCatalogue) {
  // CRC-16/IBM-3740 ("CCITT-FALSE") in the catalogue of parametrised CRC algorithms (reveng.sourceforge.io).
  EXPECT_EQ(crc16(bytesOf("123456789")), 0x29B1);
  EXPECT_EQ(crc16({}), 0xFFFF);
}

TEST(Frame, hasTheBytesThatItsHeaderSays) {
  const std::array<std::uint8_t, 2> payload{0xAA, 0xBB};
  std::array<std::uint8_t, kMaxFrame> out{};
  const std::size_t n = encodeFrame({7, 0, 2, 0x1234}, payload, out);
  ASSERT_EQ(n, 11U);
  EXPECT_THAT(Bytes{out}.first(9), ElementsAre(0xA5, 2, 7, 0, 2, 0x34, 0x12, 0xAA, 0xBB));
  const std::uint16_t crc = crc16(Bytes{out}.subspan(1, 8));
  EXPECT_EQ(out[9], crc & 0xFF);
  EXPECT_EQ(out[10], crc >> 8);
}

TEST(Frame, neverExceedsOnePacketOfTheRadio) {
  const std::vector<std::uint8_t> payload(200, 1);
  std::array<std::uint8_t, 300> out{};
  for (std::size_t n = 0; n <= payload.size(); ++n) {
    const std::size_t size = encodeFrame({1, 0, 2, 3}, Bytes{payload}.first(n), out);
    EXPECT_EQ(size, n <= 49 ? n + 9 : 0) << n;
    EXPECT_LE(size, 58U);
  }
}

TEST(Frame, isNotWrittenWhereItDoesNotFit) {
  const std::array<std::uint8_t, 5> payload{};
  std::array<std::uint8_t, 14> out{};
  EXPECT_EQ(encodeFrame({}, payload, std::span{out}.first(13)), 0U);
  EXPECT_EQ(encodeFrame({}, payload, out), 14U);
}

}  // namespace
}  // namespace tessera::wire
