#include "ui/canvas/floor_canvas.h"

#include <QEvent>
#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr double kFitMargin = 60.0;
constexpr double kZoomStep = 1.5;
constexpr int kFrameMs = 16;
constexpr qint64 kFadeEveryMs = 1000;

SiteBox contentOf(const floor::Site& site, const FloorIndex& index, const BackdropPicture* picture) {
  SiteBox box = index.box();
  if (site.backdrop && picture != nullptr && !picture->fault()) {
    for (const Point& p : cornersOf(*site.backdrop, picture->size())) box.add(p);
  }
  for (const floor::Zone& zone : site.zones) {
    for (const Point& p : zone.outline) box.add(p);
  }
  for (const floor::Route& route : site.routes) {
    for (const Point& p : route.vertices) box.add(p);
  }
  for (const floor::VehicleSetup& vehicle : site.vehicles) {
    if (vehicle.start) box.add(vehicle.start->position);
  }
  if (box.empty()) {
    box.add(Point{});
    box.add(Point{Metres{10.0}, Metres{6.0}});
  }
  return box;
}

}  // namespace

FloorCanvas::FloorCanvas(QWidget* parent)
    : QWidget{parent},
      map_{floor::SiteMap::build({}).value()},
      index_{std::make_shared<FloorIndex>(map_->site())},
      mip_{std::make_shared<FloorMip>(*index_)},
      theme_{palette()} {
  setObjectName("floorCanvas");
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAutoFillBackground(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  grabGesture(Qt::PinchGesture);
  frames_.setTimerType(Qt::PreciseTimer);
  frames_.setInterval(kFrameMs);
  connect(&frames_, &QTimer::timeout, this, &FloorCanvas::showFrame);
  drawing_.setSingleShot(true);
  connect(&drawing_, &QTimer::timeout, this, &FloorCanvas::drawOn);
  refreshContent();
  retranslate();
}

void FloorCanvas::retranslate() {
  setAccessibleName(tr("Floor map"));
  setAccessibleDescription(tr("Tiles, tags, zones, routes and vehicles of the site."));
}

void FloorCanvas::openMap(std::shared_ptr<const floor::SiteMap> map) {
  if (!map) return;
  setMap(std::move(map));
  fleet_.clear();
  follow(std::nullopt);
  ground_.clear();
  fit();
  redrawFloor();
}

void FloorCanvas::setMap(std::shared_ptr<const floor::SiteMap> map) {
  if (!map || map == map_) return;
  const bool sameTiles = sameFloor(map->site(), map_->site());
  map_ = std::move(map);
  if (!sameTiles) {
    index_ = std::make_shared<FloorIndex>(map_->site());
    mip_ = std::make_shared<FloorMip>(*index_);
  }
  refreshContent();
  sprites_.clear();  // footprints may be others
  redrawFloor();
}

void FloorCanvas::refreshContent() {
  const auto& backdrop = map_->site().backdrop;
  backdrop_ = backdrop ? BackdropPicture::of(backdrop->picture) : nullptr;
  content_ = contentOf(map_->site(), *index_, backdrop_.get());
  view_.setContent(content_);
}

void FloorCanvas::redrawFloor() {
  ground_.invalidate();
  update();
}

void FloorCanvas::setSnapshot(std::shared_ptr<const supervisor::Snapshot> snapshot) {
  const bool otherRun = fleet_.snapshot() && (!snapshot || snapshot->time < fleet_.snapshot()->time);
  fleet_.setSnapshot(std::move(snapshot));
  if (otherRun) {
    ground_.fade();
    drawing_.start();
  }
  snapshotAge_.start();
  if (!isVisible()) return;
  if (!frames_.isActive()) {
    showFrame();
    if (fleet_.advance(Seconds{})) frames_.start();
  }
}

Seconds FloorCanvas::sinceSnapshot() const {
  return Seconds{snapshotAge_.isValid() ? static_cast<double>(snapshotAge_.nsecsElapsed()) * 1e-9 : 0.0};
}

void FloorCanvas::showFrame() {
  const bool goesOn = fleet_.advance(sinceSnapshot());
  if (!goesOn) frames_.stop();
  keepFollowedInView();
  QRegion now;
  for (const VehicleMark& mark : marks()) {
    const QRect extent = extentOf(mark, view_, font(), layers_).toAlignedRect();
    if (extent.intersects(rect())) now += extent;
  }
  for (const FleetLayer::Flash& flash : fleet_.flashes()) {
    const QPoint at = view_.toPixel(flash.place).toPoint();
    if (rect().contains(at)) now += QRect{at - QPoint{18, 18}, QSize{36, 36}};
  }
  const QRegion changed = live_ + now;
  live_ = now;
  update(changed);
  if (layers_.trails && (!trailsAge_.isValid() || trailsAge_.elapsed() > kFadeEveryMs)) {
    trailsAge_.start();
    ground_.fade();
    drawing_.start();
  }
}

void FloorCanvas::setSelectedVehicle(std::optional<VehicleId> vehicle) {
  if (vehicle == vehicle_) return;
  vehicle_ = vehicle;
  update();
}

void FloorCanvas::setSelectedRoute(const QString& route) {
  if (route == route_) return;
  route_ = route;
  redrawFloor();
}

void FloorCanvas::setTool(CanvasTool* tool) {
  if (tool == tool_) return;
  if (tool_) {
    disconnect(tool_, nullptr, this, nullptr);
    while (tool_->cancel()) {
    }
  }
  tool_ = tool;
  ledBackdrop_.reset();
  if (tool_) {
    connect(tool_, &CanvasTool::changed, this, [this] {
      refreshCursor();
      if (auto led = tool_->backdrop(); led != ledBackdrop_) {
        ledBackdrop_ = std::move(led);
        redrawFloor();
      }
      update();
    });
    connect(tool_, &CanvasTool::hintChanged, this, &FloorCanvas::hintChanged);
  }
  refreshCursor();
  redrawFloor();
  Q_EMIT toolChanged(tool_);
  Q_EMIT hintChanged(tool_ ? tool_->hint() : QString{});
}

void FloorCanvas::setOverlay(CanvasOverlay* overlay) {
  if (overlay == overlay_) return;
  overlay_ = overlay;
  overlayChanged();
}

void FloorCanvas::overlayChanged() {
  const QRegion now = overlay_ != nullptr ? overlay_->extent(view_, font()) & rect() : QRegion{};
  update(overlaid_ + now);
  overlaid_ = now;
}

bool FloorCanvas::undoInTool() { return tool_ && tool_->undo(); }
bool FloorCanvas::redoInTool() { return tool_ && tool_->redo(); }

void FloorCanvas::setLayers(const CanvasLayers& layers) {
  if (layers == layers_) return;
  layers_ = layers;
  redrawFloor();
}

void FloorCanvas::follow(std::optional<VehicleId> vehicle) {
  if (vehicle == followed_) return;
  followed_ = vehicle;
  if (const auto* v = fleet_.snapshot() && vehicle ? fleet_.snapshot()->find(*vehicle) : nullptr; v && v->located) {
    view_.centreOn(v->pose.position);
    viewMoved(false);
  }
  Q_EMIT followChanged(followed_);
}

void FloorCanvas::keepFollowedInView() {
  if (!followed_ || !fleet_.snapshot()) return;
  const supervisor::VehicleView* v = fleet_.snapshot()->find(*followed_);
  if (v == nullptr || !v->located) return;
  const QPointF at = view_.toPixel(poseAfter(*v, sinceSnapshot()).position);
  const QRectF middle{width() * 0.25, height() * 0.25, width() * 0.5, height() * 0.5};
  const QPointF inside{std::clamp(at.x(), middle.left(), middle.right()),
                       std::clamp(at.y(), middle.top(), middle.bottom())};
  if (std::abs(at.x() - inside.x()) + std::abs(at.y() - inside.y()) < 1.0) return;
  view_.panBy(inside - at);
  viewMoved(false);
}

void FloorCanvas::zoomIn() { zoomBy(QPointF{width() / 2.0, height() / 2.0}, kZoomStep); }
void FloorCanvas::zoomOut() { zoomBy(QPointF{width() / 2.0, height() / 2.0}, 1.0 / kZoomStep); }

void FloorCanvas::fit() {
  follow(std::nullopt);
  view_.fit(content_, kFitMargin);
  viewMoved(false);
  fitting_ = true;
}

void FloorCanvas::centreOn(Point place) {
  view_.centreOn(place);
  viewMoved(true);
}

void FloorCanvas::zoomBy(QPointF pixel, double factor) {
  // What is followed stays where it is in the window.
  if (const auto* v = followed_ && fleet_.snapshot() ? fleet_.snapshot()->find(*followed_) : nullptr; v && v->located)
    pixel = view_.toPixel(v->pose.position);
  view_.zoomAbout(pixel, factor);
  viewMoved(true);
}

void FloorCanvas::panByHand(QPointF pixels) {
  follow(std::nullopt);
  view_.panBy(pixels);
  viewMoved(true);
}

void FloorCanvas::viewMoved(bool byHand) {
  if (byHand) fitting_ = false;
  update();
  Q_EMIT scaleChanged(view_.scale());
}

void FloorCanvas::resizeEvent(QResizeEvent* /*event*/) {
  view_.resize(size(), devicePixelRatioF());
  if (fitting_) fit();
}

void FloorCanvas::showEvent(QShowEvent* /*event*/) {
  if (fleet_.advance(sinceSnapshot())) frames_.start();
}

void FloorCanvas::hideEvent(QHideEvent* /*event*/) { frames_.stop(); }

void FloorCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    theme_ = CanvasTheme{palette()};
    sprites_.clear();
    redrawFloor();
  } else if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslate();
    update();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
