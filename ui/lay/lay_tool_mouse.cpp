// The mouse in the lay tool: which gesture begins, how it goes on, and what it leaves behind.
#include <QApplication>
#include <cmath>

#include "ui/lay/lay_tool.h"

namespace tessera::ui {
namespace {

// Of so many the preview can say at once whether one would lie upon another; of more the step itself says it.
constexpr std::size_t kCheckedAtOnce = 2000;

const FloorIndex::Tile* tileAt(const CanvasScene& scene, Point place) {
  const FloorIndex::Tile* found = nullptr;
  SiteBox here;
  here.add(place);
  scene.floor.forEachTile(here, [&](const FloorIndex::Tile& tile) { found = &tile; });
  return found;
}

Point toMillimetre(Point p) {
  const auto rounded = [](Metres m) { return Metres{std::round(m.value() * 1000.0) / 1000.0 + 0.0}; };
  return {rounded(p.x), rounded(p.y)};
}

bool farFrom(QPointF a, QPointF b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y()) >= QApplication::startDragDistance() / 2.0;
}

}  // namespace

Point LayTool::ghostAt(const ToolMouse& mouse, const CanvasScene& scene) const {
  const Offset size = *brushSize();
  const Point low = mouse.place - 0.5 * size;
  return mouse.modifiers.testFlag(Qt::AltModifier) ? toMillimetre(low) : snappedTile(scene.floor, size, low);
}

Point LayTool::stampAt(const ToolMouse& mouse, const CanvasScene& scene) const {
  const Point low = mouse.place - 0.5 * stamp_->size;
  if (mouse.modifiers.testFlag(Qt::AltModifier)) return toMillimetre(low);
  const Box first = stamp_->boxOf(stamp_->tiles.front(), low);
  return toMicrometre(low + (snappedTile(scene.floor, sizeOf(first), first.low) - first.low));
}

bool LayTool::mousePressed(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  mouseHere_ = true;
  if (mouse.button == Qt::RightButton) {
    if (!inGesture()) openMenu(mouse, scene);
    return true;
  }
  if (mouse.button != Qt::LeftButton) return false;
  if (stamp_) {
    hover(mouse, scene);
    putStamp();
  } else if (mode_ == Mode::Lay) {
    beginLaying(mouse, scene);
  } else {
    beginChoosing(mouse, scene);
  }
  touch();
  return true;
}

void LayTool::beginLaying(const ToolMouse& mouse, const CanvasScene& scene) {
  if (!brushSize()) {
    Q_EMIT refused(tr("This site has no tile type yet: make one first."));
    return;
  }
  const LayLattice lattice{ghostAt(mouse, scene), *brushSize()};
  ghost_.reset();
  if (mouse.modifiers.testFlag(Qt::ShiftModifier)) {
    gesture_ = LayFill{lattice, {}};
    return;
  }
  LayStroke stroke{lattice};
  stroke.goTo({}, scene.floor);
  gesture_ = std::move(stroke);
}

void LayTool::beginChoosing(const ToolMouse& mouse, const CanvasScene& scene) {
  const bool more = mouse.modifiers.testFlag(Qt::ControlModifier);
  const FloorIndex::Tile* tile = tileAt(scene, mouse.place);
  if (tile == nullptr) {
    if (!more) choose({});
    gesture_ = LayBand{mouse.pixel, mouse.pixel, chosen_};
    return;
  }
  const std::string& serial = scene.floor.serial(*tile);
  if (more) {
    TileSet tiles = chosen_;
    if (tiles.erase(serial) == 0) tiles.insert(serial);
    return choose(std::move(tiles));
  }
  if (!chosen_.contains(serial)) choose({serial});
  LayDrag drag;
  drag.grabbed = serial;
  drag.grabbedBox = boxOf(tile->box);
  drag.pressed = mouse.pixel;
  drag.from = mouse.place;
  for (const FloorIndex::Tile& one : scene.floor.tiles())
    if (chosen_.contains(scene.floor.serial(one))) drag.boxes.push_back(boxOf(one.box));
  gesture_ = std::move(drag);
}

bool LayTool::mouseMoved(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  mouseHere_ = true;
  if (auto* stroke = std::get_if<LayStroke>(&gesture_)) {
    stroke->goTo(stroke->lattice().cellAt(mouse.place), scene.floor);
  } else if (auto* fill = std::get_if<LayFill>(&gesture_)) {
    fill->to = fill->lattice.cellAt(mouse.place);
  } else if (auto* band = std::get_if<LayBand>(&gesture_)) {
    moveBand(*band, mouse, scene);
  } else if (auto* drag = std::get_if<LayDrag>(&gesture_)) {
    moveDrag(*drag, mouse, scene);
  } else {
    hover(mouse, scene);
    return false;
  }
  Q_EMIT changed();
  return true;
}

