// Draws new zones and changes existing ones with mouse and keys. Every finished gesture is one step of the document.
#pragma once

#include <optional>
#include <vector>

#include "ui/canvas/draft_tool.h"
#include "ui/zone/zone_edits.h"

class QMenu;

namespace tessera::ui {

class ZoneTool : public DraftTool {
  Q_OBJECT
public:
  /// Both must outlive it. `window` is the parent of menus; it may be null.
  ZoneTool(SiteDocument& document, Selection& selection, QWidget* window);

  /// Of zones that are drawn from now on.
  void setKind(floor::ZoneKind kind) { kind_ = kind; }
  /// Of the chosen zone.
  [[nodiscard]] std::optional<std::size_t> corner() const { return corner_; }
  void setCorner(std::optional<std::size_t> corner);

  bool mousePressed(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) override;
  void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  [[nodiscard]] bool hasHandleAt(QPointF pixel, const CanvasScene& scene) const override {
    return hitAt(pixel, scene).kind == Hit::Kind::Corner;
  }
  [[nodiscard]] QCursor cursor() const override;
  [[nodiscard]] QString hint() const override;

Q_SIGNALS:
  /// A drawn zone stands in the site.
  void finished(const QString& zone);
  /// Another corner of the chosen zone is the chosen one; nullopt: none.
  void cornerChanged(std::optional<std::size_t> corner);

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

  [[nodiscard]] bool isDragging() const override { return drag_.has_value(); }
  void dropDrag() override { drag_.reset(); }
  void forgetHover() override { hover_ = {}; }
  bool dropChoice() override;
  void finishDraft() override;
  [[nodiscard]] bool wantsToEdit(const QKeyEvent& event) const override;
  bool editingKey(const QKeyEvent& event) override;
  [[nodiscard]] const floor::Zone* zone() const { return edits_.find(selection_.zone()); }
  [[nodiscard]] Hit hitAt(QPointF pixel, const CanvasScene& scene) const;
  [[nodiscard]] Snap snapAt(const ToolMouse& mouse, const CanvasScene& scene) const;
  [[nodiscard]] bool closes(QPointF pixel, const CanvasScene& scene) const;
  bool pressWhileDrawing(const ToolMouse& mouse, const CanvasScene& scene);
  void finish(const std::vector<Point>& outline);
  void beginDrag(Hit hit, const ToolMouse& mouse);
  void lead(const ToolMouse& mouse, const CanvasScene& scene);
  void endDrag(const CanvasScene& scene);
  void clickedInside(QPointF pixel, const CanvasScene& scene);
  void removeCorner(std::size_t index);
  void nudge(Offset by);
  void openMenu(const ToolMouse& mouse, const CanvasScene& scene);
  void fillDrawingMenu(QMenu& menu);
  void fillZoneMenu(QMenu& menu, const ToolMouse& mouse, const CanvasScene& scene);
  void fillKindMenu(QMenu& menu);
  void documentChanged();
  void paintShape(QPainter& painter, const View& view, const CanvasTheme& theme, const std::vector<Point>& outline,
                  floor::ZoneKind kind) const;
  void paintHandles(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme,
                    const std::vector<Point>& outline) const;
  void paintDraft(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) const;
  [[nodiscard]] QStringList dragLines(const CanvasScene& scene) const;

  ZoneEdits edits_;
  floor::ZoneKind kind_ = floor::ZoneKind::Running;
  Hit hover_;
  std::optional<std::size_t> corner_;
  std::optional<Drag> drag_;
};

}  // namespace tessera::ui
