// A tool takes over mouse and keys of the floor while it is chosen: drawing routes, measuring, laying tiles.
#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QObject>
#include <QPainter>
#include <QString>
#include <memory>
#include <optional>
#include <span>

#include "ui/canvas/floor_index.h"
#include "ui/canvas/floor_marks.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

/// What the tool may know of the floor it works on, at the moment of the call.
struct CanvasScene {
  const View& view;
  const floor::SiteMap& map;
  const FloorIndex& floor;
};

struct ToolMouse {
  Point place;    ///< in the site
  QPointF pixel;  ///< in the canvas
  Qt::MouseButton button = Qt::NoButton;
  Qt::MouseButtons buttons = Qt::NoButton;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  QPoint global;  ///< on the screen, for menus
};

class CanvasTool : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Each returns whether the tool took it; what it leaves pans, zooms and picks as without a tool.
  virtual bool mousePressed(const ToolMouse& mouse, const CanvasScene& scene) = 0;
  virtual bool mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) = 0;
  virtual bool mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) = 0;
  virtual bool mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) = 0;
  /// A modifier pressed or let go is told as well.
  virtual bool keyPressed(QKeyEvent& event, const CanvasScene& scene) = 0;
  virtual bool keyReleased(QKeyEvent& event, const CanvasScene& scene) = 0;
  /// Keys that the tool wants although they are somebody's shortcut.
  [[nodiscard]] virtual bool wantsShortcut(const QKeyEvent& event) const = 0;
  virtual void mouseLeft() {}

  virtual void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) = 0;
  /// Texts that nothing may cover, signs of faults least of all.
  virtual void paintAbove(QPainter& /*painter*/, const CanvasScene& /*scene*/, const CanvasTheme& /*theme*/) {}
  /// Marks that paint() shows: what they say is told under the mouse.
  [[nodiscard]] virtual std::span<const FloorMark> marks() const { return {}; }
  /// Something that can be grabbed lies here: a mark stands beside it.
  [[nodiscard]] virtual bool hasHandleAt(QPointF /*pixel*/, const CanvasScene& /*scene*/) const { return false; }
  /// Something is unfinished, so that no other menu shall open.
  [[nodiscard]] virtual bool isBusy() const { return false; }
  /// True: paint() shows the chosen route, perhaps as it is being changed; the canvas leaves it out.
  [[nodiscard]] virtual bool drawsChosenRoute() const { return false; }
  /// The picture beneath the floor as it is just being changed; the canvas shows it in place of the site's.
  [[nodiscard]] virtual std::optional<floor::Backdrop> backdrop() const { return std::nullopt; }
  [[nodiscard]] virtual QCursor cursor() const = 0;
  /// What to do now, for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;

  /// Drops what is unfinished. False: nothing was; the canvas then lays the tool down.
  virtual bool cancel() = 0;
  /// A step back or forward within what is unfinished. False: there is none.
  virtual bool undo() { return false; }
  virtual bool redo() { return false; }

Q_SIGNALS:
  /// Paint again; the cursor may be another.
  void changed();
  void hintChanged(const QString& hint);
};

}  // namespace tessera::ui
