#include "ui/base/icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>
#include <memory>
#include <utility>

namespace tessera::ui {
namespace {

// Draws when asked, so that the palette of the moment decides; the files say "currentColor" for their one colour.
class PaletteIcon : public QIconEngine {
public:
  explicit PaletteIcon(QByteArray svg) : svg_{std::move(svg)} {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State /*state*/) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
    QByteArray svg = svg_;
    svg.replace("currentColor", QApplication::palette().color(group, role).name().toLatin1());
    QSvgRenderer renderer{svg};
    renderer.setAspectRatioMode(Qt::KeepAspectRatio);
    renderer.render(painter, rect);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap{size};
    pixmap.fill(Qt::transparent);
    QPainter painter{&pixmap};
    paint(&painter, QRect{QPoint{}, size}, mode, state);
    return pixmap;
  }

  [[nodiscard]] QIconEngine* clone() const override { return std::make_unique<PaletteIcon>(svg_).release(); }

private:
  QByteArray svg_;
};

}  // namespace

QIcon icon(const QString& name) {
  QFile file{QStringLiteral(":/icons/%1.svg").arg(name)};
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon{std::make_unique<PaletteIcon>(file.readAll()).release()};
}

}  // namespace tessera::ui
