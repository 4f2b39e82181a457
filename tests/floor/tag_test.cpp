#include "floor/tag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

namespace tessera::floor {
namespace {

using ::testing::HasSubstr;

std::string sentenceFor(std::string_view text) {
  const auto uid = TagUid::parse(text);
  return uid ? "" : uid.error().sentence;
}

TEST(TagUid, isReadInTheFormsThatPeopleAndReadersWrite) {
  const auto plain = TagUid::parse("04B15F823A2F48");
  ASSERT_TRUE(plain);
  for (const char* same :
       {"04b15f823a2f48", "04:B1:5F:82:3A:2F:48", "04-b1-5f-82-3a-2f-48", " 04 B1 5F 82 3A 2F 48 "}) {
    EXPECT_EQ(TagUid::parse(same), plain) << same;
  }
  EXPECT_EQ(plain->text(), "04B15F823A2F48");
  EXPECT_EQ(plain->bytes().size(), 7U);
}

TEST(TagUid, hasFourSevenOrTenBytes) {
  for (std::size_t n = 0; n <= 12; ++n) {
    const std::string text(2 * n, 'A');
    EXPECT_EQ(TagUid::parse(text).has_value(), n == 4 || n == 7 || n == 10) << n;
    const std::vector<std::uint8_t> bytes(n, 0xAA);
    EXPECT_EQ(TagUid::fromBytes(bytes).has_value(), n == 4 || n == 7 || n == 10) << n;
  }
}

TEST(TagUid, refusesWhatIsNoUidWithTheText) {
  EXPECT_THAT(sentenceFor("04G15F82"), AllOf(HasSubstr("\"04G15F82\""), HasSubstr("hexadecimal")));
  EXPECT_THAT(sentenceFor("04B15F8"), HasSubstr("7 hexadecimal digits instead of 8, 14 or 20"));
  EXPECT_THAT(sentenceFor("0:4B15F82"), HasSubstr("hexadecimal")) << "a separator inside a byte is a slip";
  EXPECT_THAT(sentenceFor(""), HasSubstr("0 hexadecimal digits"));
  EXPECT_THAT(sentenceFor(std::string(100'000, '0')), HasSubstr("..."));
  EXPECT_LT(sentenceFor(std::string(100'000, '0')).size(), 200U);
}

TEST(TagUid, ofOtherLengthIsAnotherTag) {
  const auto four = TagUid::parse("04000000");
  const auto seven = TagUid::parse("04000000000000");
  EXPECT_NE(*four, *seven);
  EXPECT_NE(std::hash<TagUid>{}(*four), std::hash<TagUid>{}(*seven));
  EXPECT_TRUE(TagUid{}.empty());
  EXPECT_EQ(TagUid{}.text(), "");
}

TEST(TagUid, hashSpreadsRunningNumbers) {
  std::set<std::size_t> low;
  for (unsigned i = 0; i < 4096; ++i) {
    const std::array<std::uint8_t, 7> bytes{
        4, 0, 0, 0, 0, static_cast<std::uint8_t>(i >> 8), static_cast<std::uint8_t>(i)};
    low.insert(TagUid::fromBytes(bytes)->hash(0) & 0xFFFU);
  }
  // 4096 values into 4096 places at random fill 63 % of them.
  EXPECT_GT(low.size(), 2400U);
}

TEST(TagUid, anotherSaltGivesAnotherOrder) {
  const auto uid = TagUid::parse("04B15F823A2F48");
  EXPECT_NE(uid->hash(0), uid->hash(1));
}

}  // namespace
}  // namespace tessera::floor
