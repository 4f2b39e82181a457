#include "exchange/file_format.h"

#include <gtest/gtest.h>

#include <string>

namespace tessera::exchange {
namespace {

TEST(FileFormat, isToldByItsEndingInAnyLetters) {
  EXPECT_EQ(formatOfName("tags.csv"), Format::TagTable);
  EXPECT_EQ(formatOfName("TAGS.PLACES.CSV"), Format::TagTable);
  EXPECT_EQ(formatOfName("a.lif"), Format::Layout);
  EXPECT_EQ(formatOfName("a.Lif.json"), Format::Layout);
  EXPECT_EQ(formatOfName("a.tessera.json"), Format::Site);
  EXPECT_EQ(formatOfName("a.json"), Format::Site);
  EXPECT_EQ(formatOfName("a.txt"), std::nullopt);
  EXPECT_EQ(formatOfName("csv"), std::nullopt);
}

TEST(FileFormat, ofAnyOtherJsonIsLookedForInside) {
  const std::string layout = R"({"metaInformation": {"a": [1, {"b": 2}]}, "layouts": []})";
  EXPECT_EQ(formatOf("foreign.json", layout), Format::Layout);
  EXPECT_EQ(formatOf("FOREIGN.JSON", layout), Format::Layout);
  EXPECT_EQ(formatOf("no ending", layout), Format::Layout);
  EXPECT_EQ(formatOf("a.tessera.json", layout), Format::Site) << "whose reader says what is wrong";
  EXPECT_EQ(formatOf("a.csv", layout), Format::TagTable);
  for (const char* site : {R"({"version": 1, "zones": [{"layouts": 1}]})", R"(["layouts"])", R"({"name": "layouts"})",
                           R"({"layout)", "", "{", "]]]]", "[[[[["})
    EXPECT_EQ(formatOf("foreign.json", site), Format::Site) << site;
}

}  // namespace
}  // namespace tessera::exchange
