// Moves the picture beneath the floor with mouse and arrow keys, and takes the two points by which it gets its scale.
// Every finished gesture is one step of the document.
#pragma once

#include <optional>
#include <vector>

#include "ui/backdrop/backdrop_edits.h"
#include "ui/canvas/backdrop_picture.h"
#include "ui/canvas/canvas_tool.h"

namespace tessera::ui {

class BackdropTool : public CanvasTool {
  Q_OBJECT
public:
  explicit BackdropTool(SiteDocument& document);

  /// The next two clicks are places whose distance is known.
  void startScaling();
  [[nodiscard]] bool isScaling() const { return scaling_; }
  /// Those that were clicked, two at most.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// Between the two, as the picture lies now.
  [[nodiscard]] std::optional<Metres> between() const;
  /// What is between them is truly so long. The picture grows or shrinks about the first.
  Result<void> finishScaling(Metres truly);

  bool mousePressed(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool keyPressed(QKeyEvent& event, const CanvasScene& scene) override;
  bool keyReleased(QKeyEvent& event, const CanvasScene& scene) override;
  [[nodiscard]] bool wantsShortcut(const QKeyEvent& event) const override;
  void mouseLeft() override;
  void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  [[nodiscard]] std::optional<floor::Backdrop> backdrop() const override;
  [[nodiscard]] QCursor cursor() const override;
  [[nodiscard]] QString hint() const override;
  bool cancel() override;
  bool undo() override;

Q_SIGNALS:
  /// The second point is clicked: only the true distance is missing.
  void distanceWanted();
  /// Why something was not done.
  void refused(const tessera::Error& why);

private:
  struct Drag {
    Point begin;  ///< where the mouse was pressed
    Offset by;
  };

  [[nodiscard]] std::array<Point, 4> corners() const;
  [[nodiscard]] bool isOnPicture(QPointF pixel, const View& view) const;
  void documentChanged();
  void stopScaling();
  void touch();

  BackdropEdits edits_;
  std::shared_ptr<const BackdropPicture> picture_;
  std::optional<floor::Backdrop> seen_;  ///< the document's, when points and drag were begun
  bool scaling_ = false;
  std::vector<Point> points_;
  std::optional<Point> pointer_;
  std::optional<Drag> drag_;
  bool over_ = false;  ///< the mouse is on the picture
  int nudges_;         ///< merge key of the nudges in a row
};

}  // namespace tessera::ui
