// The floor as the operator sees it: tiles, tags, zones, routes and the vehicles on it, live. Wheel and keys zoom, the
// middle button, space or an idle left button pan, a click chooses; a tool may take mouse and keys over.
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <QRegion>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/canvas/canvas_overlay.h"
#include "ui/canvas/canvas_tool.h"
#include "ui/canvas/change_marks.h"
#include "ui/canvas/fleet_layer.h"
#include "ui/canvas/floor_marks.h"
#include "ui/canvas/ground_layer.h"
#include "ui/canvas/magnetic_layer.h"
#include "ui/canvas/tile_marks.h"
#include "ui/canvas/vehicle_sprites.h"

namespace tessera::ui {

class FloorCanvas : public QWidget {
  Q_OBJECT
public:
  explicit FloorCanvas(QWidget* parent = nullptr);

  /// Another site: shows the whole of it, and nothing of the vehicles of the one before.
  void openMap(std::shared_ptr<const floor::SiteMap> map);
  /// The same site after an edit: the view stays, whatever was edited.
  void setMap(std::shared_ptr<const floor::SiteMap> map);
  /// Null: no supervision; vehicles are not drawn.
  void setSnapshot(std::shared_ptr<const supervisor::Snapshot> snapshot);
  void setSelectedVehicle(std::optional<VehicleId> vehicle);
  void setSelectedRoute(const QString& route);
  /// What is wrong on the floor, and which of it is looked at.
  void setMarks(std::vector<FloorMark> marks, std::optional<std::size_t> chosen);
  [[nodiscard]] const std::vector<FloorMark>& marked() const { return marks_; }
  /// Where its sign stands just now.
  [[nodiscard]] QPointF signOf(const FloorMark& mark) const { return signAt(view_, mark, handlesOfTool()); }
  /// What the tool has for the place of the last mark whose menu was asked for.
  void openToolMenu();
  /// What differs from another state of the site, drawn upon this one; empty: nothing is compared.
  void setChanges(ChangeMarks changes);
  [[nodiscard]] const ChangeMarks& changes() const { return changes_.marks(); }
  /// Which tiles were driven over, and what became of them; under the vehicles.
  void setTileMarks(std::vector<TileMark> marks);
  [[nodiscard]] const std::vector<TileMark>& tileMarks() const { return tileMarks_; }
  /// What is known of the iron in the floor, drawn while the layer is shown. Null: nothing.
  void setMagneticMap(std::shared_ptr<const locate::MagneticMap> map);
  [[nodiscard]] const MagneticLayer& magnetic() const { return magnetic_; }
  /// Draws a ring around this place until the next click or Esc.
  void setRing(const SiteBox& place);
  [[nodiscard]] const SiteBox& ringed() const { return ring_; }
  /// Nullptr: none. The canvas does not own it; it must be taken off before it dies.
  void setOverlay(CanvasOverlay* overlay);
  [[nodiscard]] const CanvasOverlay* overlay() const { return overlay_; }
  /// It shows something else than before.
  void overlayChanged();
  /// Nullptr: none. The canvas does not own it.
  void setTool(CanvasTool* tool);
  [[nodiscard]] CanvasTool* tool() const { return tool_; }
  /// A step within the tool's unfinished work; false when there is none, so that the document's turn has come.
  bool undoInTool();
  bool redoInTool();

  [[nodiscard]] const View& view() const { return view_; }
  [[nodiscard]] const CanvasLayers& layers() const { return layers_; }
  void setLayers(const CanvasLayers& layers);
  /// Keeps the vehicle in the middle half of the window, until somebody pans. nullopt: no more.
  void follow(std::optional<VehicleId> vehicle);
  [[nodiscard]] std::optional<VehicleId> followed() const { return followed_; }

