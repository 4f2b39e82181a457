// Draws new routes and changes existing ones with mouse and keys. Every finished gesture is one step of the document;
// what is unfinished lives here and can be taken back click by click.
#pragma once

#include <optional>
#include <vector>

#include "ui/base/selection.h"
#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/floor_marks.h"
#include "ui/canvas/snapper.h"
#include "ui/route/route_edits.h"

class QMenu;

namespace tessera::ui {

class RouteTool : public CanvasTool {
  Q_OBJECT
public:
  /// Both must outlive it. `window` is the parent of menus; it may be null.
  RouteTool(SiteDocument& document, Selection& selection, QWidget* window);

  /// The next clicks draw a new route.
  void startDrawing();
  [[nodiscard]] bool isDrawing() const { return drawing_; }
  /// Vertices of the unfinished route.
  [[nodiscard]] const std::vector<Point>& draft() const { return draft_; }
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
  bool keyPressed(QKeyEvent& event, const CanvasScene& scene) override;
  bool keyReleased(QKeyEvent& event, const CanvasScene& scene) override;
  [[nodiscard]] bool wantsShortcut(const QKeyEvent& event) const override;
  void mouseLeft() override;
  void paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) override;
  [[nodiscard]] bool drawsChosenRoute() const override { return true; }
  [[nodiscard]] QCursor cursor() const override;
  [[nodiscard]] QString hint() const override;
  bool cancel() override;
  bool undo() override;
  bool redo() override;

Q_SIGNALS:
  /// A drawn route stands in the site and is chosen.
  void finished(const QString& route);
  /// Another vertex of the chosen route is the chosen one; nullopt: none.
  void vertexChanged(std::optional<std::size_t> vertex);
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

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

  [[nodiscard]] const floor::Route* route() const { return edits_.find(selection_.route()); }
  [[nodiscard]] Hit hitAt(QPointF pixel, const CanvasScene& scene) const;
  [[nodiscard]] std::optional<std::size_t> legAt(const floor::Route& route, QPointF pixel, const View& view) const;
  [[nodiscard]] QString otherRouteAt(QPointF pixel, const CanvasScene& scene) const;
  [[nodiscard]] Snap snapAt(const ToolMouse& mouse, const CanvasScene& scene) const;
  void addVertex(Point place);
  void finish();
  void beginDrag(Hit hit, QPointF pixel);
  void endDrag();
  void removeVertex(std::size_t index);
  void nudge(Offset by);
  bool drawingKey(QKeyEvent& event);
  bool editingKey(QKeyEvent& event);
  void modifiersChanged(Qt::KeyboardModifiers modifiers, const CanvasScene& scene);
  void openMenu(const ToolMouse& mouse, const CanvasScene& scene);
  void fillDrawingMenu(QMenu& menu);
  void fillRouteMenu(QMenu& menu, const ToolMouse& mouse, const CanvasScene& scene);
  void documentChanged();
  void forgetUnfinished();
  void tell(const Result<void>& result);
  void touch();
  [[nodiscard]] QStringList wrong() const;
  void paintDraft(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme);
  void paintHandles(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme, const floor::Route& shown);

  SiteDocument& document_;
  Selection& selection_;
  RouteEdits edits_;
  QWidget* window_;
  bool drawing_ = false;
  std::vector<Point> draft_;
  std::vector<Point> takenBack_;  ///< by undo, last one first to come again
  std::optional<Snap> pointer_;   ///< where a click would go
  ToolMouse mouse_;               ///< as last seen
  Hit hover_;
  std::optional<std::size_t> vertex_;
  std::optional<Drag> drag_;
  std::vector<FloorMark> trialFaults_;
  bool editing_ = false;  ///< the document changes by our own hand
  int nudges_;            ///< merge key of the nudges in a row
};

}  // namespace tessera::ui
