// The floor with a picture of 400 × 200 pixels beneath it, its tool in hand and its panel beside it.
#pragma once

#include <gtest/gtest.h>

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QTest>

#include "canvas_site.h"
#include "ui/backdrop/backdrop_panel.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::ui {

/// Red, the left half blue.
inline std::string plan(int width = 400, int height = 200, const char* format = "PNG") {
  QImage image{width, height, QImage::Format_RGB32};
  image.fill(Qt::red);
  QPainter{&image}.fillRect(QRect{0, 0, width / 2, height}, Qt::blue);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, format);
  return buffer.data().toStdString();
}

class BackdropBoard : public testing::Test {
protected:
  void SetUp() override {
    canvas.resize(900, 600);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    QObject::connect(&document, &SiteDocument::changed, &canvas, [this] { canvas.setMap(document.map()); });
    QObject::connect(&panel, &BackdropPanel::scalingWanted, &tool, &BackdropTool::startScaling);
    document.replace(tiledMap(3, 2), {});
    canvas.openMap(document.map());
    ASSERT_TRUE(edits.put(QStringLiteral("hall.png"), plan()));
    canvas.fit();
    canvas.setTool(&tool);
    canvas.setFocus();
  }
  [[nodiscard]] const floor::Backdrop& backdrop() const { return *document.site().backdrop; }
  [[nodiscard]] int steps() { return document.undoStack().count(); }
  [[nodiscard]] QPoint pixel(double x, double y) const {
    return canvas.view().toPixel({Metres{x}, Metres{y}}).toPoint();
  }
  void moveTo(double x, double y, Qt::MouseButtons buttons = {}) {
    const QPoint at = pixel(x, y);
    QMouseEvent move{QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, buttons, {}};
    QApplication::sendEvent(&canvas, &move);
  }
  void drag(double x, double y, double toX, double toY) {
    QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(x, y));
    moveTo((x + toX) / 2, (y + toY) / 2, Qt::LeftButton);
    moveTo(toX, toY, Qt::LeftButton);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(toX, toY));
  }
  template <class T>
  T* find(const char* name) {
    return panel.findChild<T*>(QString::fromLatin1(name));
  }

  SiteDocument document;
  BackdropEdits edits{document};
  BackdropTool tool{document};
  FloorCanvas canvas;
  BackdropPanel panel{document, tool};
};

}  // namespace tessera::ui
