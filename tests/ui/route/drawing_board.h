// A canvas with the route tool on a site of tiles, joined as the main window joins them.
#pragma once

#include <gtest/gtest.h>

#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include "canvas_site.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/route/route_tool.h"

namespace tessera::ui {

class DrawingBoard : public testing::Test {
protected:
  void SetUp() override {
    floor::Site site = tiledSite(5, 4);
    site.routes.resize(1);  // "one": (0.5, 0.5) (2.0, 0.5) (2.0, 2.0)
    document.replace(floor::SiteMap::build(site).value(), {});
    canvas.resize(1000, 800);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    canvas.openMap(document.map());
    QObject::connect(&document, &SiteDocument::changed, &canvas, [this] { canvas.setMap(document.map()); });
    QObject::connect(&selection, &Selection::routeChanged, &canvas,
                     [this] { canvas.setSelectedRoute(selection.route()); });
    canvas.setTool(&tool);
  }

  [[nodiscard]] QPoint pixel(double x, double y) const {
    return canvas.view().toPixel({Metres{x}, Metres{y}}).toPoint();
  }
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
  [[nodiscard]] std::vector<Point> vertices(const char* route) const {
    const floor::Route* found = document.map()->route(route);
    return found != nullptr ? found->vertices : std::vector<Point>{};
  }
  [[nodiscard]] std::size_t routes() const { return document.site().routes.size(); }
  [[nodiscard]] static Point at(double x, double y) { return {Metres{x}, Metres{y}}; }
  static void expectAt(Point p, double x, double y, double within = 0.0005) {
    EXPECT_NEAR(p.x.value(), x, within);
    EXPECT_NEAR(p.y.value(), y, within);
  }

  SiteDocument document;
  Selection selection;
  FloorCanvas canvas;
  RouteTool tool{document, selection, &canvas};
};

}  // namespace tessera::ui