  [[nodiscard]] QSize sizeHint() const override { return {960, 640}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 180}; }
  [[nodiscard]] bool isAnimating() const { return frames_.isActive(); }
  /// A large floor is drawn over several frames; after this call it is complete, as a picture of the window needs it.
  void finishDrawing();
  [[nodiscard]] bool isDrawn() const { return ground_.settled() && !sprites_.isPending(); }

public Q_SLOTS:
  void zoomIn();
  void zoomOut();
  void fit();
  void centreOn(tessera::Point place);
  /// Into the middle of the window, and near enough to see it, but not so near that it has no room.
  void showPlace(const tessera::ui::SiteBox& place);

Q_SIGNALS:
  /// Site coordinates under the cursor; nullopt: it left the canvas.
  void pointed(std::optional<tessera::Point> place);
  void vehiclePicked(tessera::VehicleId vehicle);
  void routePicked(const QString& route);
  /// The right button on a mark: the row that it was given, and where on the screen.
  void markMenuRequested(int row, QPoint global);
  /// A click on nothing but floor.
  void floorPicked(tessera::Point place);
  void scaleChanged(double pixelsPerMetre);
  void followChanged(std::optional<tessera::VehicleId> vehicle);
  /// By setTool(), or because Esc laid the tool down (nullptr then).
  void toolChanged(tessera::ui::CanvasTool* tool);
  /// What the tool says to do now; empty without one.
  void hintChanged(const QString& hint);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  enum class Drag { None, Waiting, Panning };

  void retranslate();
  void refreshContent();
  void redrawFloor();
  void viewMoved(bool byHand);
  void zoomBy(QPointF pixel, double factor);
  void panByHand(QPointF pixels);
  void showFrame();
  void keepFollowedInView();
  void refreshCursor();
  [[nodiscard]] Seconds sinceSnapshot() const;
  [[nodiscard]] std::vector<VehicleMark> marks() const;
  [[nodiscard]] FloorScene scene() const;
  [[nodiscard]] Ground ground() const;
  void drawOn();
  [[nodiscard]] CanvasScene toolScene() const { return {view_, *map_, *index_}; }
  [[nodiscard]] ToolMouse toolMouse(const QMouseEvent& event) const;
  bool openMarkMenu(const QMouseEvent& event);
  [[nodiscard]] HandleAt handlesOfTool() const;
  [[nodiscard]] std::optional<VehicleId> vehicleAt(QPointF pixel) const;
  [[nodiscard]] QString routeAt(QPointF pixel) const;
  void pick(QPointF pixel);
  bool pinch(QEvent* event);
  void showToolTip(QPoint pixel, QPoint global);
  void paintLive(QPainter& painter, const QRegion& region);
  void paintEmpty(QPainter& painter);

  std::shared_ptr<const floor::SiteMap> map_;
  std::shared_ptr<const FloorIndex> index_;
  std::shared_ptr<const FloorMip> mip_;
  std::shared_ptr<const BackdropPicture> backdrop_;  ///< null: the site has none
  std::optional<floor::Backdrop> ledBackdrop_;       ///< as the tool is changing it
  SiteBox content_;
  View view_;
  CanvasTheme theme_;
  CanvasLayers layers_;
  GroundLayer ground_;
  FleetLayer fleet_;
  VehicleSprites sprites_;
  MagneticLayer magnetic_;
  std::vector<TileMark> tileMarks_;
  std::vector<FloorMark> marks_;
  std::optional<std::size_t> chosenMark_;
  SiteBox ring_;         ///< what was asked for; empty: nothing
  ToolMouse menuMouse_;  ///< that asked for a mark's menu
  ChangeLayer changes_;
  QPointer<CanvasTool> tool_;
  CanvasOverlay* overlay_ = nullptr;
  std::optional<VehicleId> vehicle_;
  QString route_;
  std::optional<VehicleId> followed_;
  bool fitting_ = true;  ///< nobody has moved the view yet: it follows the window's size
  Drag drag_ = Drag::None;
  Qt::MouseButton dragButton_ = Qt::NoButton;
  QPointF pressedAt_;
  QPointF lastAt_;
  bool space_ = false;
  QTimer frames_;
  QTimer drawing_;         ///< what is not drawn yet
  bool thorough_ = false;  ///< the next painting is to leave nothing for later
  QElapsedTimer snapshotAge_;
  QElapsedTimer trailsAge_;  ///< since they were last faded
  QRegion live_;             ///< where vehicles were painted last
  QRegion overlaid_;         ///< where the overlay was
};

}  // namespace tessera::ui
