// Marks of faults and of differences on the canvas, and how it goes to a place.
#include <QMouseEvent>
#include <algorithm>

#include "ui/canvas/floor_canvas.h"

namespace tessera::ui {
namespace {

constexpr double kPlaceMargin = 120.0;
constexpr double kNearest = 400.0;  // pixels per metre: a tile fills the window's height or so

}  // namespace

void FloorCanvas::setMarks(std::vector<FloorMark> marks, std::optional<std::size_t> chosen) {
  if (marks == marks_ && chosen == chosenMark_) return;
  marks_ = std::move(marks);
  chosenMark_ = chosen;
  update();
}

bool FloorCanvas::openMarkMenu(const QMouseEvent& event) {
  if (!layers_.faults || (tool_ && tool_->isBusy())) return false;
  const HandleAt handles = handlesOfTool();
  const FloorMark* mark = markAt(marks_, view_, event.position(), handles);
  if (mark == nullptr || mark->row < 0) return false;
  // A sign beside its handle is in nobody's way: any button will do.
  if (event.button() != Qt::RightButton && (!handles || !handles(view_.toPixel(mark->place.centre())))) return false;
  menuMouse_ = toolMouse(event);
  Q_EMIT markMenuRequested(mark->row, event.globalPosition().toPoint());
  return true;
}

HandleAt FloorCanvas::handlesOfTool() const {
  if (!tool_) return {};
  return [this](QPointF pixel) { return tool_->hasHandleAt(pixel, toolScene()); };
}

void FloorCanvas::openToolMenu() {
  if (tool_) tool_->mousePressed(menuMouse_, toolScene());
}

void FloorCanvas::setChanges(ChangeMarks changes) {
  if (changes.empty() && changes_.marks().empty()) return;
  changes_.set(std::move(changes));
  update();
}

void FloorCanvas::setTileMarks(std::vector<TileMark> marks) {
  if (marks == tileMarks_) return;
  tileMarks_ = std::move(marks);
  update();
}

void FloorCanvas::setMagneticMap(std::shared_ptr<const locate::MagneticMap> map) {
  if (map == magnetic_.map()) return;
  magnetic_.set(std::move(map));
  if (layers_.iron) update();
}

void FloorCanvas::setRing(const SiteBox& place) {
  ring_ = place;
  update();
}

void FloorCanvas::showPlace(const SiteBox& place) {
  if (place.empty()) return;
  follow(std::nullopt);
  // From where everything can be seen it goes near; who is near already stays so.
  View whole = view_;
  whole.fit(place.grown(Metres{0.3}), kPlaceMargin);
  const double most = std::min(whole.scale(), kNearest);
  const double least = std::min(most, 60.0);
  view_.setScale(std::clamp(view_.scale(), least, most));
  view_.centreOn(place.centre());
  viewMoved(true);
}

}  // namespace tessera::ui
