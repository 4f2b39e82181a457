// What a broken site file is told: the file, the place in it, what was expected, what stands there. And that no text,
// however hostile, does harm.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "floor/random_site.h"
#include "floor/site_json.h"

namespace tessera::floor {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string verdict(const std::string& text) {
  const auto site = parseSite(text, "my.tessera.json");
  return site ? "taken" : site.error().sentence;
}

std::string withRest(const std::string& rest) {
  return R"({"format": "tessera-site", "version": 1, "name": "n", )" + rest + "}";
}

TEST(SiteErrors, nameFilePlaceExpectationAndFinding) {
  EXPECT_EQ(verdict(withRest(R"("north_to_y_deg": 361)")),
            "my.tessera.json: /north_to_y_deg: expected a number of degrees from -360.0 to 360.0, found 361.");
  EXPECT_EQ(verdict(withRest(R"("routes": [{"name": "r", "vertices_m": [[0, 0], [1, "a"]]}])")),
            "my.tessera.json: /routes/0/vertices_m/1/1: expected a number of metres from -100000.0 to 100000.0, found "
            "\"a\".");
  EXPECT_EQ(verdict(withRest(R"("tiles": [{"serial": "A", "type": "t", "uids": ["04B15F82", "04G1"]}])")),
            "my.tessera.json: /tiles/0/uids/1: expected a tag's UID of 8, 14 or 20 hexadecimal digits or null, found "
            "\"04G1\".");
  EXPECT_EQ(verdict(withRest(R"("placements": [{"serial": "A", "x_m": 0, "y_m": 0, "quarter_turns": 1.5}])")),
            "my.tessera.json: /placements/0/quarter_turns: expected a whole number from 0 to 3, found 1.5.");
  EXPECT_EQ(verdict(R"({"format": "tessera-site", "version": 2, "name": "n"})"),
            "my.tessera.json: /version: expected a whole number from 1 to 1, found 2.");
  const auto legs = [](const std::string& speeds) {
    return verdict(withRest(R"("routes": [{"name": "r", "vertices_m": [[0, 0], [1, 0], [2, 0]], "leg_speeds_mps": )" +
                            speeds + "}]"));
  };
  EXPECT_EQ(legs("[0.1, null]"), "taken");
  EXPECT_EQ(
      legs("[0.1]"),
      "my.tessera.json: /routes/0/leg_speeds_mps: expected a speed or null for each leg, one fewer than vertices, "
      "found an array of 1.");
  EXPECT_THAT(legs("[0.1, null, null]"), HasSubstr("one fewer than vertices"));
  EXPECT_EQ(legs("[null, 0]"),
            "my.tessera.json: /routes/0/leg_speeds_mps/1: expected a number of m/s from 0.001 to 20.0, found 0.");
  EXPECT_THAT(legs("[-0.1, null]"), HasSubstr("/leg_speeds_mps/0: expected a number of m/s"));
  const auto corners = [](const std::string& cut) {
    return verdict(withRest(R"("vehicles": [{"id": 1, "name": "v", "key": "000102030405060708090a0b0c0d0e0f",
        "readers_m": [[0, 0]], "footprint_m": [[0, 0], [1, 0], [0, 1]], "corner_cut_m": )" +
                            cut + "}]"));
  };
  EXPECT_EQ(corners("0.5"), "taken");
  EXPECT_EQ(corners("0.6"),
            "my.tessera.json: /vehicles/0/corner_cut_m: expected a number of metres from 0.0 to 0.5, found 0.6.");
  EXPECT_THAT(corners("-0.1"), HasSubstr("/corner_cut_m: expected a number of metres"));
  EXPECT_THAT(corners("true"), HasSubstr("/corner_cut_m: expected a number of metres"));
  EXPECT_EQ(verdict("[]"), "my.tessera.json: the document: expected an object, found an array of 0.");
}

TEST(SiteErrors, nameMissingAndUnknownKeys) {
  EXPECT_EQ(verdict(R"({"format": "tessera-site", "version": 1})"),
            "my.tessera.json: /name: expected this key, which is missing.");
  EXPECT_THAT(
      verdict(withRest(R"("north_to_y": 20)")),
      AllOf(StartsWith("my.tessera.json: /north_to_y: there is no such key here"), HasSubstr("north_to_y_deg")));
  EXPECT_THAT(verdict(withRest(R"("a/b~c": 1)")), StartsWith("my.tessera.json: /a~1b~0c: ")) << "RFC 6901";
}

TEST(SiteErrors, nameAKeyThatStandsTwiceInOneObject) {
  EXPECT_EQ(verdict(withRest(R"("name": "m")")), "my.tessera.json: /name: this key stands twice in one object.");
  EXPECT_EQ(verdict(withRest(R"("tiles": [{"serial": "A", "type": "t", "uids": [null, "04B15F82"]},
                                          {"serial": "B", "type": "t", "uids": [], "type": "u"}])")),
            "my.tessera.json: /tiles/1/type: this key stands twice in one object.");
  EXPECT_THAT(verdict(R"({"a/b": {"c": [[1, 2], {"d": 1, "d": 1}]}})"),
              HasSubstr("/a~1b/c/1/d: this key stands twice"));
  EXPECT_EQ(verdict(withRest(R"("tiles": [{"serial": "A", "type": "t", "uids": []},
                                          {"serial": "B", "type": "t", "uids": []}])")),
            "taken")
      << "in two objects";
}

