// Where the histogram of an experiment counts its errors, the last bin's end above all.
#include "ui/plot/error_bins.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tessera::ui {
namespace {

constexpr int kBins = 50;

TEST(ErrorBins, countEachErrorOnceAndNoneBeyondTheLast) {
  const auto shares = sharesInBins({0.0, 0.05, 0.1, 0.49, 0.5, 7.0, 0.15, 0.25}, 0.1, 5);
  ASSERT_EQ(shares.size(), 5U);
  EXPECT_DOUBLE_EQ(shares[0], 25.0);
  EXPECT_DOUBLE_EQ(shares[1], 25.0);
  EXPECT_DOUBLE_EQ(shares[2], 12.5);
  EXPECT_DOUBLE_EQ(shares[3], 0.0);
  EXPECT_DOUBLE_EQ(shares[4], 12.5);
}

// The widths are those of charts that show up to 0.1, 0.101, … cm.
TEST(ErrorBins, countAnErrorJustBelowTheEndInTheLastBinHoweverItsQuotientIsRounded) {
  int roundedUp = 0;
  for (int milli = 100; milli < 20'100; ++milli) {
    const double width = milli / 1000.0 / kBins;
    double error = width * kBins;
    EXPECT_EQ(sharesInBins({error}, width, kBins), std::vector<double>(kBins, 0.0)) << "the end itself is beyond";
    for (int step = 0; step < 4; ++step) {
      error = std::nextafter(error, 0.0);
      if (error / width >= kBins) ++roundedUp;
      const auto shares = sharesInBins({error}, width, kBins);
      ASSERT_EQ(shares.size(), static_cast<std::size_t>(kBins));
      ASSERT_EQ(shares.back(), 100.0) << "error " << error << " cm in bins of " << width << " cm";
    }
  }
  EXPECT_GT(roundedUp, 0) << "no error met what the last bin is for";
}

}  // namespace
}  // namespace tessera::ui
