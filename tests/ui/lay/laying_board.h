// A canvas with the lay tool on a site, joined as the main window joins them.
#pragma once

#include <gtest/gtest.h>

#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "canvas_site.h"
#include "floor/laid_tile.h"
#include "floor/new_floor.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/lay/lay_tool.h"

namespace tessera::ui {

class LayingBoard : public testing::Test {
protected:
  void SetUp() override {
    floor::Site site;
    site.tileTypes = {floor::usualTileTypes()[0]};  // 60 cm, one-in-two at 15 cm
    // What makes the canvas show 6 × 4 m from the beginning.
    const auto point = [](double x, double y) { return Point{Metres{x}, Metres{y}}; };
    site.zones.push_back({"Floor",
                          floor::ZoneKind::Running,
                          {point(0.0, 0.0), point(6.0, 0.0), point(6.0, 4.0), point(0.0, 4.0)},
                          {},
                          {}});
    open(std::move(site));
    canvas.resize(1000, 800);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    QObject::connect(&document, &SiteDocument::changed, &canvas, [this] { canvas.setMap(document.map()); });
    canvas.setMap(document.map());
    canvas.setTool(&tool);
  }

  void open(floor::Site site) {
    document.replace(floor::SiteMap::build(std::move(site)).value(), {});
    canvas.setMap(document.map());
  }
  /// So many tiles side by side from the origin, through the tool itself.
  void fill(int columns, int rows) {
    drag(0.3, 0.3, 0.6 * columns - 0.3, 0.6 * rows - 0.3, Qt::ShiftModifier);
    ASSERT_EQ(tiles(), static_cast<std::size_t>(columns * rows));
  }

  [[nodiscard]] QPoint pixel(double x, double y) const {
    return canvas.view().toPixel({Metres{x}, Metres{y}}).toPoint();
  }
  // QTest::mouseMove knows no modifiers and no pressed buttons.
  void moveTo(QPoint at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButtons buttons = Qt::NoButton) {
    QMouseEvent move{QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, buttons, modifiers};
    QApplication::sendEvent(&canvas, &move);
  }
  void hover(double x, double y) { moveTo(pixel(x, y)); }
  void click(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
    hover(x, y);
    QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, pixel(x, y));
  }
  void press(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&canvas, Qt::LeftButton, modifiers, pixel(x, y));
  }
  void pull(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
    moveTo(pixel(x, y), modifiers, Qt::LeftButton);
  }
  void release(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, pixel(x, y));
  }
  void drag(double x, double y, double toX, double toY, Qt::KeyboardModifiers modifiers = {}) {
    press(x, y, modifiers);
    for (int n = 1; n <= 4; ++n) pull(x + (toX - x) * n / 4, y + (toY - y) * n / 4, modifiers);
    release(toX, toY, modifiers);
  }
  void key(int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&canvas, static_cast<Qt::Key>(key), modifiers);
  }

  [[nodiscard]] const floor::Site& site() const { return document.site(); }
  [[nodiscard]] std::size_t tiles() const { return site().placements.size(); }
  /// The floor that the tile covers, of the first type.
  [[nodiscard]] Box boxOfTile(const std::string& serial) const {
    for (const floor::Placement& p : site().placements)
      if (p.serial == serial) return floor::boxOf(p, site().tileTypes[0]);
    ADD_FAILURE() << "no tile " << serial;
    return {};
  }
  /// Serial of the tile there; empty: none.
  [[nodiscard]] std::string tileAt(double x, double y) const {
    for (const floor::Placement& p : site().placements) {
      const Box box = floor::boxOf(p, site().tileTypes[0]);
      if (box.low.x < Metres{x} && Metres{x} < box.high.x && box.low.y < Metres{y} && Metres{y} < box.high.y)
        return p.serial;
    }
    return {};
  }
  void expectAt(const std::string& serial, double x, double y, double within = 1e-9) const {
    EXPECT_NEAR(boxOfTile(serial).low.x.value(), x, within) << serial;
    EXPECT_NEAR(boxOfTile(serial).low.y.value(), y, within) << serial;
  }
  [[nodiscard]] int turnsOf(const std::string& serial) const {
    for (const floor::Placement& p : site().placements)
      if (p.serial == serial) return p.quarterTurns;
    return -1;
  }
  [[nodiscard]] QString stepText() { return document.undoStack().undoText(); }
  [[nodiscard]] int steps() { return document.undoStack().index(); }
  void undoAll() {
    while (document.undoStack().canUndo()) document.undoStack().undo();
  }
  void redoAll() {
    while (document.undoStack().canRedo()) document.undoStack().redo();
  }

  SiteDocument document;
  FloorCanvas canvas;
  LayTool tool{document, &canvas};
};

}  // namespace tessera::ui
