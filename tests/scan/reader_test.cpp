#include "scan/reader.h"

#include <gtest/gtest.h>

#include <random>

namespace tessera::scan {
namespace {

std::vector<std::uint8_t> bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

std::vector<std::uint8_t> hex(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 3)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(std::string{text.substr(i, 2)}, nullptr, 16)));
  return bytes;
}

std::string told(const std::vector<Heard>& heard) {
  std::string s;
  for (const Heard& h : heard)
    s += (std::holds_alternative<TagRead>(h) ? std::get<TagRead>(h).uid.text() : std::string{"?"}) + " ";
  return s;
}

TEST(Reader, readsLinesHoweverTheyEndAndHoweverThePortCutsThem) {
  const auto stream = bytesOf(
      "04A1B2C3\r\n04A1B2C4\n\r\n 04A1B2C5\r\x02"
      "04A1B2C6\x03nonsense\r\n04A1B2C7\n");
  const std::string whole = "04A1B2C3 04A1B2C4 04A1B2C5 04A1B2C6 ? 04A1B2C7 ";
  std::mt19937 random{1};
  for (int run = 0; run < 200; ++run) {
    Reader reader;
    std::string s;
    for (std::size_t at = 0; at < stream.size();) {
      const std::size_t n = std::min<std::size_t>(1 + random() % 12, stream.size() - at);
      s += told(reader.hear(std::span{stream}.subspan(at, n)));
      at += n;
    }
    ASSERT_EQ(s, whole);
  }
}

TEST(Reader, saysOnceThatBytesWithoutEndAreNoLinesAndHearsTheNextLine) {
  Reader reader;
  std::size_t sentences = 0;
  for (int i = 0; i < 100'000; ++i) sentences += reader.hear(bytesOf("\xFF")).size();
  EXPECT_EQ(sentences, 1U);
  EXPECT_EQ(told(reader.hear(bytesOf("\n04A1B2C3\n"))), "04A1B2C3 ");
}

TEST(Reader, forgetsHalfALineWhenThePortWasLost) {
  Reader reader;
  EXPECT_TRUE(reader.hear(bytesOf("04A1")).empty());
  reader.reset();
  EXPECT_EQ(told(reader.hear(bytesOf("04A1B2C3\n"))), "04A1B2C3 ");
}

// The worked examples of docs/readers.md.
TEST(Reader, readsTheAnswersOfAModule) {
  Reader reader{ReaderForm::Module};
  EXPECT_EQ(told(reader.hear(hex("AA BB 0A 00 52 51 02 02 00 4C D9 00 80 16 "))), "4CD90080 ");
  EXPECT_EQ(told(reader.hear(hex("AA BB 0D 00 52 51 12 02 00 04 A1 B2 C3 D4 E5 F6 00 "))), "04A1B2C3D4E5F6 ");
  EXPECT_EQ(told(reader.hear(hex("AA BB 0A 00 52 51 02 02 00 04 AA 00 B2 C3 DC "))), "04AAB2C3 ") << "AA is stuffed";
}

TEST(Reader, ignoresAnswersWithoutACardDamagedOnesAndHalfOfALongerUid) {
  Reader reader{ReaderForm::Module};
  EXPECT_EQ(told(reader.hear(hex("AA BB 06 00 52 51 01 02 14 14 "))), "") << "no card";
  EXPECT_EQ(told(reader.hear(hex("AA BB 0A 00 52 51 02 02 00 4C D9 00 81 16 "))), "") << "damaged";
  EXPECT_EQ(told(reader.hear(hex("AA BB 0A 00 52 51 02 02 00 88 04 A1 B2 9C "))), "")
      << "the first half of seven bytes";
  EXPECT_EQ(told(reader.hear(hex("AA BB 0A 00 52 51 02 AA BB 0A 00 52 51 02 02 00 4C D9 00 80 16 "))), "4CD90080 ")
      << "one that was cut off, then a whole one";
}

TEST(Reader, asksAModuleInTurnsAndOthersNotAtAll) {
  Reader reader{ReaderForm::Module};
  EXPECT_EQ(reader.question(), hex("AA BB 06 00 FF FF 01 02 52 51 "));
  EXPECT_EQ(reader.question(), hex("AA BB 06 00 FF FF 02 02 04 04 "));
  EXPECT_EQ(reader.question(), hex("AA BB 06 00 FF FF 01 02 52 51 "));
  EXPECT_EQ(reader.question(), hex("AA BB 05 00 FF FF 12 02 10 "));
  EXPECT_TRUE(Reader{ReaderForm::HexLines}.question().empty());
}

}  // namespace
}  // namespace tessera::scan