void LayTool::hover(const ToolMouse& mouse, const CanvasScene& scene) {
  const std::optional<Point> before = ghost_;
  const bool over = overTile_;
  ghost_.reset();
  overTile_ = false;
  if (stamp_) {
    ghost_ = stampAt(mouse, scene);
    ghostFree_ = true;
    for (std::size_t n = 0; ghostFree_ && n < std::min(stamp_->tiles.size(), kCheckedAtOnce); ++n)
      ghostFree_ = isFree(scene.floor, stamp_->boxOf(stamp_->tiles[n], *ghost_));
  } else if (mode_ == Mode::Choose) {
    overTile_ = tileAt(scene, mouse.place) != nullptr;
  } else if (const auto size = brushSize()) {
    ghost_ = ghostAt(mouse, scene);
    ghostFree_ = isFree(scene.floor, boxOf(*ghost_, *size));
  }
  if (ghost_ != before || over != overTile_) Q_EMIT changed();
}

void LayTool::moveBand(LayBand& band, const ToolMouse& mouse, const CanvasScene& scene) {
  band.to = mouse.pixel;
  TileSet tiles = band.before;
  if (farFrom(band.from, band.to)) {
    SiteBox box;
    box.add(scene.view.toSite(band.from));
    box.add(mouse.place);
    scene.floor.forEachTile(box, [&](const FloorIndex::Tile& tile) { tiles.insert(scene.floor.serial(tile)); });
  }
  choose(std::move(tiles));
}

void LayTool::moveDrag(LayDrag& drag, const ToolMouse& mouse, const CanvasScene& scene) {
  if (!drag.moved && !farFrom(mouse.pixel, drag.pressed)) return;
  drag.moved = true;
  const SkipTile ours = [&](const FloorIndex::Tile& tile) { return chosen_.contains(scene.floor.serial(tile)); };
  const Point low = drag.grabbedBox.low + (mouse.place - drag.from);
  const Point to = mouse.modifiers.testFlag(Qt::AltModifier)
                       ? toMillimetre(low)
                       : snappedTile(scene.floor, sizeOf(drag.grabbedBox), low, ours);
  drag.by = to - drag.grabbedBox.low;
  drag.free = true;
  for (std::size_t n = 0; drag.free && drag.boxes.size() <= kCheckedAtOnce && n < drag.boxes.size(); ++n) {
    const Box& box = drag.boxes[n];
    drag.free = isFree(scene.floor, {box.low + drag.by, box.high + drag.by}, Metres{0.03}, ours);
  }
}

bool LayTool::mouseReleased(const ToolMouse& mouse, const CanvasScene& scene) {
  mouse_ = mouse;
  if (mouse.button != Qt::LeftButton) return true;
  // The document changes in here: the gesture is over before it does.
  const LayGesture done = std::move(gesture_);
  gesture_.emplace<std::monostate>();
  if (const auto* stroke = std::get_if<LayStroke>(&done)) {
    layBoxes(stroke->boxes());
  } else if (const auto* fill = std::get_if<LayFill>(&done)) {
    if (fill->tooMany()) {
      Q_EMIT refused(tr("So many tiles are too many at once: fill a smaller rectangle."));
    } else {
      layBoxes(fill->freeBoxes(scene.floor, fill->box()));
    }
  } else if (const auto* drag = std::get_if<LayDrag>(&done)) {
    endDrag(*drag);
  }
  touch();
  return true;
}

void LayTool::endDrag(const LayDrag& drag) {
  if (!drag.moved) return choose({drag.grabbed});
  ++moves_;
  editing_ = true;
  const auto done = edits_.move(chosen_, drag.by);
  editing_ = false;
  finish(done);
}

bool LayTool::mouseDoubleClicked(const ToolMouse& mouse, const CanvasScene& scene) {
  // A quick hand's second click is a click like any other.
  return mousePressed(mouse, scene);
}

void LayTool::mouseLeft() {
  mouseHere_ = false;
  if (inGesture()) return;
  ghost_.reset();
  overTile_ = false;
  Q_EMIT changed();
}

}  // namespace tessera::ui
