// Keys and menu of the lay tool, and what can be given up.
#include <QMenu>

#include "ui/lay/lay_tool.h"

namespace tessera::ui {
namespace {

constexpr Metres kTileNudge{0.01};

bool deletesTiles(const QKeyEvent& event) { return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace; }

bool isLetter(const QKeyEvent& event, Qt::Key key) {
  return event.key() == key && (event.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
}

bool duplicates(const QKeyEvent& event) { return event.key() == Qt::Key_D && event.modifiers() == Qt::ControlModifier; }

bool isTileArrow(const QKeyEvent& event) {
  return event.key() == Qt::Key_Left || event.key() == Qt::Key_Right || event.key() == Qt::Key_Up ||
         event.key() == Qt::Key_Down;
}

}  // namespace

// Whole tiles, so that they stay on their lattice; with Alt a centimetre.
std::optional<Offset> LayTool::arrowOf(const QKeyEvent& event) const {
  if (!isTileArrow(event)) return std::nullopt;
  Offset step{kTileNudge, kTileNudge};
  if (!event.modifiers().testFlag(Qt::AltModifier)) {
    const TileStamp one = stampOf(document_.site(), {*chosen_.begin()});
    if (!one.tiles.empty()) step = one.size;
  }
  switch (event.key()) {
    case Qt::Key_Left:
      return Offset{-step.x, {}};
    case Qt::Key_Right:
      return Offset{step.x, {}};
    case Qt::Key_Up:
      return Offset{{}, step.y};
    default:
      return Offset{{}, -step.y};
  }
}

bool LayTool::wantsShortcut(const QKeyEvent& event) const {
  if (event.key() == Qt::Key_Escape || event.matches(QKeySequence::SelectAll)) return true;
  if (inGesture()) return event.matches(QKeySequence::Undo) || event.matches(QKeySequence::Redo);
  if (isLetter(event, Qt::Key_R) || isLetter(event, Qt::Key_L) || isLetter(event, Qt::Key_C)) return true;
  if (event.matches(QKeySequence::Paste)) return hasCopy();
  return !chosen_.empty() &&
         (isTileArrow(event) || deletesTiles(event) || duplicates(event) || event.matches(QKeySequence::Copy));
}

bool LayTool::keyPressed(QKeyEvent& event, const CanvasScene& scene) {
  if (event.modifiers() != mouse_.modifiers && (ghost_ || inGesture())) {
    // Alt takes effect at once, not only when the mouse moves on.
    mouse_.modifiers = event.modifiers();
    mouseMoved(ToolMouse{mouse_}, scene);
  }
  if (event.matches(QKeySequence::Undo)) return undo();
  if (event.matches(QKeySequence::Redo)) return redo();
  if (inGesture()) return false;
  const auto before = document_.map();
  const bool taken = command(event);
  // What hangs at the mouse is another or turned. After an edit the scene is the old one: the next move tells.
  if (taken && mouseHere_ && document_.map() == before) hover(mouse_, scene);
  return taken;
}

bool LayTool::keyReleased(QKeyEvent& event, const CanvasScene& scene) {
  if (event.modifiers() != mouse_.modifiers && (ghost_ || inGesture())) {
    mouse_.modifiers = event.modifiers();
    mouseMoved(ToolMouse{mouse_}, scene);
  }
  return false;
}

bool LayTool::command(const QKeyEvent& event) {
  if (event.matches(QKeySequence::SelectAll)) {
    chooseAll();
  } else if (event.matches(QKeySequence::Paste)) {
    paste();
  } else if (isLetter(event, Qt::Key_L)) {
    setMode(Mode::Lay);
  } else if (isLetter(event, Qt::Key_C)) {
    setMode(Mode::Choose);
  } else if (isLetter(event, Qt::Key_R)) {
    if (event.modifiers().testFlag(Qt::ShiftModifier) && !chosen_.empty()) {
      turnEach();
    } else {
      turn();
    }
  } else if (chosen_.empty()) {
    return false;
  } else if (deletesTiles(event)) {
    removeChosen();
  } else if (duplicates(event)) {
    duplicate();
  } else if (event.matches(QKeySequence::Copy)) {
    copy();
  } else if (const auto arrow = arrowOf(event)) {
    moveBy(*arrow);
  } else {
    return false;
  }
  return true;
}

bool LayTool::cancel() {
  if (inGesture()) {
    if (const auto* band = std::get_if<LayBand>(&gesture_)) choose(band->before);
    gesture_.emplace<std::monostate>();
  } else if (stamp_) {
    stamp_.reset();
    ghost_.reset();
    Q_EMIT settingsChanged();
  } else if (!chosen_.empty()) {
    choose({});
  } else {
    ghost_.reset();
    return false;
  }
  touch();
  return true;
}

bool LayTool::undo() { return (inGesture() || stamp_) && cancel(); }
bool LayTool::redo() { return inGesture(); }

QCursor LayTool::cursor() const {
  if (std::holds_alternative<LayDrag>(gesture_)) return Qt::SizeAllCursor;
  if (stamp_ || std::holds_alternative<LayBand>(gesture_)) return Qt::CrossCursor;
  if (mode_ == Mode::Lay) return brush_.empty() ? Qt::ForbiddenCursor : Qt::CrossCursor;
  return overTile_ ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

QString LayTool::hint() const {
  if (std::holds_alternative<LayDrag>(gesture_))
    return tr("Tiles snap to their neighbours. Alt: no snapping. Esc: leave them where they were.");
  if (inGesture()) return tr("Let go to finish. Esc: as it was.");
  if (stamp_) return tr("Click where the copies are to lie. R: turn them. Alt: no snapping. Esc: leave it.");
  if (mode_ == Mode::Lay && brush_.empty()) return tr("This site has no tile type yet: make one in the panel Tiles.");
  if (mode_ == Mode::Lay)
    return tr("Drag over the floor to lay tiles, with Shift to fill a rectangle. R: turn. C: choose tiles. Esc: stop.");
  if (chosen_.empty()) return tr("Click a tile or drag around several to choose them. L: lay tiles.");
  return tr("Drag or arrow keys: move. R: turn. Del: delete. Ctrl+C, Ctrl+V: copy, paste. Ctrl+click: choose more.");
}

void LayTool::openMenu(const ToolMouse& mouse, const CanvasScene& scene) {
  if (stamp_) {
    cancel();
    return;
  }
  SiteBox here;
  here.add(mouse.place);
  std::string under;
  scene.floor.forEachTile(here, [&](const FloorIndex::Tile& tile) { under = scene.floor.serial(tile); });
  if (!under.empty() && !chosen_.contains(under)) {
    setMode(Mode::Choose);
    choose({under});
  }
  auto* menu = new QMenu{window_};
  menu->setObjectName("tileMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](QMenu* to, const QString& text, bool enabled, auto what) {
    to->addAction(text, this, what)->setEnabled(enabled);
  };
  const bool any = !chosen_.empty();
  add(menu, tr("&Turn"), any, [this] { turn(); });
  add(menu, tr("Turn &each"), any, [this] { turnEach(); });
  QMenu* aligning = menu->addMenu(tr("&Align"));
  aligning->setEnabled(any);
  add(aligning, tr("&Left edges"), any, [this] { align(LayEdits::Line::Left); });
  add(aligning, tr("&Right edges"), any, [this] { align(LayEdits::Line::Right); });
  add(aligning, tr("&Upper edges"), any, [this] { align(LayEdits::Line::Top); });
  add(aligning, tr("L&ower edges"), any, [this] { align(LayEdits::Line::Bottom); });
  add(aligning, tr("To the &neighbours"), any, [this] { align(LayEdits::Line::Lattice); });
  menu->addSeparator();
  add(menu, tr("&Copy"), any, [this] { copy(); });
  add(menu, tr("&Paste"), hasCopy(), [this] { paste(); });
  add(menu, tr("D&uplicate"), any, [this] { duplicate(); });
  add(menu, tr("&Delete"), any, [this] { removeChosen(); });
  menu->addSeparator();
  add(menu, tr("Choose a&ll"), true, [this] { chooseAll(); });
  menu->popup(mouse.global);
}

}  // namespace tessera::ui
