// The map as a file: to scale, whole or not at all.
#include "ui/print/map_picture.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdlib>

#include "canvas_site.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "ui/print/map_picture_dialog.h"

namespace tessera::ui {
namespace {

class Picture : public testing::Test {
protected:
  [[nodiscard]] QString path(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
  [[nodiscard]] static QByteArray bytesOf(const QString& path) {
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
  }
  QTemporaryDir folder;
  std::shared_ptr<const floor::SiteMap> map = tiledMap(5, 4);
  SheetWish wish;
};

TEST_F(Picture, isToScaleInDots) {
  wish.scale = 20.0;
  wish.routes = wish.zones = wish.serials = wish.legend = wish.tags = false;
  const MapSheet sheet{map, wish};
  ASSERT_TRUE(saveSheet(sheet, path("map.png")));
  const QImage image{path("map.png")};
  ASSERT_FALSE(image.isNull());
  EXPECT_NEAR(image.dotsPerMeterX(), 150.0 / 0.0254, 1.0);
  // The floor is 3 m wide: 15 cm of paper. Its tiles are not white, in a row between their seams.
  const double perMm = 150.0 / 25.4;
  int first = -1;
  int last = -1;
  for (int x = 0; x < image.width(); ++x) {
    if (image.pixelColor(x, image.height() * 2 / 3) == QColor{Qt::white}) continue;
    if (first < 0) first = x;
    last = x;
  }
  EXPECT_NEAR((last - first) / perMm, 150.0, 1.0);
}

TEST_F(Picture, isToScaleInLines) {
  const MapSheet sheet{map, wish};
  ASSERT_TRUE(saveSheet(sheet, path("map.svg")));
  QSvgRenderer svg{path("map.svg")};
  ASSERT_TRUE(svg.isValid());
  EXPECT_NEAR(svg.viewBoxF().width(), sheet.size().width(), 0.01);
  ASSERT_TRUE(bytesOf(path("map.svg")).contains("T7")) << "serial numbers stay text";
}

// Kept files, so that a change of the drawing is seen by whoever makes it. Renewed by copying what the failure names.
class KeptPicture : public Picture {
protected:
  void SetUp() override {
    auto site = floor::loadSite(TESSERA_SITES "/paper.tessera.json");
    ASSERT_TRUE(site) << site.error().sentence;
    map = floor::SiteMap::build(*std::move(site)).value();
    wish.scale = 20.0;
    folder.setAutoRemove(false);
  }
  void TearDown() override {
    if (!HasFailure()) folder.remove();
  }
  [[nodiscard]] static QString kept(const char* name) { return QString::fromLatin1(TESSERA_GOLDEN "/") + name; }
};

TEST_F(KeptPicture, inLinesIsTheSameToTheByte) {
  ASSERT_TRUE(saveSheet(MapSheet{map, wish}, path("paper.svg")));
  EXPECT_EQ(bytesOf(path("paper.svg")), bytesOf(kept("paper.svg"))) << path("paper.svg").toStdString();
}

// Below the title, as letters are drawn as the machine smooths them. Processors round edges differently, by a step or
// two.
TEST_F(KeptPicture, inDotsIsTheSameToTheDot) {
  wish.serials = wish.legend = wish.routes = wish.zones = false;
  ASSERT_TRUE(saveSheet(MapSheet{map, wish}, path("paper.png")));
  const QImage made = QImage{path("paper.png")}.convertToFormat(QImage::Format_RGB32);
  const QImage before = QImage{kept("paper.png")}.convertToFormat(QImage::Format_RGB32);
  ASSERT_EQ(made.size(), before.size()) << path("paper.png").toStdString();
  int most = 0;
  for (int y = made.height() / 6; y < made.height(); ++y)
    for (int x = 0; x < made.width(); ++x) {
      const QColor a = made.pixelColor(x, y);
      const QColor b = before.pixelColor(x, y);
      most =
          std::max({most, std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
    }
  EXPECT_LE(most, 2) << path("paper.png").toStdString();
}

TEST_F(Picture, isAPageOfItsOwnSize) {
  const MapSheet sheet{map, wish};
  ASSERT_TRUE(saveSheet(sheet, path("map.pdf")));
  const QByteArray pdf = bytesOf(path("map.pdf"));
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  const auto box = pdf.indexOf("/MediaBox [0 0 ");
  ASSERT_GT(box, 0);
  const double points = pdf.mid(box + 15, 20).split(' ').front().toDouble();
  EXPECT_NEAR(points / 72.0 * 25.4, sheet.millimetres().width(), 0.5);
}

TEST_F(Picture, ofTwiceTheScaleIsAboutTwiceAsWide) {
  wish.scale = 10.0;
  const QSizeF large = MapSheet{map, wish}.millimetres();
  wish.scale = 20.0;
  const QSizeF small = MapSheet{map, wish}.millimetres();
  const double edges = 2 * 24.0 / kUnitsPerMm;
  EXPECT_NEAR(large.width() - edges, 2 * (small.width() - edges), 1e-6);
}

TEST_F(Picture, thatCannotBeMadeLeavesTheOldFile) {
  QFile old{path("map.png")};
  ASSERT_TRUE(old.open(QIODevice::WriteOnly));
  old.write("old");
  old.close();
  wish.scale = 0.5;
  const auto done = saveSheet(MapSheet{map, wish}, path("map.png"));
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().sentence.english().find("too large"), std::string::npos);
  EXPECT_EQ(bytesOf(path("map.png")), "old");
  EXPECT_FALSE(saveSheet(MapSheet{map, {}}, path("map.bmp")));
  EXPECT_FALSE(saveSheet(MapSheet{map, {}}, path("no/such/folder.png")));
}

TEST_F(Picture, doesNotTakeThePlaceOfAPipe) {
  const QByteArray pipe = QFile::encodeName(path("pipe.png"));
  ASSERT_EQ(::mkfifo(pipe.constData(), 0600), 0);
  const auto done = saveSheet(MapSheet{map, {}}, path("pipe.png"));
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().sentence.english().find("is not replaced"), std::string::npos);
  struct stat now {};
  ASSERT_EQ(::stat(pipe.constData(), &now), 0);
  EXPECT_TRUE(S_ISFIFO(now.st_mode));
}

TEST_F(Picture, ofAnEmptySiteIsASheetAsWell) {
  EXPECT_TRUE(saveSheet(MapSheet{floor::SiteMap::build({}).value(), {}}, path("empty.pdf")));
}

// Rows with something on them, from the top, as bands parted by white ones.
std::vector<std::pair<int, int>> bandsOf(const QImage& image) {
  std::vector<std::pair<int, int>> bands;
  bool on = false;
  for (int y = 0; y < image.height(); ++y) {
    bool ink = false;
    for (int x = 0; x < image.width() && !ink; ++x) ink = image.pixelColor(x, y) != QColor{Qt::white};
    if (ink && !on) bands.emplace_back(y, y);
    if (ink) bands.back().second = y;
    on = ink;
  }
  return bands;
}

TEST_F(Picture, ofANewFloorHasItsZonesNameBelowTheScale) {
  floor::Site site = floor::layNewFloor({"My floor", floor::usualTileTypes().front(), 12, 8, false}).value();
  ASSERT_FALSE(site.zones.empty());
  wish.scale = 200.0;
  const auto drawn = [&](const floor::Site& one) {
    const MapSheet sheet{floor::SiteMap::build(one).value(), wish};
    QImage image{(2 * sheet.size()).toSize(), QImage::Format_RGB32};
    image.setDotsPerMeterX(3780);
    image.setDotsPerMeterY(3780);
    QPainter painter{&image};
    painter.scale(2.0, 2.0);
    sheet.paint(painter);
    return image;
  };
  const QImage named = drawn(site);
  for (floor::Zone& zone : site.zones) zone.name.clear();
  const QImage unnamed = drawn(site);
  ASSERT_EQ(named.size(), unnamed.size());
  const int scale = bandsOf(unnamed).at(1).second;
  int first = 0;
  const auto sameRow = [&](int y) {
    for (int x = 0; x < named.width(); ++x)
      if (named.pixel(x, y) != unnamed.pixel(x, y)) return false;
    return true;
  };
  while (first < named.height() && sameRow(first)) ++first;
  ASSERT_LT(first, named.height()) << "the name is drawn";
  EXPECT_GT(first, scale);
}

TEST_F(Picture, saysWhereTilesAreTooSmallForTheirSerialNumbers) {
  MapPictureDialog dialog{map, true};
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  auto* serials = dialog.findChild<QCheckBox*>("pictureSerials");
  auto* scale = dialog.findChild<QComboBox*>("pictureScale");
  EXPECT_TRUE(serials->isEnabled());
  EXPECT_TRUE(dialog.wish().serials);
  QTest::keyClick(scale, Qt::Key_End);
  EXPECT_FALSE(serials->isEnabled());
  EXPECT_EQ(serials->text(), "Serial &numbers (too small at this scale)");
  EXPECT_FALSE(dialog.wish().serials);
  QTest::keyClick(scale, Qt::Key_Home);
  EXPECT_TRUE(dialog.wish().serials);
}

TEST_F(Picture, isShownWithItsSizeBeforeItIsSaved) {
  MapPictureDialog dialog{map, true};
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  auto* scale = dialog.findChild<QComboBox*>("pictureScale");
  EXPECT_EQ(dialog.wish().scale, 20.0) << "the largest that fits A3";
  auto* size = dialog.findChild<QLabel*>("pictureSize");
  const QString before = size->text();
  QTest::keyClick(scale, Qt::Key_Down);
  EXPECT_NE(size->text(), before);
  QTest::mouseClick(dialog.findChild<QCheckBox*>("pictureTags"), Qt::LeftButton, {}, QPoint{8, 8});
  EXPECT_FALSE(dialog.wish().tags);
}

}  // namespace
}  // namespace tessera::ui
