// render_icon DRAWING.svg SIZE PICTURE.png: a square picture of a drawing, for the folders of icons.
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <cstdio>

int main(int argc, char** argv) {
  const QGuiApplication application{argc, argv};
  const QStringList words = QGuiApplication::arguments();
  const int size = words.size() == 4 ? words[2].toInt() : 0;
  if (size <= 0) {
    std::fprintf(stderr, "usage: render_icon DRAWING.svg SIZE PICTURE.png\n");
    return 2;
  }
  QSvgRenderer drawing{words[1]};
  QImage picture{size, size, QImage::Format_ARGB32_Premultiplied};
  picture.fill(Qt::transparent);
  QPainter painter{&picture};
  drawing.render(&painter);
  painter.end();
  QDir{}.mkpath(QFileInfo{words[3]}.path());
  if (drawing.isValid() && picture.save(words[3])) return 0;
  std::fprintf(stderr, "render_icon: %s cannot be drawn to %s\n", qPrintable(words[1]), qPrintable(words[3]));
  return 1;
}
