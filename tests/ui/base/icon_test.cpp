// Icons take the colour of the text around them.
#include "ui/base/icon.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPalette>

namespace tessera::ui {
namespace {

// The colour that most of the drawn pixels have, by and large.
QColor inkOf(const QIcon& icon, QIcon::Mode mode = QIcon::Normal) {
  const QImage image = icon.pixmap(QSize{48, 48}, mode).toImage();
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (image.pixelColor(x, y).alpha() == 255) return image.pixelColor(x, y);
  return {};
}

class IconColour : public ::testing::Test {
protected:
  ~IconColour() override { QApplication::setPalette(before); }
  static void ink(const QColor& colour, const QColor& disabled) {
    QPalette palette = QApplication::palette();
    palette.setColor(QPalette::Active, QPalette::ButtonText, colour);
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, disabled);
    QApplication::setPalette(palette);
  }
  const QPalette before = QApplication::palette();
};

TEST_F(IconColour, followsThePaletteOfTheMoment) {
  const QIcon stop = icon("stop");
  ASSERT_FALSE(stop.isNull());
  ink(Qt::black, Qt::gray);
  EXPECT_EQ(inkOf(stop), QColor{Qt::black});
  ink(Qt::white, Qt::darkGray);
  EXPECT_EQ(inkOf(stop), QColor{Qt::white}) << "the same icon, in the dark";
  EXPECT_EQ(inkOf(stop, QIcon::Disabled), QColor{Qt::darkGray});
}

TEST(Icons, areNullWhenThereIsNoSuchFile) { EXPECT_TRUE(icon("no-such-icon").isNull()); }

TEST(Icons, areAllDrawnFromOneColour) {
  const QStringList files = QDir{":/icons"}.entryList({"*.svg"});
  ASSERT_GT(files.size(), 5);
  for (const QString& file : files) {
    const QIcon drawn = icon(QString{file}.chopped(4));
    ASSERT_FALSE(drawn.isNull()) << file.toStdString();
    EXPECT_TRUE(inkOf(drawn).isValid()) << file.toStdString() << " draws nothing";
  }
}

}  // namespace
}  // namespace tessera::ui
