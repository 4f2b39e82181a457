// What is found when something is typed.
#include "ui/find/place_search.h"

#include <gtest/gtest.h>

#include "canvas_site.h"

namespace tessera::ui {
namespace {

using Kind = FoundPlace::Kind;

class Searching : public testing::Test {
protected:
  std::shared_ptr<const floor::SiteMap> map = tiledMap(5, 4);
};

TEST_F(Searching, findsATileByItsSerialTheSameOneFirst) {
  const auto found = findPlaces(*map, "t1");
  ASSERT_GT(found.size(), 1U);
  EXPECT_EQ(found.front().kind, Kind::Tile);
  EXPECT_EQ(found.front().name, "T1");
  EXPECT_TRUE(found.front().box.contains({Metres{0.9}, Metres{0.3}}));
  for (const FoundPlace& other : found) EXPECT_TRUE(other.name.contains("T1")) << other.name.toStdString();
}

TEST_F(Searching, findsATagByItsUidHoweverItIsWritten) {
  const floor::PlacedTag tag = map->tags()[7];
  QString text = QString::fromStdString(tag.uid.text()).toLower();
  for (auto n = text.size() - 2; n > 0; n -= 2) text.insert(n, ':');
  const auto found = findPlaces(*map, text);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().kind, Kind::Tag);
  EXPECT_LT(distance(found.front().box.centre(), tag.place), Metres{1e-9});
}

TEST_F(Searching, findsTagsByTheBeginningOfTheirUidFromFourDigitsOn) {
  const QString text = QString::fromStdString(map->tags().front().uid.text());
  EXPECT_GE(findPlaces(*map, text.left(4)).size(), 2U);
  for (const FoundPlace& place : findPlaces(*map, text.left(3))) EXPECT_NE(place.kind, Kind::Tag);
}

TEST_F(Searching, findsRoutesByAPartOfTheirName) {
  const QString name = QString::fromStdString(map->site().routes.front().name);
  const auto found = findPlaces(*map, name.mid(1).toUpper());
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().kind, Kind::Route);
}

TEST_F(Searching, takesTwoNumbersForCoordinates) {
  for (const char* text : {"1.5 2.25", "1.5; 2.25", "  1.5   2.25 "}) {
    const auto found = findPlaces(*map, text);
    ASSERT_FALSE(found.empty()) << text;
    EXPECT_EQ(found.front().kind, Kind::Coordinates);
    EXPECT_LT(distance(found.front().box.centre(), {Metres{1.5}, Metres{2.25}}), Metres{1e-9});
  }
}

TEST_F(Searching, findsNothingInWhatIsNoName) {
  for (const char* text : {"", "   ", "zzzz", "1e300 1e300", "nan nan", ":::::", "%1"}) {
    EXPECT_TRUE(findPlaces(*map, text).empty()) << text;
  }
}

TEST_F(Searching, givesNoMoreThanAskedFor) { EXPECT_EQ(findPlaces(*map, "T", 5).size(), 5U); }

}  // namespace
}  // namespace tessera::ui
