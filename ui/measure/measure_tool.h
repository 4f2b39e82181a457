// Measures on the floor: click by click along a way, with each stretch, the whole length and the area within.
#pragma once

#include <optional>
#include <vector>

#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/snapper.h"

namespace tessera::ui {

class MeasureTool : public CanvasTool {
  Q_OBJECT
public:
  using CanvasTool::CanvasTool;

  /// What was clicked so far.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// The way is complete: the next click begins another one.
  [[nodiscard]] bool isComplete() const { return complete_; }
  /// Along the way.
  [[nodiscard]] Metres length() const;
  /// Enclosed when its end is joined to its beginning; in m². A way that crosses itself has the difference of its
  /// parts.
  [[nodiscard]] double area() const;

  bool mousePressed(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool keyPressed(QKeyEvent& event, const CanvasScene& scene) override;
  bool keyReleased(QKeyEvent& event, const CanvasScene& scene) override;
  [[nodiscard]] bool wantsShortcut(const QKeyEvent& event) const override;
  void mouseLeft() override;
  void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  void paintAbove(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  [[nodiscard]] QCursor cursor() const override { return Qt::CrossCursor; }
  [[nodiscard]] QString hint() const override;
  bool cancel() override;
  bool undo() override;

private:
  void add(Point place);
  void complete();
  [[nodiscard]] Snap snapAt(const ToolMouse& mouse, const CanvasScene& scene) const;
  [[nodiscard]] std::vector<Point> shown() const;
  void touch();

  std::vector<Point> points_;
  bool complete_ = false;
  std::optional<Snap> pointer_;
  std::optional<QPointF> pressed_;  ///< where, while the button is down: a drag measures from there to where it ends
};

}  // namespace tessera::ui
