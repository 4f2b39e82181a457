// Pictures of every view in both languages and appearances, with a look at each widget: is its text drawn whole? Run
// once at each scale; the folder is TESSERA_PICTURES, or none are kept. docs/pictures/renew.sh renews docs/pictures.
#pragma once

#include <QApplication>
#include <QDir>
#include <QSet>
#include <array>

#include "app/desktop/clipped_texts.h"
#include "app/desktop/desktop_fixture.h"

namespace tessera::desktop {

struct Dress {
  const char* name;
  const char* language;
  Appearance appearance;
};
inline constexpr std::array<Dress, 4> kDresses{{{"en-light", "en", Appearance::Light},
                                                {"en-dark", "en", Appearance::Dark},
                                                {"zh-light", "zh_CN", Appearance::Light},
                                                {"zh-dark", "zh_CN", Appearance::Dark}}};

class Pictures : public DesktopTest {
protected:
  void take(QWidget& widget, const QString& view, const Dress& dress) {
    QApplication::processEvents();
    // A text that came with the last picture of the fleet is laid out a moment later.
    QStringList clipped;
    (void)QTest::qWaitFor([&] { return (clipped = clippedTexts(widget)).isEmpty(); }, 1000);
    EXPECT_TRUE(clipped.isEmpty()) << view.toStdString() << " " << dress.name << ": "
                                   << clipped.join(QStringLiteral("; ")).toStdString();
    for (auto* canvas : widget.findChildren<ui::FloorCanvas*>()) canvas->finishDrawing();
    const QPixmap picture = widget.grab();
    EXPECT_GT(coloursIn(picture.toImage()), 8) << "an empty picture of " << view.toStdString();
    const QString folder = qEnvironmentVariable("TESSERA_PICTURES");
    if (folder.isEmpty()) return;
    ASSERT_TRUE(QDir{}.mkpath(folder));
    constexpr int kLittlePacked = 85;  // four hundred of them: a third larger, in a quarter of the time
    EXPECT_TRUE(
        picture.save(QDir{folder}.filePath(view + '-' + dress.name + QStringLiteral(".png")), "PNG", kLittlePacked));
  }
  static int coloursIn(const QImage& image) {
    QSet<QRgb> seen;
    for (int y = 0; y < image.height(); y += 7)
      for (int x = 0; x < image.width(); x += 7) seen.insert(image.pixel(x, y));
    return static_cast<int>(seen.size());
  }
  void wear(const Dress& dress) {
    window->setLanguage(QString::fromLatin1(dress.language));
    window->setAppearance(dress.appearance);
    QApplication::processEvents();
  }
};

}  // namespace tessera::desktop
