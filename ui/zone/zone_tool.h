// Draws new zones and changes existing ones with mouse and keys. Every finished gesture is one step of the document;
// what is unfinished lives here and can be taken back click by click.
#pragma once

#include <optional>
#include <vector>

#include "ui/base/selection.h"
#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/snapper.h"
#include "ui/zone/zone_edits.h"

class QMenu;

namespace tessera::ui {

class ZoneTool : public CanvasTool {
  Q_OBJECT
public:
  /// Both must outlive it. `window` is the parent of menus; it may be null.
  ZoneTool(SiteDocument& document, Selection& selection, QWidget* window);

  /// The next clicks draw a zone's corners, or the next drag a rectangle.
  void startDrawing();
  [[nodiscard]] bool isDrawing() const { return drawing_; }
  /// Of zones that are drawn from now on.
  void setKind(floor::ZoneKind kind) { kind_ = kind; }
  /// Corners of the unfinished zone.
  [[nodiscard]] const std::vector<Point>& draft() const { return draft_; }
  /// Of the chosen zone.
  [[nodiscard]] std::optional<std::size_t> corner() const { return corner_; }
  void setCorner(std::optional<std::size_t> corner);

  bool mousePressed(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool keyPressed(QKeyEvent& event, const CanvasScene& scene) override;
  bool keyReleased(QKeyEvent& event, const CanvasScene& scene) override;
  [[nodiscard]] bool wantsShortcut(const QKeyEvent& event) const override;
  void mouseLeft() override;
  void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  [[nodiscard]] QCursor cursor() const override;
  [[nodiscard]] QString hint() const override;
  bool cancel() override;
  bool undo() override;
  bool redo() override;

Q_SIGNALS:
  /// A drawn zone stands in the site.
  void finished(const QString& zone);
  /// Another corner of the chosen zone is the chosen one; nullopt: none.
  void cornerChanged(std::optional<std::size_t> corner);
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

private:
  /// What lies under the mouse in the chosen zone.
  struct Hit {
    enum class Kind { None, Corner, Middle, Inside } kind = Kind::None;
    std::size_t index = 0;  ///< of the corner, or of the edge's first corner
    bool operator==(const Hit&) const = default;
  };
  struct Drag {
    enum class Kind { Corner, NewCorner, Whole, Rectangle } kind = Kind::Corner;
    std::vector<Point> before;   ///< the chosen zone's outline
    std::vector<Point> outline;  ///< as it would be
    std::size_t index = 0;       ///< the corner that is led; of a whole zone the one nearest to the mouse
    Point begin;                 ///< where the mouse was pressed; of a rectangle its first corner
    QPointF pressed;
    bool moved = false;
  };

  [[nodiscard]] const floor::Zone* zone() const { return edits_.find(selection_.zone()); }
  [[nodiscard]] Hit hitAt(QPointF pixel, const CanvasScene& scene) const;
  [[nodiscard]] Snap snapAt(const ToolMouse& mouse, const CanvasScene& scene) const;
  [[nodiscard]] bool closes(QPointF pixel, const CanvasScene& scene) const;
  bool pressWhileDrawing(const ToolMouse& mouse, const CanvasScene& scene);
  void addCorner(Point place);
  void finish(const std::vector<Point>& outline);
  void beginDrag(Hit hit, const ToolMouse& mouse);
  void lead(const ToolMouse& mouse, const CanvasScene& scene);
  void endDrag(const CanvasScene& scene);
  void clickedInside(QPointF pixel, const CanvasScene& scene);
  void removeCorner(std::size_t index);
  void nudge(Offset by);
  bool drawingKey(const QKeyEvent& event);
  bool editingKey(const QKeyEvent& event);
  void modifiersChanged(Qt::KeyboardModifiers modifiers, const CanvasScene& scene);
  void openMenu(const ToolMouse& mouse, const CanvasScene& scene);
  void fillDrawingMenu(QMenu& menu);
  void fillZoneMenu(QMenu& menu, const ToolMouse& mouse, const CanvasScene& scene);
  void fillKindMenu(QMenu& menu);
  void documentChanged();
  void forgetUnfinished();
  void refuse(const Error& why);
  template <class T>
  bool tell(const Result<T>& result) {
    if (!result) refuse(result.error());
    return result.has_value();
  }
  void touch();
  void paintShape(QPainter& painter, const View& view, const CanvasTheme& theme, const std::vector<Point>& outline,
                  floor::ZoneKind kind) const;
  void paintHandles(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme,
                    const std::vector<Point>& outline) const;
  void paintDraft(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) const;
  [[nodiscard]] QStringList dragLines(const CanvasScene& scene) const;

  SiteDocument& document_;
  Selection& selection_;
  ZoneEdits edits_;
  QWidget* window_;
  floor::ZoneKind kind_ = floor::ZoneKind::Running;
  bool drawing_ = false;
  std::vector<Point> draft_;
  std::vector<Point> takenBack_;  ///< by undo, last one first to come again
  std::optional<Snap> pointer_;   ///< where a click would go
  ToolMouse mouse_;               ///< as last seen
  Hit hover_;
  std::optional<std::size_t> corner_;
  std::optional<Drag> drag_;
  bool editing_ = false;  ///< the document changes by our own hand
  int nudges_;            ///< merge key of the nudges in a row
};

}  // namespace tessera::ui
