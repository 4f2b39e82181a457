#include "ui/backdrop/backdrop_tool.h"

#include <QPolygonF>

#include "ui/base/tidy.h"
#include "ui/canvas/draft_tool.h"

namespace tessera::ui {
namespace {

constexpr int kFirstPlanNudgeKey = 41'000'000;  // apart from those of other tools

}  // namespace

BackdropTool::BackdropTool(SiteDocument& document) : edits_{document}, nudges_{kFirstPlanNudgeKey} {
  connect(&document, &SiteDocument::changed, this, &BackdropTool::documentChanged);
  documentChanged();
}

void BackdropTool::documentChanged() {
  const floor::Backdrop* now = edits_.find();
  if ((now == nullptr) == !seen_ && (now == nullptr || *now == *seen_)) return;
  // What was begun on the picture as it was means nothing any more.
  seen_ = now != nullptr ? std::optional{*now} : std::nullopt;
  picture_ = now != nullptr ? BackdropPicture::of(now->picture) : nullptr;
  drag_.reset();
  points_.clear();
  if (now == nullptr) scaling_ = false;
  touch();
}

void BackdropTool::startScaling() {
  if (edits_.find() == nullptr) return;
  scaling_ = true;
  points_.clear();
  drag_.reset();
  touch();
}

void BackdropTool::stopScaling() {
  scaling_ = false;
  points_.clear();
  touch();
}

std::optional<Metres> BackdropTool::between() const {
  return points_.size() == 2 ? std::optional{distance(points_[0], points_[1])} : std::nullopt;
}

Result<void> BackdropTool::finishScaling(Metres truly) {
  if (points_.size() != 2) return {};
  auto done = edits_.scale(points_[0], points_[1], truly);
  if (done) stopScaling();
  return done;
}

std::array<Point, 4> BackdropTool::corners() const { return cornersOf(backdrop().value_or(*seen_), picture_->size()); }

bool BackdropTool::isOnPicture(QPointF pixel, const View& view) const {
  if (!seen_ || !picture_ || picture_->fault()) return false;
  QPolygonF outline;
  for (const Point& p : corners()) outline.push_back(view.toPixel(p));
  return outline.containsPoint(pixel, Qt::OddEvenFill);
}

bool BackdropTool::mousePressed(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.button != Qt::LeftButton || !seen_) return false;
  if (scaling_) {
    if (points_.size() == 2) points_.clear();
    points_.push_back(mouse.place);
    touch();
    if (points_.size() == 2) Q_EMIT distanceWanted();
    return true;
  }
  if (!isOnPicture(mouse.pixel, scene.view)) return false;
  ++nudges_;
  drag_ = Drag{mouse.place, {}};
  touch();
  return true;
}

bool BackdropTool::mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) {
  if (mouse.buttons.testFlag(Qt::MiddleButton)) return false;
  pointer_ = mouse.place;
  over_ = isOnPicture(mouse.pixel, scene.view);
  if (drag_) drag_->by = mouse.place - drag_->begin;
  touch();
  return drag_.has_value();
}

bool BackdropTool::mouseReleased(const ToolMouse& mouse, const CanvasScene& /*scene*/) {
  if (mouse.button != Qt::LeftButton) return false;
  if (!drag_) return scaling_;
  const Point to = seen_->origin + (mouse.place - drag_->begin);
  const bool moved = mouse.place != drag_->begin;
  drag_.reset();
  if (moved) {
    if (const auto done = edits_.move(to); !done) Q_EMIT refused(done.error());
  }
  touch();
  return true;
}

bool BackdropTool::mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) {
  return mousePressed(mouse, scene);
}

bool BackdropTool::keyPressed(QKeyEvent& event, const CanvasScene& /*scene*/) {
  if (scaling_) return event.key() == Qt::Key_Backspace && undo();
  const auto step = nudgeOf(event);
  if (!step || !seen_ || drag_) return false;
  if (const auto done = edits_.move(seen_->origin + *step, nudges_); !done) Q_EMIT refused(done.error());
  return true;
}

bool BackdropTool::keyReleased(QKeyEvent& /*event*/, const CanvasScene& /*scene*/) { return false; }

bool BackdropTool::wantsShortcut(const QKeyEvent& event) const {
  return scaling_ && !points_.empty() && event.key() == Qt::Key_Backspace;
}

void BackdropTool::mouseLeft() {
  pointer_.reset();
  over_ = false;
  touch();
}

std::optional<floor::Backdrop> BackdropTool::backdrop() const {
  if (!drag_ || !seen_) return std::nullopt;
  floor::Backdrop led = *seen_;
  led.origin = tidy(led.origin + drag_->by);
  return led;
}

QCursor BackdropTool::cursor() const {
  if (scaling_) return Qt::CrossCursor;
  return over_ || drag_ ? Qt::SizeAllCursor : Qt::ArrowCursor;
}

QString BackdropTool::hint() const {
  if (!seen_) return tr("Floor plan: choose a picture in its panel.");
  if (!scaling_) return tr("Drag the floor plan or press the arrow keys (Shift: 10 cm). Esc lays the tool down.");
  if (points_.empty()) return tr("Click the first of two points whose distance you know. Esc cancels.");
  if (points_.size() == 1) return tr("Click the second point. Backspace: back. Esc cancels.");
  return tr("Type the true distance in the panel. Backspace: back. Esc cancels.");
}

bool BackdropTool::cancel() {
  if (!drag_ && !scaling_) return false;
  drag_.reset();
  stopScaling();
  return true;
}

bool BackdropTool::undo() {
  if (points_.empty()) return false;
  points_.pop_back();
  touch();
  return true;
}

void BackdropTool::touch() {
  Q_EMIT changed();
  Q_EMIT hintChanged(hint());
}

}  // namespace tessera::ui
