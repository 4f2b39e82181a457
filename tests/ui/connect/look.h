// For tests that draw: the palette in light or dark, and pictures for those who look.
#pragma once

#include <QApplication>
#include <QDir>
#include <QPalette>
#include <QStyle>
#include <QTest>
#include <QWidget>

namespace tessera::ui::look {

inline void setDark(bool dark) {
  if (!dark) {
    QApplication::setPalette(QApplication::style()->standardPalette());
    return;
  }
  QPalette p;
  const QColor window{0x2b, 0x2d, 0x30};
  const QColor text{0xe6, 0xe6, 0xe6};
  for (const auto role : {QPalette::Window, QPalette::Button, QPalette::AlternateBase, QPalette::ToolTipBase})
    p.setColor(role, window);
  p.setColor(QPalette::Base, QColor{0x1e, 0x1f, 0x22});
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    p.setColor(role, text);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor{0x80, 0x80, 0x80});
  p.setColor(QPalette::PlaceholderText, QColor{0x9a, 0x9a, 0x9a});
  p.setColor(QPalette::Light, window.lighter(140));
  p.setColor(QPalette::Midlight, window.lighter(120));
  p.setColor(QPalette::Mid, window.darker(120));
  p.setColor(QPalette::Dark, window.darker(150));
  p.setColor(QPalette::Shadow, Qt::black);
  p.setColor(QPalette::Highlight, QColor{0x3b, 0x82, 0xf6});
  p.setColor(QPalette::HighlightedText, Qt::white);
  p.setColor(QPalette::Link, QColor{0x6c, 0xa8, 0xff});
  QApplication::setPalette(p);
}

/// Writes NAME.png into the folder that TESSERA_PICTURES names; fails when the widget cannot be drawn.
inline void take(QWidget& widget, const QString& name) {
  widget.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&widget));
  QCoreApplication::processEvents();
  const QPixmap picture = widget.grab();
  EXPECT_FALSE(picture.isNull());
  const QString folder = qEnvironmentVariable("TESSERA_PICTURES");
  if (folder.isEmpty()) return;
  EXPECT_TRUE(picture.save(QDir{folder}.filePath(name + QStringLiteral(".png"))));
}

}  // namespace tessera::ui::look
