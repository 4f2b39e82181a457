#include "app/tessera/appearance.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <initializer_list>
#include <utility>

namespace tessera::desktop {
namespace {

struct Shades {
  QColor window, base, alternate, button, text, dim, highlight, link;
};

// Fusion draws the frames of boxes to tick darker than the window, which nobody sees where that is dark already.
class SeenFrames : public QProxyStyle {
public:
  SeenFrames() : QProxyStyle{QStyleFactory::create(QStringLiteral("Fusion"))} {}
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool box = element == PE_IndicatorCheckBox;
    if (!box && element != PE_IndicatorRadioButton) return;
    const auto group = option->state.testFlag(State_Enabled) ? QPalette::Active : QPalette::Disabled;
    QColor frame = option->palette.color(group, QPalette::WindowText);
    frame.setAlpha(150);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen{frame, 1.0});
    painter->setBrush(Qt::NoBrush);
    const QRectF within = QRectF{option->rect}.adjusted(0.5, 0.5, -0.5, -0.5);
    if (box) painter->drawRoundedRect(within, 1.5, 1.5);
    if (!box) painter->drawEllipse(within);
    painter->restore();
  }
};

QPalette paletteOf(const Shades& s) {
  QPalette p;
  const std::initializer_list<std::pair<QPalette::ColorRole, QColor>> colours{
      {QPalette::Window, s.window},
      {QPalette::WindowText, s.text},
      {QPalette::Base, s.base},
      {QPalette::AlternateBase, s.alternate},
      {QPalette::Text, s.text},
      {QPalette::PlaceholderText, s.dim},
      {QPalette::Button, s.button},
      {QPalette::ButtonText, s.text},
      {QPalette::BrightText, Qt::white},
      {QPalette::ToolTipBase, s.alternate},
      {QPalette::ToolTipText, s.text},
      {QPalette::Highlight, s.highlight},
      {QPalette::HighlightedText, Qt::white},
      {QPalette::Link, s.link},
      {QPalette::LinkVisited, s.link},
      {QPalette::Light, s.button.lighter(130)},
      {QPalette::Midlight, s.button.lighter(115)},
      {QPalette::Mid, s.button.darker(130)},
      {QPalette::Dark, s.button.darker(160)},
      {QPalette::Shadow, QColor{0, 0, 0, 160}}};
  for (const auto& [role, colour] : colours) p.setColor(role, colour);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, s.dim);
  p.setColor(QPalette::Disabled, QPalette::Highlight, s.dim);
  return p;
}

}  // namespace

QPalette paletteFor(Appearance appearance) {
  static const QPalette atStart = QApplication::palette();
  switch (appearance) {
    case Appearance::Dark:
      return paletteOf({QColor{0x24, 0x27, 0x2b}, QColor{0x1b, 0x1d, 0x20}, QColor{0x2a, 0x2d, 0x32},
                        QColor{0x33, 0x37, 0x3d}, QColor{0xe6, 0xe8, 0xea}, QColor{0x8a, 0x90, 0x98},
                        QColor{0x2f, 0x6f, 0xb7}, QColor{0x7a, 0xb8, 0xff}});
    case Appearance::Light:
      return paletteOf({QColor{0xf3, 0xf4, 0xf6}, QColor{0xff, 0xff, 0xff}, QColor{0xf0, 0xf2, 0xf5},
                        QColor{0xe8, 0xea, 0xed}, QColor{0x1c, 0x1f, 0x23}, QColor{0x75, 0x7b, 0x83},
                        QColor{0x1f, 0x66, 0xb5}, QColor{0x0b, 0x57, 0xa4}});
    case Appearance::System:
      break;
  }
  return atStart;
}

void apply(Appearance appearance) {
  const QPalette palette = paletteFor(appearance);
  if (dynamic_cast<SeenFrames*>(QApplication::style()) == nullptr) QApplication::setStyle(new SeenFrames);
  QApplication::setPalette(palette);
}

QString nameOf(Appearance appearance) {
  switch (appearance) {
    case Appearance::Light:
      return QStringLiteral("light");
    case Appearance::Dark:
      return QStringLiteral("dark");
    case Appearance::System:
      break;
  }
  return QStringLiteral("system");
}

Appearance appearanceOf(const QString& name) {
  if (name == QLatin1String{"light"}) return Appearance::Light;
  if (name == QLatin1String{"dark"}) return Appearance::Dark;
  return Appearance::System;
}

}  // namespace tessera::desktop
