#include "ui/lay/lay_tool.h"

#include <QWidget>
#include <algorithm>

#include "floor/laid_tile.h"
#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

constexpr int kFirstMoveKey = 2'000'000;

}  // namespace

LayTool::LayTool(SiteDocument& document, QWidget* window)
    : CanvasTool{window}, document_{document}, edits_{document}, window_{window}, moves_{kFirstMoveKey} {
  connect(&document_, &SiteDocument::changed, this, &LayTool::documentChanged);
  connect(&document_, &SiteDocument::replaced, this, &LayTool::takeUpSite);
  takeUpSite();
}

void LayTool::touch() {
  Q_EMIT changed();
  Q_EMIT hintChanged(hint());
}

void LayTool::finish(const Result<void>& result) {
  if (!result) Q_EMIT refused(text(result.error().sentence));
  touch();
}

void LayTool::takeUpSite() {
  gesture_.emplace<std::monostate>();
  stamp_.reset();
  ghost_.reset();
  rule_ = floor::serialRuleOf(document_.site());
  mode_ = Mode::Lay;
  brush_.clear();
  brushTurns_ = 0;
  choose({});
  documentChanged();
}

void LayTool::documentChanged() {
  chosenBoxes_.reset();
  if (edits_.type(brush_) == nullptr) {
    const auto& types = document_.site().tileTypes;
    brush_ = types.empty() ? std::string{} : types.front().name;
    Q_EMIT settingsChanged();
  }
  if (editing_) return;
  gesture_.emplace<std::monostate>();
  if (!chosen_.empty()) {
    TileSet left;
    for (const floor::Placement& placement : document_.site().placements)
      if (chosen_.contains(placement.serial)) left.insert(placement.serial);
    choose(std::move(left));
  }
  touch();
}

void LayTool::setMode(Mode mode) {
  if (mode == mode_ && !stamp_) return;
  mode_ = mode;
  gesture_.emplace<std::monostate>();
  stamp_.reset();
  ghost_.reset();
  if (mode == Mode::Lay) choose({});
  Q_EMIT settingsChanged();
  touch();
}

void LayTool::setBrush(const std::string& type) {
  if (type == brush_) return;
  brush_ = type;
  gesture_.emplace<std::monostate>();
  ghost_.reset();
  Q_EMIT settingsChanged();
  touch();
}

void LayTool::setRule(const floor::SerialRule& rule) {
  if (rule == rule_) return;
  rule_ = rule;
  Q_EMIT settingsChanged();
}

void LayTool::choose(TileSet tiles) {
  if (tiles == chosen_) return;
  chosen_ = std::move(tiles);
  chosenBoxes_.reset();
  ++moves_;
  Q_EMIT chosenChanged();
  touch();
}

std::optional<Offset> LayTool::brushSize() const {
  const floor::TileType* type = edits_.type(brush_);
  if (type == nullptr) return std::nullopt;
  return brushTurns_ % 2 == 0 ? Offset{type->width, type->height} : Offset{type->height, type->width};
}

void LayTool::turn() {
  if (stamp_) {
    stamp_->turn();
    ghost_.reset();
  } else if (!chosen_.empty()) {
    editing_ = true;
    const auto done = edits_.turn(chosen_);
    editing_ = false;
    return finish(done);
  } else {
    brushTurns_ = (brushTurns_ + 1) % 4;
    ghost_.reset();
    Q_EMIT settingsChanged();
  }
  touch();
}

void LayTool::turnEach() {
  editing_ = true;
  const auto done = edits_.turnEach(chosen_);
  editing_ = false;
  finish(done);
}

void LayTool::align(LayEdits::Line line) {
  editing_ = true;
  const auto done = edits_.align(chosen_, line);
  editing_ = false;
  finish(done);
}

void LayTool::removeChosen() {
  const TileSet gone = chosen_;
  choose({});
  finish(edits_.remove(gone));
}

void LayTool::moveBy(Offset by) {
  if (chosen_.empty()) return;
  editing_ = true;
  const auto done = edits_.move(chosen_, by, moves_);
  editing_ = false;
  finish(done);
}

