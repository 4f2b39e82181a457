// Lays tiles with the mouse and changes laid ones: paint, fill, choose, move, turn, copy. Every finished gesture is one
// step of the document; while it lasts only what is shown changes.
#pragma once

#include <optional>

#include "ui/canvas/canvas_tool.h"
#include "ui/lay/lay_gestures.h"

class QMenu;
class QWidget;

namespace tessera::ui {

class LayTool : public CanvasTool {
  Q_OBJECT
public:
  enum class Mode { Choose, Lay };

  /// The document must outlive it. `window` is the parent of menus; it may be null.
  LayTool(SiteDocument& document, QWidget* window);

  [[nodiscard]] Mode mode() const { return mode_; }
  void setMode(Mode mode);
  /// Name of the type that is laid; empty: the site has none.
  [[nodiscard]] const std::string& brush() const { return brush_; }
  void setBrush(const std::string& type);
  [[nodiscard]] int brushTurns() const { return brushTurns_; }
  [[nodiscard]] const floor::SerialRule& rule() const { return rule_; }
  void setRule(const floor::SerialRule& rule);
  [[nodiscard]] const TileSet& chosen() const { return chosen_; }
  void choose(TileSet tiles);
  [[nodiscard]] bool hasCopy() const { return !copy_.tiles.empty(); }
  /// Copies hang at the mouse and wait for a click.
  [[nodiscard]] bool isPasting() const { return stamp_.has_value(); }

  /// Each a step of its own for the chosen tiles; a sentence where it is not possible.
  void turn();  ///< what is chosen, else what is to be laid
  void turnEach();
  void align(LayEdits::Line line);
  void duplicate();
  void removeChosen();
  void moveBy(Offset by);
  void chooseAll();
  void copy();
  void paste();
  /// Of the only chosen tile.
  void rename(const QString& serial);
  void place(Point low, int quarterTurns, int mergeKey);

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
  void chosenChanged();
  /// Mode, type, turn or rule of what is laid next.
  void settingsChanged();
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

private:
  [[nodiscard]] bool inGesture() const { return gesture_.index() != 0; }
  [[nodiscard]] std::optional<Offset> brushSize() const;
  [[nodiscard]] Point ghostAt(const ToolMouse& mouse, const CanvasScene& scene) const;
  [[nodiscard]] Point stampAt(const ToolMouse& mouse, const CanvasScene& scene) const;
  void beginLaying(const ToolMouse& mouse, const CanvasScene& scene);
  void beginChoosing(const ToolMouse& mouse, const CanvasScene& scene);
  void moveDrag(LayDrag& drag, const ToolMouse& mouse, const CanvasScene& scene);
  void moveBand(LayBand& band, const ToolMouse& mouse, const CanvasScene& scene);
  void hover(const ToolMouse& mouse, const CanvasScene& scene);
  void layBoxes(const std::vector<Box>& boxes);
  void putStamp();
  void lay(const QString& step, const std::vector<NewTile>& tiles, const std::vector<floor::TileType>& types);
  void endDrag(const LayDrag& drag);
  void openMenu(const ToolMouse& mouse, const CanvasScene& scene);
  bool command(const QKeyEvent& event);
  [[nodiscard]] std::optional<Offset> arrowOf(const QKeyEvent& event) const;
  void documentChanged();
  void takeUpSite();
  void finish(const Result<void>& result);
  void touch();
  void paintChosen(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme);
  void paintGesture(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) const;

  SiteDocument& document_;
  LayEdits edits_;
  QWidget* window_;
  Mode mode_ = Mode::Lay;
  std::string brush_;
  int brushTurns_ = 0;
  floor::SerialRule rule_;
  TileSet chosen_;
  std::optional<std::vector<Box>> chosenBoxes_;  ///< where they lie; nullopt: to be looked up again
  LayGesture gesture_;
  TileStamp copy_;
  std::optional<TileStamp> stamp_;
  ToolMouse mouse_;             ///< as last seen
  std::optional<Point> ghost_;  ///< where a click would lay a tile, or the stamp
  bool ghostFree_ = false;
  bool overTile_ = false;
  bool mouseHere_ = false;
  bool editing_ = false;  ///< the document changes by our own hand
  int moves_;             ///< merge key of moves by key in a row
};

}  // namespace tessera::ui
