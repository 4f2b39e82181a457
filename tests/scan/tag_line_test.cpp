#include "scan/tag_line.h"

#include <gtest/gtest.h>

namespace tessera::scan {
namespace {

std::string uidOf(std::string_view line, LineForm form = LineForm::Hex) {
  const auto read = readLine(line, form);
  return read ? read->uid.text() : read.error().sentence.english();
}

TEST(TagLine, readsUidsOfFourSevenAndTenBytesWithAndWithoutSeparators) {
  EXPECT_EQ(uidOf("04A1B2C3"), "04A1B2C3");
  EXPECT_EQ(uidOf("04:a1:b2:c3:d4:e5:f6"), "04A1B2C3D4E5F6");
  EXPECT_EQ(uidOf("01-02-03-04-05-06-07-08-09-0A"), "0102030405060708090A");
  EXPECT_EQ(uidOf("  04 A1 B2 C3 \t"), "04A1B2C3");
  EXPECT_EQ(uidOf("Card UID: 04 A1 B2 C3"), "04A1B2C3");
  EXPECT_EQ(uidOf("uid=04A1B2C3"), "04A1B2C3");
}

TEST(TagLine, refusesWhatIsNoUidAndQuotesIt) {
  for (const char* line : {"04A1B2", "04A1B2C", "04A1B2C3D4", "hello", "04A1B2C3X", "0102030405060708090A0B", "UID:"}) {
    const auto read = readLine(line, LineForm::Hex);
    ASSERT_FALSE(read) << line;
    EXPECT_NE(read.error().sentence.english().find(line), std::string::npos) << read.error().sentence;
  }
  EXPECT_FALSE(readLine(std::string(kLongestLine + 1, 'A'), LineForm::Hex));
}

// The worked examples of docs/readers.md.
TEST(TagLine, readsDecimalUidsOfEitherByteOrder) {
  EXPECT_EQ(uidOf("77705923", LineForm::Decimal), "04A1B2C3");
  EXPECT_EQ(uidOf("0077705923", LineForm::Decimal), "04A1B2C3");
  EXPECT_EQ(uidOf("3283263748", LineForm::ReversedDecimal), "04A1B2C3");
  EXPECT_EQ(uidOf("1303689068602870", LineForm::Decimal), "04A1B2C3D4E5F6");
  EXPECT_EQ(uidOf("69495546249912580", LineForm::ReversedDecimal), "04A1B2C3D4E5F6");
}

TEST(TagLine, refusesDecimalsThatNoUidHas) {
  for (const char* line :
       {"4294967296", "04A1B2C3", "", "1.5", "-7", "99999999999999999", "12345678901234567890123456"})
    EXPECT_FALSE(readLine(line, LineForm::Decimal)) << line;
}

TEST(TagLine, readsThePlaceThatATagHolds) {
  const auto read = readLine(std::string_view{"04A1B2C3 @12.350,-0.6\0\0\0", 24}, LineForm::Hex);
  ASSERT_TRUE(read) << read.error().sentence;
  EXPECT_EQ(read->place, (Point{Metres{12.35}, Metres{-0.6}}));
  EXPECT_EQ(readLine("77705923@+1,2", LineForm::Decimal)->place, (Point{Metres{1}, Metres{2}}));
  for (const char* line : {"04A1B2C3@", "04A1B2C3@1", "04A1B2C3@1;2", "04A1B2C3@1,2,3", "04A1B2C3@nan,0",
                           "04A1B2C3@100001,0", "04A1B2C3@1e3,0", "04A1B2C3@1,5,2,5"})
    EXPECT_FALSE(readLine(line, LineForm::Hex)) << line;
}

}  // namespace
}  // namespace tessera::scan
