// A canvas with the zone tool on a site of tiles, joined as the main window joins them.
#pragma once

#include <gtest/gtest.h>

#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include "canvas_site.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/zone/zone_tool.h"

namespace tessera::ui {

inline Point placeAt(double x, double y) { return {Metres{x}, Metres{y}}; }

/// "drive" covers 2.4 x 1.8 m of the floor, "keep off" lies on it.
inline floor::Site zonedSite() {
  floor::Site site = tiledSite(5, 4);
  site.routes.clear();
  site.zones.push_back({"drive",
                        floor::ZoneKind::Running,
                        {placeAt(0.3, 0.3), placeAt(2.7, 0.3), placeAt(2.7, 2.1), placeAt(0.3, 2.1)},
                        {},
                        {}});
  site.zones.push_back({"keep off",
                        floor::ZoneKind::NoGo,
                        {placeAt(0.9, 0.9), placeAt(1.5, 0.9), placeAt(1.5, 1.5), placeAt(0.9, 1.5)},
                        {},
                        {}});
  return site;
}

class ZoneBoard : public testing::Test {
protected:
  void SetUp() override {
    document.replace(floor::SiteMap::build(zonedSite()).value(), {});
    canvas.resize(1000, 800);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    canvas.openMap(document.map());
    QObject::connect(&document, &SiteDocument::changed, &canvas, [this] { canvas.setMap(document.map()); });
    canvas.setTool(&tool);
  }

  [[nodiscard]] QPoint pixel(double x, double y) const { return canvas.view().toPixel(placeAt(x, y)).toPoint(); }
  void click(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseMove(&canvas, pixel(x, y));
    QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, pixel(x, y));
  }
  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&canvas, Qt::LeftButton, modifiers, from);
    for (int n = 1; n <= 5; ++n) moveTo(from + (to - from) * n / 5, modifiers);
    QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, to);
  }
  // QTest::mouseMove knows no modifiers and no pressed buttons.
  void moveTo(QPoint at, Qt::KeyboardModifiers modifiers, Qt::MouseButtons buttons = Qt::LeftButton) {
    QMouseEvent move{QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, buttons, modifiers};
    QApplication::sendEvent(&canvas, &move);
  }
  void key(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&canvas, static_cast<Qt::Key>(key), modifiers);
  }
  [[nodiscard]] const floor::Zone& zone(std::size_t n) const { return document.site().zones.at(n); }
  [[nodiscard]] std::size_t zones() const { return document.site().zones.size(); }
  [[nodiscard]] int steps() { return document.undoStack().count(); }
  static void expectAt(Point p, double x, double y, double within = 0.0005) {
    EXPECT_NEAR(p.x.value(), x, within);
    EXPECT_NEAR(p.y.value(), y, within);
  }

  SiteDocument document;
  Selection selection;
  FloorCanvas canvas;
  ZoneTool tool{document, selection, &canvas};
};

}  // namespace tessera::ui
