// What the canvas paints: the kept picture of the floor, the vehicles on it, the tool's own, and what helps to read it.
#include <QFontMetricsF>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/base/vehicle_colour.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/canvas/furniture.h"

namespace tessera::ui {
namespace {

constexpr std::chrono::milliseconds kSlice{3};  // of drawing between two looks at mouse, keys and vehicles

}  // namespace

FloorScene FloorCanvas::scene() const {
  FloorScene scene{map_, index_, mip_, layers_, route_, !(tool_ && tool_->drawsChosenRoute()), font()};
  if (const auto& place = ledBackdrop_ ? ledBackdrop_ : map_->site().backdrop; place && backdrop_)
    scene.backdrop = SceneBackdrop{*place, backdrop_};
  return scene;
}

std::vector<VehicleMark> FloorCanvas::marks() const {
  std::vector<VehicleMark> marks;
  if (fleet_.snapshot() == nullptr) return marks;
  const Seconds since = sinceSnapshot();
  for (const supervisor::VehicleView& v : fleet_.snapshot()->vehicles) {
    if (!v.located) continue;
    marks.push_back({&v, map_->vehicle(v.id), poseAfter(v, since), vehicleColour(map_->site(), v.id, palette()),
                     vehicle_ == v.id, lookOf(v)});
  }
  // The chosen one lies above the others.
  std::stable_partition(marks.begin(), marks.end(), [](const VehicleMark& m) { return !m.chosen; });
  return marks;
}

Ground FloorCanvas::ground() const {
  Ground ground{view_, scene(), theme_, {}, fleet_.snapshot() ? fleet_.snapshot()->time + sinceSnapshot() : Seconds{}};
  if (!layers_.trails || !fleet_.snapshot()) return ground;
  // The chosen one's lies above the others, as its body does.
  for (const bool chosen : {false, true}) {
    for (const supervisor::VehicleView& v : fleet_.snapshot()->vehicles) {
      const Trail* trail = fleet_.trail(v.id);
      if (v.located && trail != nullptr && (vehicle_ == v.id) == chosen)
        ground.trails.push_back({v.id, trail, vehicleColour(map_->site(), v.id, palette())});
    }
  }
  return ground;
}

void FloorCanvas::finishDrawing() {
  do {
    ground_.prepare(ground());
    ground_.work(ground(), GroundLayer::kForever);
  } while (!ground_.settled());
  thorough_ = true;
  update();
}

void FloorCanvas::drawOn() {
  if (ground_.work(ground(), kSlice) || sprites_.isPending()) {
    update();
  } else if (!ground_.settled()) {
    drawing_.start();
  }
}

void FloorCanvas::paintEvent(QPaintEvent* event) {
  if (view_.devicePixelRatio() != devicePixelRatioF()) view_.resize(size(), devicePixelRatioF());
  const Ground under = ground();
  ground_.prepare(under);
  // A small floor is complete at once, a larger one goes on between frames: a frame that draws on as well would be too
  // long. A part of the window cannot be given another picture than the rest.
  if (!ground_.isWorking() && event->region().boundingRect() == rect()) ground_.work(under, kSlice);
  if (!ground_.settled()) drawing_.start();
  QPainter painter{this};
  painter.setFont(font());
  for (const QRect& rect : event->region()) ground_.blit(painter, rect, theme_.background);
  paintLive(painter, event->region());
  const QSize band = rulerBand(font()).toSize();
  if (layers_.grid && (event->region().intersects(QRect{0, 0, band.width(), height()}) ||
                       event->region().intersects(QRect{0, height() - band.height(), width(), band.height()})))
    paintRulers(painter, view_, theme_);
  paintScaleBar(painter, view_, theme_);
  paintNorthArrow(painter, view_, theme_, map_->site().northToY);
  double below = 0.0;
  if (!changes().empty()) below = paintChangeLegend(painter, view_, theme_, changes());
  if (layers_.iron) magnetic_.paintLegend(painter, view_, theme_, below);
}

void FloorCanvas::paintLive(QPainter& painter, const QRegion& region) {
  const Seconds now = fleet_.snapshot() ? fleet_.snapshot()->time + sinceSnapshot() : Seconds{};
  const std::vector<VehicleMark> all = marks();
  sprites_.begin(view_, std::exchange(thorough_, false));
  painter.setRenderHint(QPainter::Antialiasing);
  if (layers_.iron) magnetic_.paint(painter, view_, theme_);
  if (!tileMarks_.empty()) {
    painter.save();
    paintTileMarks(painter, view_, theme_, tileMarks_, region.boundingRect());
    painter.restore();
  }
  std::vector<VehicleMark> seen;
  for (const VehicleMark& mark : all) {
    if (region.intersects(extentOf(mark, view_, font(), layers_).toAlignedRect())) seen.push_back(mark);
  }
  for (const VehicleMark& mark : seen) sprites_.paintGhost(painter, view_, theme_, mark);
  const QRectF shown = QRectF{region.boundingRect()}.adjusted(-20, -20, 20, 20);
  for (const FleetLayer::Flash& flash : fleet_.flashes()) {
    if (!shown.contains(view_.toPixel(flash.place))) continue;
    const QColor colour = vehicleColour(map_->site(), flash.vehicle, palette());
    sprites_.paintFlash(painter, view_, flash.place, colour, (now - flash.since) / FleetLayer::kFlash);
  }
  for (const VehicleMark& mark : seen) {
    sprites_.paintBody(painter, view_, theme_, mark);
    if (layers_.uncertainty) sprites_.paintDoubt(painter, view_, theme_, mark);
    paintObstacle(painter, view_, theme_, mark);
  }
  if (overlay_ != nullptr) {
    painter.save();
    overlay_->paint(painter, view_, theme_);
    painter.restore();
  }
  for (const VehicleMark& mark : seen) sprites_.paintLabel(painter, view_, theme_, mark);
  if (sprites_.isPending()) drawing_.start();
  if (!changes().empty()) changes_.paint(painter, view_, theme_);
  if (tool_) {
    painter.save();
    tool_->paint(painter, toolScene(), theme_);
    painter.restore();
  }
  if (layers_.faults && !marks_.empty()) {
    painter.save();
    paintMarks(painter, view_, theme_, marks_, chosenMark_, handlesOfTool());
    painter.restore();
  }
  if (!ring_.empty()) paintRing(painter, view_, theme_, ring_);
  if (tool_) {
    painter.save();
    tool_->paintAbove(painter, toolScene(), theme_);
    painter.restore();
  }
  const floor::Site& site = map_->site();
  if (index_->box().empty() && site.zones.empty() && site.routes.empty() && !site.backdrop && !tool_)
    paintEmpty(painter);
}

void FloorCanvas::paintEmpty(QPainter& painter) {
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.35);
  const QFontMetricsF metrics{large};
  const QRectF area = QRectF{rect()}.adjusted(width() * 0.1, 0, -width() * 0.1, 0);
  painter.setFont(large);
  painter.setPen(theme_.text);
  painter.drawText(area.translated(0, -metrics.height()), Qt::AlignCenter | Qt::TextWordWrap,
                   tr("This site has no tiles yet."));
  painter.setFont(font());
  painter.setPen(theme_.quietText);
  painter.drawText(
      area.translated(0, metrics.height() * 0.6), Qt::AlignCenter | Qt::TextWordWrap,
      tr("Choose Lay tiles in the tool bar (Ctrl+Shift+T) and drag over the floor. Tags that are known already come "
         "in with Site › Import…; Edit › Floor plan… puts a drawing of the building beneath."));
}

}  // namespace tessera::ui
