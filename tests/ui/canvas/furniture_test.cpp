#include "ui/canvas/furniture.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <cmath>
#include <set>

#include "ui/canvas/dot_stamp.h"
#include "ui/canvas/vehicle_painter.h"

namespace tessera::ui {
namespace {

TEST(NiceLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  for (double scale = 0.003; scale < 9000; scale *= 1.37) {
    const Metres step = niceLength(scale, 80.0);
    EXPECT_GE(step.value() * scale, 80.0 * (1 - 1e-6));
    EXPECT_LT(step.value() * scale, 80.0 * 2.5 + 1e-6);
    const double power = std::pow(10.0, std::floor(std::log10(step.value()) + 1e-9));
    const int digit = static_cast<int>(std::lround(step.value() / power));
    EXPECT_TRUE((std::set{1, 2, 5, 10}.contains(digit))) << step.value();
  }
}

TEST(StepText, HasTheDecimalsThatTheStepNeeds) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(stepText(Metres{0.30000000000000004}, Metres{0.1}), "0.3");
  EXPECT_EQ(stepText(Metres{2.0}, Metres{0.05}), "2.00");
  EXPECT_EQ(stepText(Metres{-1e-12}, Metres{0.5}), "0.0");
  EXPECT_EQ(stepText(Metres{120.0}, Metres{20.0}), "120");
}

TEST(LengthText, ChoosesTheUnit) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(lengthText(Metres{0.005}), "5 mm");
  EXPECT_EQ(lengthText(Metres{0.2}), "20 cm");
  EXPECT_EQ(lengthText(Metres{5}), "5 m");
  EXPECT_EQ(lengthText(Metres{2000}), "2 km");
}

TEST(DotStamp, TouchesOnlyWhatIsInItsClip) {
  QImage image{40, 40, QImage::Format_RGB32};
  image.fill(Qt::white);
  const DotStamp dot{4.0, Qt::black};
  dot.put(image, 20, 20, image.rect());
  dot.put(image, -3, -3, image.rect());
  dot.put(image, 45, 12, image.rect());
  EXPECT_EQ(image.pixelColor(20, 20), QColor{Qt::black});
  EXPECT_EQ(image.pixelColor(20, 27), QColor{Qt::white});
  image.fill(Qt::white);
  dot.put(image, 20, 20, QRect{0, 0, 20, 40});
  EXPECT_EQ(image.pixelColor(19, 20), QColor{Qt::black});
  EXPECT_EQ(image.pixelColor(20, 20), QColor{Qt::white});
}

TEST(Ellipse95, FollowsTheCovariance) {
  const Ellipse95 round = ellipseOf({0.01, 0, 0, 0, 0.01, 0, 0, 0, 0}, 100.0);
  EXPECT_NEAR(round.longAxis, std::sqrt(5.991) * 0.1 * 100.0, 1e-6);
  EXPECT_NEAR(round.longAxis, round.shortAxis, 1e-9);
  // Twice as long along the diagonal.
  const Ellipse95 slanted = ellipseOf({0.025, 0.015, 0, 0.015, 0.025, 0, 0, 0, 0}, 100.0);
  EXPECT_NEAR(slanted.degrees, 45.0, 1e-6);
  EXPECT_NEAR(slanted.longAxis / slanted.shortAxis, 2.0, 1e-6);
  const double nan = std::nan("");
  EXPECT_EQ(ellipseOf({nan, nan, nan, nan, nan, nan, nan, nan, nan}, 100.0).longAxis, 0.0);
}

}  // namespace
}  // namespace tessera::ui
