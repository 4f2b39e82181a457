// On the floor: the place that is next stands out, a double click goes on from another one.
#pragma once

#include <QTimer>

#include "ui/canvas/canvas_tool.h"
#include "ui/register/register_panel.h"

namespace tessera::ui {

class RegisterTool : public CanvasTool {
  Q_OBJECT
public:
  /// Both must outlive it.
  RegisterTool(Registrar& registrar, ScanPage& page, QObject* parent = nullptr);

  /// A registered tag is to be seen although it is not the next one; until the walk moves on. Nullopt: it lies nowhere.
  std::optional<Point> mark(const scan::PlaceName& place);

  bool mousePressed(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool keyPressed(QKeyEvent& event, const CanvasScene& scene) override;
  bool keyReleased(QKeyEvent& event, const CanvasScene& scene) override;
  [[nodiscard]] bool wantsShortcut(const QKeyEvent& event) const override;
  void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  [[nodiscard]] QCursor cursor() const override { return Qt::ArrowCursor; }
  [[nodiscard]] QString hint() const override;
  bool cancel() override;

private:
  void touch();

  Registrar& registrar_;
  ScanPage& page_;
  std::optional<Point> marked_;
  std::optional<Point> done_;  ///< registered just now
  QTimer flash_;
};

}  // namespace tessera::ui
