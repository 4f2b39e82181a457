// The map as a page: what a reader of PDF finds in it. And the floor plan beneath the map, in every kind of file.
#include <gtest/gtest.h>

#include <QBuffer>
#include <QCheckBox>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>

#include "canvas_site.h"
#include "pdf_reader.h"
#include "ui/print/map_picture.h"
#include "ui/print/map_picture_dialog.h"

namespace tessera::ui {
namespace {

constexpr double kMmPerPoint = 25.4 / 72.0;

class Page : public testing::Test {
protected:
  [[nodiscard]] QByteArray saved(const char* name) const {
    const QString path = folder.filePath(QString::fromLatin1(name));
    const auto done = saveSheet(MapSheet{map, wish}, path);
    if (!done) ADD_FAILURE() << done.error().sentence;
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
  }
  /// Red, 8 m × 4 m, with its lower left corner 1 m to the left of the floor and 1 m below it.
  void putAPlanBeneath() {
    QImage image{800, 400, QImage::Format_RGB32};
    image.fill(Qt::red);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    floor::Site site = map->site();
    site.backdrop = floor::Backdrop{"hall.png",
                                    std::make_shared<const std::string>(buffer.data().toStdString()),
                                    {Metres{-1.0}, Metres{-1.0}},
                                    Metres{0.01},
                                    {},
                                    0.5};
    map = floor::SiteMap::build(site).value();
  }

  QTemporaryDir folder;
  std::shared_ptr<const floor::SiteMap> map = tiledMap(5, 4);
  SheetWish wish;
};

TEST_F(Page, hasItsSizeAndDrawsTheFloorToScale) {
  wish.scale = 20.0;
  wish.tags = wish.serials = wish.zones = wish.routes = wish.legend = false;
  const PdfReader pdf{saved("map.pdf")};
  const QSizeF mm = MapSheet{map, wish}.millimetres();
  EXPECT_NEAR(pdf.page().width() * kMmPerPoint, mm.width(), 0.4);
  EXPECT_NEAR(pdf.page().height() * kMmPerPoint, mm.height(), 0.4);
  // The floor is 3 m × 2.4 m.
  EXPECT_NEAR(pdf.drawn().width() * kMmPerPoint, 150.0, 0.3);
  EXPECT_NEAR(pdf.drawn().height() * kMmPerPoint, 120.0, 0.3);
}

TEST_F(Page, saysWhatItShowsInLettersThatCanBeFoundAndCopied) {
  wish.scale = 20.0;
  wish.date = QStringLiteral("2026-11-23");
  floor::Site site = map->site();
  site.name = "Hall 7";
  site.zones = {{"z", floor::ZoneKind::NoGo, {{}, {Metres{1}, {}}, {Metres{1}, Metres{1}}}, {}, {}}};
  map = floor::SiteMap::build(site).value();
  const PdfReader pdf{saved("map.pdf")};
  const QString text = pdf.text();
  for (const char* words :
       {"Hall 7", "Scale 1 : 20", "2026-11-23", "Tag", "Place without a registered tag", "No-go zone", "50 cm", "T7"})
    EXPECT_TRUE(text.contains(QString::fromLatin1(words))) << words << " in\n" << text.toStdString();
  const QStringList fonts = pdf.headsWith("/Type /FontDescriptor");
  EXPECT_FALSE(fonts.isEmpty());
  for (const QString& font : fonts) EXPECT_TRUE(font.contains("/FontFile")) << font.toStdString();
  wish.legend = false;
  EXPECT_FALSE(PdfReader{saved("bare.pdf")}.text().contains("No-go zone"));
}

TEST_F(Page, hasThePlanOfTheBuildingBeneathAsOpaqueAsItIs) {
  wish.scale = 20.0;
  const QSizeF without = MapSheet{map, wish}.millimetres();
  putAPlanBeneath();
  EXPECT_NEAR((MapSheet{map, wish}.millimetres().width()), 8600.0 / 20 + 2 * 24.0 / kUnitsPerMm, 0.1)
      << "the whole plan, with 30 cm around it";
  const PdfReader pdf{saved("map.pdf")};
  EXPECT_EQ(pdf.headsWith("/Subtype /Image").size(), 1);
  EXPECT_FALSE(pdf.headsWith("/ca 0.5").isEmpty()) << pdf.headsWith("/ExtGState").join('\n').toStdString();
  const QByteArray svg = saved("map.svg");
  EXPECT_TRUE(svg.contains("<image ") && svg.contains("opacity=\"0.5\"")) << svg.left(2000).toStdString();
  const QImage dots = QImage::fromData(saved("map.png"));
  int pink = 0;
  for (int y = 0; y < dots.height(); y += 4)
    for (int x = 0; x < dots.width(); x += 4) {
      const QColor c = dots.pixelColor(x, y);
      pink += c.red() > 250 && std::abs(c.green() - 128) <= 3 && std::abs(c.blue() - 128) <= 3 ? 1 : 0;
    }
  const double dotsPerMetre = 150.0 / 0.0254 / wish.scale / 4;
  EXPECT_NEAR(pink / (dotsPerMetre * dotsPerMetre), 8.0 * 4.0 - 3.0 * 2.4, 0.5) << "square metres beside the tiles";
  wish.plan = false;
  EXPECT_EQ((MapSheet{map, wish}.millimetres()), without);
  EXPECT_TRUE(PdfReader{saved("bare.pdf")}.headsWith("/Subtype /Image").isEmpty());
}

TEST_F(Page, isOfferedWithThePlanWhereThatIsToBeSeen) {
  const auto plan = [](MapPictureDialog& dialog) { return dialog.findChild<QCheckBox*>("picturePlan"); };
  MapPictureDialog bare{map, true};
  EXPECT_FALSE(plan(bare)->isEnabled());
  EXPECT_FALSE(plan(bare)->isChecked());
  putAPlanBeneath();
  MapPictureDialog dialog{map, true};
  EXPECT_TRUE(dialog.wish().plan);
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  QTest::mouseClick(plan(dialog), Qt::LeftButton, {}, QPoint{8, plan(dialog)->height() / 2});
  EXPECT_FALSE(dialog.wish().plan);
  MapPictureDialog hidden{map, false};
  EXPECT_TRUE(plan(hidden)->isEnabled());
  EXPECT_FALSE(hidden.wish().plan);
}

}  // namespace
}  // namespace tessera::ui
