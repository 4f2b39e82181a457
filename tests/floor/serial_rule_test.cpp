#include "floor/serial_rule.h"

#include <gtest/gtest.h>

namespace tessera::floor {
namespace {

Site siteOf(std::initializer_list<const char*> serials) {
  Site site;
  for (const char* serial : serials) site.tiles.push_back({serial, "type", {}});
  return site;
}

TEST(SerialRule, fillsNumbersUpWithZeroesAndLetsLargeOnesGrow) {
  EXPECT_EQ(serialOf({}, 1), "T-0001");
  EXPECT_EQ(serialOf({"Hall/", 2, 1}, 7), "Hall/07");
  EXPECT_EQ(serialOf({"T", 2, 1}, 12345), "T12345");
  EXPECT_EQ(serialOf({"T", 0, 1}, 0), "T0");
}

TEST(SerialRule, goesOnAsTheSiteIsNumbered) {
  EXPECT_EQ(serialRuleOf(siteOf({})), SerialRule{});
  EXPECT_EQ(serialRuleOf(siteOf({"A-01", "B-007", "stairs"})), (SerialRule{"B-", 3, 8}));
  EXPECT_EQ(serialRuleOf(siteOf({"stairs"})), SerialRule{});
  EXPECT_EQ(serialRuleOf(siteOf({"99999999999999999999"})), (SerialRule{"99999999999", 9, 1'000'000'000}));
}

TEST(SerialRule, givesNoNumberTwice) {
  const Site site = siteOf({"T-0002", "T-0004", "other"});
  const std::vector<std::string> expected{"T-0001", "T-0003", "T-0005"};
  EXPECT_EQ(freeSerials(site, {}, 3), expected);
  EXPECT_EQ(freeSerials(site, {"T-", 4, 4}, 1), std::vector<std::string>{"T-0005"});
  EXPECT_TRUE(freeSerials(site, {}, 0).empty());
}

}  // namespace
}  // namespace tessera::floor
