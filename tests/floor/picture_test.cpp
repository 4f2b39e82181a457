// Bytes as text and back, and what is no such text.
#include "floor/picture.h"

#include <gtest/gtest.h>

#include "floor/site_json.h"

namespace tessera::floor {
namespace {

TEST(PictureText, isTheOneOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(toBase64(""), "");
  EXPECT_EQ(toBase64("f"), "Zg==");
  EXPECT_EQ(toBase64("fo"), "Zm8=");
  EXPECT_EQ(toBase64("foo"), "Zm9v");
  EXPECT_EQ(toBase64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(toBase64("\xFF\xEF\xBE"), "/+++");
}

TEST(PictureText, comesBackWhateverTheBytes) {
  std::string bytes;
  for (int n = 0; n < 600; ++n) {
    const auto back = fromBase64(toBase64(bytes));
    ASSERT_TRUE(back) << n;
    ASSERT_EQ(*back, bytes);
    bytes += static_cast<char>(n * 37 % 256);
  }
}

TEST(PictureText, isRefusedWhereItIsNotTheOneWayToWriteTheBytes) {
  for (const char* wrong :
       {"Z", "Zg", "Zg=", "Zg===", "Zg==Zg==", "Zh==", "Zm9=", "Zm9v\n", "Zm 9v", "Zm9-", "====", "=Zm9"})
    EXPECT_FALSE(fromBase64(wrong)) << wrong;
}

TEST(Picture, isKnownByItsFirstBytes) {
  EXPECT_TRUE(isPicture("\x89PNG\r\n\x1A\n..."));
  EXPECT_TRUE(isPicture("\xFF\xD8\xFF\xE0"));
  for (const char* other : {"", "GIF89a", "PNG", "\xFF\xD8", "<svg/>", "%PDF-1.4"})
    EXPECT_FALSE(isPicture(other)) << other;
}

std::string verdictOf(const std::string& picture, const std::string& rest = {}) {
  const auto site = parseSite(R"({"format": "tessera-site", "version": 1, "name": "n", "backdrop": {"file": "f",
    "origin_m": [0, 0], "metres_per_pixel": 0.01, "picture": ")" +
                                  picture + "\"" + rest + "}}",
                              "f");
  return site ? "taken" : site.error().sentence.english();
}

TEST(Picture, thatCannotBeTakenIsToldWithItsPlace) {
  EXPECT_EQ(verdictOf("iVBORw0KGgo="), "taken");
  EXPECT_EQ(verdictOf("iVBORw0KGgo"),
            "f: /backdrop/picture: expected a picture's bytes in base64, found \"iVBORw0KGgo\".");
  EXPECT_EQ(verdictOf("R0lGODlh"),
            "f: /backdrop/picture: expected a picture in the format PNG or JPEG, found \"R0lGODlh\".");
  EXPECT_EQ(verdictOf("iVBORw0KGgo=", R"(, "opacity": 2)"),
            "f: /backdrop/opacity: expected a number of opacity from 0.0 to 1.0, found 2.");
  std::string large = "\xFF\xD8\xFF";
  large.resize(kMostPicture + 1, 'x');
  const std::string verdict = verdictOf(toBase64(large));
  EXPECT_EQ(verdict.substr(0, 74), "f: /backdrop/picture: expected a picture of at most 20 MB, found \"/9j/eHh4");
  EXPECT_LT(verdict.size(), 200U);
}

}  // namespace
}  // namespace tessera::floor
