// Draws new routes and changes existing ones with mouse and keys. Every finished gesture is one step of the document.
#pragma once

#include <optional>
#include <vector>

#include "ui/canvas/draft_tool.h"
#include "ui/canvas/floor_marks.h"
#include "ui/route/route_edits.h"

class QMenu;

namespace tessera::ui {

class RouteTool : public DraftTool {
  Q_OBJECT
public:
  /// Both must outlive it. `window` is the parent of menus; it may be null.
  RouteTool(SiteDocument& document, Selection& selection, QWidget* window);

  /// Of the chosen route.
  [[nodiscard]] std::optional<std::size_t> vertex() const { return vertex_; }
  void setVertex(std::optional<std::size_t> vertex);
  /// The route as it would be if the gesture ended here; nullopt: nothing is being drawn or dragged.
  [[nodiscard]] std::optional<floor::Route> trial() const;
  /// What would be wrong with it: marked on the floor, said beside the cursor.
  void setTrialFaults(std::vector<FloorMark> faults);
  [[nodiscard]] const std::vector<FloorMark>& trialFaults() const { return trialFaults_; }

  bool mousePressed(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) override;
  bool mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) override;
  void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  [[nodiscard]] std::span<const FloorMark> marks() const override { return trialFaults_; }
  [[nodiscard]] bool hasHandleAt(QPointF pixel, const CanvasScene& scene) const override;
  [[nodiscard]] bool drawsChosenRoute() const override { return true; }
  [[nodiscard]] QCursor cursor() const override;
  [[nodiscard]] QString hint() const override;

Q_SIGNALS:
  /// A drawn route stands in the site and is chosen.
  void finished(const QString& route);
  /// Another vertex of the chosen route is the chosen one; nullopt: none.
  void vertexChanged(std::optional<std::size_t> vertex);

private:
  /// What lies under the mouse in the chosen route.
  struct Hit {
    enum class Kind { None, Vertex, Middle } kind = Kind::None;
    std::size_t index = 0;  ///< of the vertex, or of the leg's first vertex
    bool operator==(const Hit&) const = default;
  };
  struct Drag {
    floor::Route route;  ///< as it would be
    std::size_t index = 0;
    bool inserted = false;
    bool moved = false;
    QPointF pressed;
  };

  [[nodiscard]] bool isDragging() const override { return drag_.has_value(); }
  void dropDrag() override { drag_.reset(); }
  void forgetHover() override { hover_ = {}; }
  bool dropChoice() override;
  void finishDraft() override;
  [[nodiscard]] bool wantsToEdit(const QKeyEvent& event) const override;
  bool editingKey(const QKeyEvent& event) override;
  [[nodiscard]] const floor::Route* route() const { return edits_.find(selection_.route()); }
  [[nodiscard]] Hit hitAt(QPointF pixel, const CanvasScene& scene) const;
  [[nodiscard]] std::optional<std::size_t> legAt(const floor::Route& route, QPointF pixel, const View& view) const;
  [[nodiscard]] QString otherRouteAt(QPointF pixel, const CanvasScene& scene) const;
  [[nodiscard]] Snap snapAt(const ToolMouse& mouse, const CanvasScene& scene) const;
  void beginDrag(Hit hit, QPointF pixel);
  void endDrag();
  void removeVertex(std::size_t index);
  void nudge(Offset by);
  void openMenu(const ToolMouse& mouse, const CanvasScene& scene);
  void fillDrawingMenu(QMenu& menu);
  void fillRouteMenu(QMenu& menu, const ToolMouse& mouse, const CanvasScene& scene);
  void documentChanged();
  [[nodiscard]] QStringList wrong() const;
  void paintDraft(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme);
  void paintHandles(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme, const floor::Route& shown);

  RouteEdits edits_;
  Hit hover_;
  std::optional<std::size_t> vertex_;
  std::optional<Drag> drag_;
  std::vector<FloorMark> trialFaults_;
};

}  // namespace tessera::ui
