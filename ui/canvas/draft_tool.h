// What the tools have in common that draw points one after the other and change them later: the unfinished points,
// which are taken back one by one, and the keys. Every finished gesture is one step of the document.
#pragma once

#include <optional>
#include <vector>

#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/snapper.h"

namespace tessera::ui {

[[nodiscard]] bool isDeleteKey(const QKeyEvent& event);
/// How far an arrow key moves what is chosen: 1 cm, with Shift 10 cm; nullopt: it is none.
[[nodiscard]] std::optional<Offset> nudgeOf(const QKeyEvent& event);
[[nodiscard]] double pixelsBetween(QPointF a, QPointF b);

class DraftTool : public CanvasTool {
  Q_OBJECT
public:
  /// The next clicks draw.
  void startDrawing();
  [[nodiscard]] bool isDrawing() const { return drawing_; }
  /// The unfinished points.
  [[nodiscard]] const std::vector<Point>& draft() const { return draft_; }

  bool keyPressed(QKeyEvent& event, const CanvasScene& scene) override;
  bool keyReleased(QKeyEvent& event, const CanvasScene& scene) override;
  [[nodiscard]] bool wantsShortcut(const QKeyEvent& event) const override;
  void mouseLeft() override;
  [[nodiscard]] bool isBusy() const override { return drawing_ || isDragging(); }
  bool cancel() override;
  bool undo() override;
  bool redo() override;

Q_SIGNALS:
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

protected:
  /// Document and selection must outlive it. `window` is the parent of menus; it may be null. `firstNudgeKey`: merge
  /// keys from here on are the tool's own.
  DraftTool(SiteDocument& document, Selection& selection, QWidget* window, int firstNudgeKey, std::size_t mostPoints);

  static constexpr double kMiddleFrom = 44.0;  ///< pixels of a leg that has room for a handle in its middle

  [[nodiscard]] virtual bool isDragging() const = 0;
  virtual void dropDrag() = 0;
  virtual void forgetHover() = 0;
  /// Lets go of the point that is chosen. False: none was.
  virtual bool dropChoice() = 0;
  virtual void finishDraft() = 0;
  /// Keys while nothing is drawn or dragged.
  [[nodiscard]] virtual bool wantsToEdit(const QKeyEvent& event) const = 0;
  virtual bool editingKey(const QKeyEvent& event) = 0;

  /// At the end of the draft, unless it is there already.
  void addPoint(Point place);
  /// Whether a hand that trembled between two clicks still means the draft's last point.
  [[nodiscard]] bool isAtLast(QPointF pixel, const View& view) const;
  /// What was drawn stands in the site.
  void endDrawing();
  void forgetUnfinished();
  void touch();
  void refuse(const Error& why);
  template <class T>
  bool tell(const Result<T>& result) {
    if (!result) refuse(result.error());
    return result.has_value();
  }

  /// The handle under the mouse: of a point, or in the middle of the leg that begins at a point.
  [[nodiscard]] static std::optional<std::size_t> pointAt(const View& view, const std::vector<Point>& points,
                                                          QPointF pixel);
  [[nodiscard]] static std::optional<std::size_t> middleAt(const View& view, const std::vector<Point>& points,
                                                           bool closed, QPointF pixel);

  SiteDocument& document_;
  Selection& selection_;
  QWidget* window_;
  std::optional<Snap> pointer_;  ///< where a click would go
  ToolMouse mouse_;              ///< as last seen
  bool editing_ = false;         ///< the document changes by our own hand
  int nudges_;                   ///< merge key of the nudges in a row

private:
  bool drawingKey(const QKeyEvent& event);
  void modifiersChanged(Qt::KeyboardModifiers modifiers, const CanvasScene& scene);

  std::size_t mostPoints_;
  bool drawing_ = false;
  std::vector<Point> draft_;
  std::vector<Point> takenBack_;  ///< by undo, last one first to come again
};

}  // namespace tessera::ui