TEST(SiteErrors, nameLineAndColumnOfWhatIsNoJson) {
  EXPECT_THAT(verdict("{\n  \"format\": tessera\n}"), HasSubstr("line 2, column 14"));
  EXPECT_THAT(verdict(""), HasSubstr("line 1, column 1"));
  EXPECT_THAT(verdict("{} {}"), HasSubstr("line 1, column 4"));
  EXPECT_THAT(verdict(withRest("\"north_to_y_deg\": 1e999")), HasSubstr("too large"));
  EXPECT_THAT(verdict(withRest("\"north_to_y_deg\": NaN")), HasSubstr("expected JSON"));
  EXPECT_THAT(verdict("{\"name\": \"\xFF\"}"), HasSubstr("expected JSON"));
}

TEST(SiteErrors, ofAKeyDoNotQuoteIt) {
  const std::string error = verdict(withRest(
      R"("vehicles": [{"id": 1, "name": "v", "key": "SECRET", "readers_m": [[0, 0]], "footprint_m": [[0,0],[1,0],[0,1]]}])"));
  EXPECT_EQ(error, "my.tessera.json: /vehicles/0/key: expected a key of 32 hexadecimal digits, found something else.");
}

TEST(SiteErrors, ofATileTypeThatCannotBe) {
  const auto type = [](const std::string& rest) {
    return withRest(R"("tile_types": [{"name": "t", "width_m": 0.6, "height_m": 0.6, "pitch_m": 0.15, )" + rest + "}]");
  };
  EXPECT_EQ(verdict(type(R"("columns": 4, "rows": 4, "pattern": "full")")), "taken");
  EXPECT_THAT(verdict(type(R"("columns": 6, "rows": 4, "pattern": "full")")), HasSubstr("lies on the tile"));
  EXPECT_THAT(verdict(type(R"("columns": 4, "rows": 4, "pattern": "half")")), HasSubstr("\"one-in-two\""));
  EXPECT_THAT(verdict(type(R"("columns": 2, "rows": 1, "pattern": "custom")")),
              HasSubstr("/custom: expected the rows"));
  EXPECT_THAT(verdict(type(R"("columns": 2, "rows": 1, "pattern": "custom", "custom": ["#"])")),
              HasSubstr("/custom/0"));
  EXPECT_THAT(verdict(type(R"("columns": 2, "rows": 1, "pattern": "custom", "custom": ["#x"])")),
              HasSubstr("/custom/0"));
  EXPECT_EQ(verdict(type(R"("columns": 2, "rows": 1, "pattern": "custom", "custom": ["#."])")), "taken");
  EXPECT_THAT(verdict(type(R"("columns": 2, "rows": 2, "pattern": "full", "starts_with_gap": true)")),
              HasSubstr("/starts_with_gap"));
}

TEST(SiteErrors, neitherDepthNorLengthDoesHarm) {
  EXPECT_THAT(verdict(std::string(5'000'000, '[')), HasSubstr("deeper than 16"));
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_THAT(verdict(objects), HasSubstr("deeper than 16"));
  EXPECT_THAT(verdict(std::string((std::size_t{64} << 20) + 1, ' ')), HasSubstr("64 MiB"));
  const std::string wide = withRest("\"tiles\": [" + std::string(1'000'000, '0') + "]");
  EXPECT_NE(verdict(wide), "taken");
  EXPECT_LT(verdict(withRest("\"north_to_y_deg\": \"" + std::string(100'000, 'x') + "\"")).size(), 300U);
  EXPECT_LT(verdict(withRest("\"" + std::string(100'000, 'x') + "\": 1")).size(), 500U);
}

TEST(SiteErrors, everyCutAndEveryChangedByteIsTakenOrRefusedInWords) {
  const std::string whole = writeSite(randomSite(4));
  for (std::size_t n = 0; n < whole.size() - 2; ++n) {
    ASSERT_THAT(verdict(whole.substr(0, n)), StartsWith("my.tessera.json: ")) << n;
  }
  std::mt19937_64 random{5};
  for (int i = 0; i < 5000; ++i) {
    std::string changed = whole;
    changed[random() % changed.size()] = static_cast<char>(random());
    const auto site = parseSite(changed, "f");
    if (site) {
      const std::string again = writeSite(*site);
      ASSERT_EQ(writeSite(*parseSite(again, "f")), again);
    } else {
      ASSERT_THAT(site.error().sentence, StartsWith("f: "));
      ASSERT_EQ(site.error().sentence.english().back(), '.');
    }
  }
}

}  // namespace
}  // namespace tessera::floor
