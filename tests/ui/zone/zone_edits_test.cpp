// The steps themselves.
#include "ui/zone/zone_edits.h"

#include <gtest/gtest.h>

#include "ui/zone/zone_shape.h"
#include "zone_board.h"

namespace tessera::ui {
namespace {

class ZoneSteps : public testing::Test {
protected:
  ZoneSteps() { document.replace(floor::SiteMap::build(zonedSite()).value(), {}); }
  SiteDocument document;
  ZoneEdits edits{document};
};

TEST_F(ZoneSteps, KeepWithAZoneWhatItsKindNeedsAndNothingElse) {
  ASSERT_TRUE(edits.setKind("keep off", floor::ZoneKind::Slow));
  EXPECT_EQ(edits.find("keep off")->speed, ZoneEdits::kUsualSpeed);
  ASSERT_TRUE(edits.setKind("keep off", floor::ZoneKind::OneWay));
  EXPECT_EQ(edits.find("keep off")->speed, std::nullopt);
  EXPECT_EQ(edits.find("keep off")->direction, Radians{});
  ASSERT_TRUE(edits.setKind("keep off", floor::ZoneKind::NoGo));
  EXPECT_EQ(document.site(), zonedSite());
}

TEST_F(ZoneSteps, HoldASpeedWithinWhatASiteFileMayHold) {
  ASSERT_TRUE(edits.setKind("keep off", floor::ZoneKind::Slow));
  ASSERT_TRUE(edits.setSpeed("keep off", MetresPerSecond{1e9}));
  EXPECT_EQ(edits.find("keep off")->speed, ZoneEdits::kMostSpeed);
  ASSERT_TRUE(edits.setSpeed("keep off", MetresPerSecond{0.0}));
  EXPECT_EQ(edits.find("keep off")->speed, ZoneEdits::kLeastSpeed);
}

TEST_F(ZoneSteps, RefuseNamesThatAreTakenEmptyOrTooLong) {
  EXPECT_FALSE(edits.rename("keep off", "drive"));
  EXPECT_FALSE(edits.rename("keep off", "  "));
  EXPECT_FALSE(edits.rename("keep off", QString{201, 'x'}));
  EXPECT_FALSE(edits.rename("nobody", "somebody"));
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_TRUE(edits.rename("keep off", " stay away "));
  EXPECT_NE(edits.find("stay away"), nullptr);
}

TEST_F(ZoneSteps, TouchTheFirstOfTwoZonesOfOneName) {
  floor::Site twins = zonedSite();
  twins.zones[1].name = "drive";
  document.replace(floor::SiteMap::build(twins).value(), {});
  ASSERT_TRUE(edits.rename("drive", "first"));
  EXPECT_EQ(document.site().zones[0].name, "first");
  EXPECT_EQ(document.site().zones[1].name, "drive");
}

TEST(ZoneShapes, CountWhatIsInsideAnOddNumberOfTimes) {
  EXPECT_NEAR(squareMetres(rectangle(placeAt(2, 3), placeAt(1, 1))), 2.0, 1e-9);
  const std::vector bowTie{placeAt(0, 0), placeAt(1, 1), placeAt(1, 0), placeAt(0, 1)};
  EXPECT_NEAR(squareMetres(bowTie), 0.5, 1e-9);
  EXPECT_EQ(squareMetres(std::vector{placeAt(0, 0), placeAt(1, 1)}), 0.0);
}

}  // namespace
}  // namespace tessera::ui
