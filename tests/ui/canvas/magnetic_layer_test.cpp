// The floor's iron upon the floor: where it is coloured, what the legend and the tip say.
#include "ui/canvas/magnetic_layer.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QLocale>

#include "locate/magnetic_map.h"

namespace tessera::ui {
namespace {

constexpr double kSure = 0.02 * 0.02;  // rad²

class AMagneticLayer : public ::testing::Test {
protected:
  AMagneticLayer() {
    QLocale::setDefault(QLocale::c());
    view.resize({400, 400}, 1.0);
    view.setScale(200.0);
    view.centreOn({Metres{0.0}, Metres{0.0}});
    locate::MagneticMap map;
    EXPECT_TRUE(map.put({-3, 0}, {fromDegrees(8.0).value(), kSure, 3}));
    EXPECT_TRUE(map.put({3, 0}, {fromDegrees(-8.0).value(), kSure, 1}));
    layer.set(std::make_shared<locate::MagneticMap>(std::move(map)));
  }
  QColor at(double x, double y) {
    QImage image{400, 400, QImage::Format_RGB32};
    image.fill(Qt::white);
    QPainter painter{&image};
    layer.paint(painter, view, CanvasTheme{QPalette{Qt::white}});
    return image.pixelColor(view.toPixel({Metres{x}, Metres{y}}).toPoint());
  }

  View view;
  MagneticLayer layer;
};

TEST_F(AMagneticLayer, isOrangeWhereCompassesTurnLeftAndBlueWhereTheyTurnRight) {
  EXPECT_GT(at(-0.45, 0.0).red(), at(-0.45, 0.0).blue() + 60);
  EXPECT_GT(at(0.45, 0.0).blue(), at(0.45, 0.0).red() + 60);
  EXPECT_EQ(at(0.0, 0.0), QColor{Qt::white}) << "where nobody drove nothing is drawn";
}

TEST_F(AMagneticLayer, saysWhatIsKnownOfAPlace) {
  EXPECT_EQ(layer.textAt({Metres{-0.45}, Metres{0.0}}), "Iron turns the compass 8.0° to the left (± 1.1°, 3 visit(s))");
  EXPECT_TRUE(layer.textAt({Metres{0.45}, Metres{0.0}}).startsWith("Iron turns the compass 8.0° to the right"));
  EXPECT_EQ(layer.textAt({Metres{0.0}, Metres{0.6}}), QString{});
  EXPECT_EQ(layer.fullDegrees(), 10.0) << "the next larger scale";
}

TEST_F(AMagneticLayer, followsTheMapAndTheView) {
  view.panBy({40.0, 0.0});
  EXPECT_GT(at(-0.45, 0.0).red(), at(-0.45, 0.0).blue() + 60);
  layer.set(nullptr);
  EXPECT_EQ(at(-0.45, 0.0), QColor{Qt::white});
  EXPECT_EQ(layer.textAt({Metres{-0.45}, Metres{0.0}}), QString{});
}

}  // namespace
}  // namespace tessera::ui
