// Mouse, wheel, pinch and keys of the canvas. The tool is asked first; what it leaves pans, zooms and chooses.
#include <QApplication>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>

#include "ui/canvas/floor_canvas.h"
#include "ui/canvas/route_painter.h"

namespace tessera::ui {
namespace {

constexpr double kRouteReach = 7.0;
constexpr double kTagReach = 7.0;
constexpr double kKeyPan = 80.0;
constexpr double kWheelNotch = 360.0;  // eighths of a degree that double the scale: three notches

}  // namespace

ToolMouse FloorCanvas::toolMouse(const QMouseEvent& event) const {
  return {view_.toSite(event.position()),  event.position(), event.button(), event.buttons(), event.modifiers(),
          event.globalPosition().toPoint()};
}

bool FloorCanvas::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::ShortcutOverride: {
      auto* key = static_cast<QKeyEvent*>(event);
      if (tool_ && tool_->wantsShortcut(*key)) {
        key->accept();
        return true;
      }
      break;
    }
    case QEvent::NativeGesture:
    case QEvent::Gesture:
      if (pinch(event)) return true;
      break;
    case QEvent::ToolTip: {
      const auto* help = static_cast<QHelpEvent*>(event);
      showToolTip(help->pos(), help->globalPos());
      return true;
    }
    default:
      break;
  }
  return QWidget::event(event);
}

bool FloorCanvas::pinch(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto* native = static_cast<QNativeGestureEvent*>(event);
    if (native->gestureType() != Qt::ZoomNativeGesture) return false;
    zoomBy(native->position(), 1.0 + native->value());
    return true;
  }
  const auto* gesture = static_cast<QPinchGesture*>(static_cast<QGestureEvent*>(event)->gesture(Qt::PinchGesture));
  if (gesture == nullptr) return false;
  zoomBy(mapFromGlobal(gesture->centerPoint()), gesture->scaleFactor());
  return true;
}

void FloorCanvas::wheelEvent(QWheelEvent* event) {
  const int turn = event->angleDelta().y();
  if (turn != 0) zoomBy(event->position(), std::exp2(turn / kWheelNotch));
  event->accept();
}

void FloorCanvas::mousePressEvent(QMouseEvent* event) {
  lastAt_ = event->position();
  if (!ring_.empty()) setRing({});
  const bool pans = event->button() == Qt::MiddleButton || (space_ && event->button() == Qt::LeftButton);
  if (!pans && openMarkMenu(*event)) return;
  if (!pans && tool_ && tool_->mousePressed(toolMouse(*event), toolScene())) return;
  if (!pans && event->button() != Qt::LeftButton) return;
  drag_ = pans ? Drag::Panning : Drag::Waiting;
  dragButton_ = event->button();
  pressedAt_ = event->position();
  refreshCursor();
}

void FloorCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (drag_ == Drag::Waiting && (at - pressedAt_).manhattanLength() >= QApplication::startDragDistance()) {
    drag_ = Drag::Panning;
    refreshCursor();
  }
  if (drag_ == Drag::Panning) {
    panByHand(at - lastAt_);
  } else if (drag_ == Drag::None && tool_) {
    tool_->mouseMoved(toolMouse(*event), toolScene());
  }
  lastAt_ = at;
  Q_EMIT pointed(view_.toSite(at));
}

void FloorCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (drag_ == Drag::None) {
    if (tool_) tool_->mouseReleased(toolMouse(*event), toolScene());
    return;
  }
  if (event->button() != dragButton_) return;
  const bool click = drag_ == Drag::Waiting;
  drag_ = Drag::None;
  refreshCursor();
  if (click) pick(event->position());
}

void FloorCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (tool_ && tool_->mouseDoubleClicked(toolMouse(*event), toolScene())) return;
  if (event->button() != Qt::LeftButton) return;
  if (const auto vehicle = vehicleAt(event->position())) follow(vehicle);
}

void FloorCanvas::leaveEvent(QEvent* /*event*/) {
  if (tool_) tool_->mouseLeft();
  Q_EMIT pointed(std::nullopt);
}

void FloorCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && !ring_.empty()) return setRing({});
  if (tool_ && tool_->keyPressed(*event, toolScene())) return;
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 4 * kKeyPan : kKeyPan;
  switch (event->key()) {
    case Qt::Key_Left:
      return panByHand({step, 0});
    case Qt::Key_Right:
      return panByHand({-step, 0});
    case Qt::Key_Up:
      return panByHand({0, step});
    case Qt::Key_Down:
      return panByHand({0, -step});
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoomIn();
    case Qt::Key_Minus:
      return zoomOut();
    case Qt::Key_0:
    case Qt::Key_Home:
      return fit();
    case Qt::Key_Space:
      space_ = true;
      return refreshCursor();
    case Qt::Key_Escape:
      if (!tool_) break;
      if (!tool_->cancel()) setTool(nullptr);
      return;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

void FloorCanvas::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    space_ = false;
    refreshCursor();
    return;
  }
  if (tool_ && tool_->keyReleased(*event, toolScene())) return;
  QWidget::keyReleaseEvent(event);
}

void FloorCanvas::focusOutEvent(QFocusEvent* event) {
  space_ = false;
  refreshCursor();
  QWidget::focusOutEvent(event);
}

void FloorCanvas::refreshCursor() {
  if (drag_ == Drag::Panning) {
    setCursor(Qt::ClosedHandCursor);
  } else if (space_) {
    setCursor(Qt::OpenHandCursor);
  } else if (tool_) {
    setCursor(tool_->cursor());
  } else {
    unsetCursor();
  }
}

std::optional<VehicleId> FloorCanvas::vehicleAt(QPointF pixel) const {
  const std::vector<VehicleMark> all = marks();
  for (auto mark = all.rbegin(); mark != all.rend(); ++mark) {
    if (footprintOf(*mark, view_, mark->pose).containsPoint(pixel, Qt::OddEvenFill)) return mark->vehicle->id;
  }
  return std::nullopt;
}

QString FloorCanvas::routeAt(QPointF pixel) const {
  QString nearest;
  double least = kRouteReach;
  if (!layers_.routes) return nearest;
  for (const floor::Route& route : map_->site().routes) {
    const double away = pixelsFromRoute(view_, route.vertices, pixel);
    if (away > least) continue;
    least = away;
    nearest = QString::fromStdString(route.name);
  }
  return nearest;
}

void FloorCanvas::pick(QPointF pixel) {
  if (const auto vehicle = vehicleAt(pixel)) {
    Q_EMIT vehiclePicked(*vehicle);
  } else if (const QString route = routeAt(pixel); !route.isEmpty()) {
    Q_EMIT routePicked(route);
  } else {
    Q_EMIT floorPicked(view_.toSite(pixel));
  }
}

void FloorCanvas::showToolTip(QPoint pixel, QPoint global) {
  QString text;
  const QLocale locale;
  const auto place = [&locale](Metres m) { return locale.toString(m.value(), 'f', 3); };
  const HandleAt handles = handlesOfTool();
  const FloorMark* own = tool_ ? markAt(tool_->marks(), view_, pixel, handles) : nullptr;
  const FloorMark* other = layers_.faults && own == nullptr ? markAt(marks_, view_, pixel, handles) : nullptr;
  if (const FloorMark* mark = own != nullptr ? own : other) {
    text = mark->sentence;
  } else if (const ChangeMarks::Sign* change = changeAt(changes(), view_, pixel)) {
    text = change->sentence;
  } else if (const auto id = vehicleAt(pixel)) {
    const supervisor::VehicleView& v = *fleet_.snapshot()->find(*id);
    text = tr("%1\nx %2 m, y %3 m, %4 m/s")
               .arg(QString::fromStdString(v.name), place(v.pose.position.x), place(v.pose.position.y),
                    locale.toString(v.speed.value(), 'f', 2));
  } else if (layers_.tags && view_.pixels(index_->pitch()) >= 2 * kTagReach) {
    map_->forEachNear(view_.toSite(pixel), view_.metres(kTagReach), [&](const floor::PlacedTag& tag) {
      text = tr("Tag %1\nx %2 m, y %3 m")
                 .arg(QString::fromStdString(tag.uid.text()), place(tag.place.x), place(tag.place.y));
    });
  }
  if (text.isEmpty() && layers_.iron) text = magnetic_.textAt(view_.toSite(pixel));
  if (text.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(global, text, this, QRect{pixel - QPoint{6, 6}, QSize{12, 12}});
  }
}

}  // namespace tessera::ui
