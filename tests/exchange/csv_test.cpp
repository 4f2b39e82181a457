#include "exchange/csv.h"

#include <gtest/gtest.h>

#include <random>

namespace tessera::exchange {
namespace {

using Rows = std::vector<CsvRow>;

TEST(Csv, readsWhatSpreadsheetsWrite) {
  const Rows expected{{1, {"a", "b"}}, {2, {"1", "x, \"y\"\nz"}}, {5, {"", "2"}}};
  EXPECT_EQ(parseCsv("a,b\n1,\"x, \"\"y\"\"\nz\"\n\n,2\n", "f").value(), expected);
  Rows crlf = expected;
  crlf[1].fields[1] = "x, \"y\"\r\nz";
  EXPECT_EQ(parseCsv("\xEF\xBB\xBF"
                     "a,b\r\n1,\"x, \"\"y\"\"\r\nz\"\r\n\r\n,2",
                     "f")
                .value(),
            crlf);
  EXPECT_TRUE(parseCsv("", "f").value().empty());
}

TEST(Csv, namesTheLineOfWhatIsWrong) {
  const auto error = [](const char* text) { return parseCsv(text, "f").error().sentence; };
  EXPECT_EQ(error("a,b\n1\n"), "f: line 2: expected 2 fields as in the first line, found 1.");
  EXPECT_EQ(error("a\n\"b\nc"), "f: line 2: expected a closing quote, found the end of the file.");
  EXPECT_EQ(error("a\nb\"c\n"), "f: line 2: expected quotes only around a whole field.");
  EXPECT_EQ(error("a\n\"x\ny\"z\n"), "f: line 3: expected a comma after the closing quote.");
}

TEST(Csv, anyFieldsComeBack) {
  std::mt19937_64 random{4};
  const std::string letters = "a,\"\r\n x\xC3\xA9";
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::string> fields(1 + random() % 4);
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      for (std::size_t n = random() % 6; n > 0; --n) fields[i] += letters[random() % letters.size()];
      line += (i > 0 ? "," : "") + csvField(fields[i]);
    }
    if (fields.size() == 1 && fields[0].empty()) continue;
    const auto back = parseCsv(line + "\n", "f");
    ASSERT_TRUE(back) << back.error().sentence;
    ASSERT_EQ(back->front().fields, fields);
  }
}

}  // namespace
}  // namespace tessera::exchange