void LayTool::chooseAll() {
  setMode(Mode::Choose);
  TileSet all;
  for (const floor::Placement& placement : document_.site().placements) all.insert(placement.serial);
  choose(std::move(all));
}

void LayTool::copy() {
  if (chosen_.empty()) return;
  copy_ = stampOf(document_.site(), chosen_);
  Q_EMIT settingsChanged();
}

void LayTool::paste() {
  if (copy_.tiles.empty()) return;
  gesture_.emplace<std::monostate>();
  stamp_ = copy_;
  ghost_.reset();
  Q_EMIT settingsChanged();
  touch();
}

void LayTool::rename(const QString& serial) {
  if (chosen_.size() != 1) return;
  const std::string before = *chosen_.begin();
  editing_ = true;
  const auto done = edits_.rename(before, serial);
  editing_ = false;
  if (done) choose({serial.trimmed().toStdString()});
  finish(done);
}

void LayTool::place(Point low, int quarterTurns, int mergeKey) {
  if (chosen_.size() != 1) return;
  editing_ = true;
  const auto done = edits_.place(*chosen_.begin(), low, quarterTurns, mergeKey);
  editing_ = false;
  finish(done);
}

void LayTool::lay(const QString& step, const std::vector<NewTile>& tiles, const std::vector<floor::TileType>& types) {
  if (tiles.empty()) return;
  editing_ = true;
  const auto laid = edits_.lay(step, tiles, rule_, types);
  editing_ = false;
  if (laid && mode_ == Mode::Choose) choose(*laid);
  finish(laid ? Result<void>{} : tl::unexpected{laid.error()});
}

void LayTool::layBoxes(const std::vector<Box>& boxes) {
  std::vector<NewTile> tiles;
  tiles.reserve(boxes.size());
  for (const Box& box : boxes) tiles.push_back({brush_, box.low, brushTurns_});
  lay(tr("Lay %n tile(s)", nullptr, static_cast<int>(tiles.size())), tiles, {});
}

// Beside the chosen ones, to the right or else above, as near as there is room.
void LayTool::duplicate() {
  if (chosen_.empty()) return;
  const TileStamp stamp = stampOf(document_.site(), chosen_);
  Box all;
  bool any = false;
  const FloorIndex floor{document_.site()};
  for (const FloorIndex::Tile& tile : floor.tiles()) {
    if (!chosen_.contains(floor.serial(tile))) continue;
    all = any ? boxAround(all, boxOf(tile.box)) : boxOf(tile.box);
    any = true;
  }
  for (int n = 1; any && n <= 1000; ++n) {
    for (const Offset way : {Offset{n * stamp.size.x, {}}, Offset{{}, n * stamp.size.y}}) {
      const Point low = toMicrometre(all.low + way);
      const bool free = std::all_of(stamp.tiles.begin(), stamp.tiles.end(),
                                    [&](const NewTile& tile) { return isFree(floor, stamp.boxOf(tile, low)); });
      if (!free) continue;
      std::vector<NewTile> tiles = stamp.tiles;
      for (NewTile& tile : tiles) tile.low = low + (tile.low - Point{});
      setMode(Mode::Choose);
      return lay(tr("Duplicate %n tile(s)", nullptr, static_cast<int>(tiles.size())), tiles, {});
    }
  }
  Q_EMIT refused(tr("There is no room beside the chosen tiles: copy them and paste them where there is."));
}

void LayTool::putStamp() {
  if (!stamp_ || !ghost_) return;
  std::vector<NewTile> tiles = stamp_->tiles;
  for (NewTile& tile : tiles) tile.low = *ghost_ + (tile.low - Point{});
  const std::vector<floor::TileType> types = stamp_->types;
  if (!ghostFree_) {
    Q_EMIT refused(tr("There are tiles already: none may lie upon another."));
    return;
  }
  stamp_.reset();
  ghost_.reset();
  mode_ = Mode::Choose;
  Q_EMIT settingsChanged();
  lay(tr("Paste %n tile(s)", nullptr, static_cast<int>(tiles.size())), tiles, types);
}

}  // namespace tessera::ui
