#include "ui/tilecheck/tile_watch.h"

#include <QStringList>
#include <algorithm>

#include "floor/laid_tile.h"
#include "floor/tile_finder.h"
#include "ui/canvas/floor_index.h"

namespace tessera::ui {
namespace {

constexpr int kSoonMs = 300;
constexpr int kRestFactor = 10;  // of the time, so that a check of a huge floor leaves nine tenths to the window

std::optional<SiteBox> boxOfTile(const floor::SiteMap& map, const floor::Placement& placement) {
  const auto& site = map.site();
  const auto tile = std::find_if(site.tiles.begin(), site.tiles.end(),
                                 [&](const floor::Tile& t) { return t.serial == placement.serial; });
  if (tile == site.tiles.end()) return std::nullopt;
  const auto type = std::find_if(site.tileTypes.begin(), site.tileTypes.end(),
                                 [&](const floor::TileType& t) { return t.name == tile->type; });
  if (type == site.tileTypes.end()) return std::nullopt;
  const Box box = floor::boxOf(placement, *type);
  return SiteBox{box.low, box.high};
}

}  // namespace

TileWatch::TileWatch(SiteDocument& document, FleetLink& fleet) : document_{document}, fleet_{fleet} {
  soon_.setSingleShot(true);
  soon_.setInterval(kSoonMs);
  connect(&soon_, &QTimer::timeout, this, &TileWatch::check);
  connect(&fleet_, &FleetLink::snapshotChanged, this, &TileWatch::takeSnapshot);
  connect(&document_, &SiteDocument::changed, this, &TileWatch::documentChanged);
  connect(&document_, &SiteDocument::replaced, this, [this] {
    running_ = false;
    reset();
  });
  check();
}

void TileWatch::setRunning(bool running) {
  if (running == running_) return;
  running_ = running;
  Q_EMIT changed();
}

void TileWatch::reset() {
  collector_.clear();
  check();
}

void TileWatch::takeSnapshot() {
  const auto snapshot = fleet_.latest();
  if (!running_ || !snapshot) return;
  const std::size_t before = collector_.taken();
  collector_.take(*snapshot, *document_.map());
  if (collector_.taken() != before) soon();
}

void TileWatch::documentChanged() {
  if (checked_ && sameFloor(checked_->site(), document_.site())) return;
  soon();
}

void TileWatch::soon() {
  if (!soon_.isActive()) soon_.start();
}

void TileWatch::check() {
  QElapsedTimer clock;
  clock.start();
  checked_ = document_.map();
  result_ = tilecheck::checkFloor(checked_->site(), collector_.reads());
  findings_ = tilecheck::checkTags(checked_->site(), collector_.reads(), collector_.passes(), result_);
  progress_ = {};
  progress_.tiles = static_cast<int>(result_.states.size());
  for (const tilecheck::TileState state : result_.states) {
    progress_.confirmed += state == tilecheck::TileState::Confirmed ? 1 : 0;
    progress_.seen += state == tilecheck::TileState::Seen ? 1 : 0;
    progress_.suspect += state == tilecheck::TileState::Suspect ? 1 : 0;
  }
  soon_.setInterval(std::max(kSoonMs, static_cast<int>(kRestFactor * clock.elapsed())));
  Q_EMIT changed();
}

std::vector<TileMark> TileWatch::marks() const {
  std::vector<TileMark> marks;
  if (collector_.reads().empty()) return marks;
  const auto& site = checked_->site();
  floor::LaidTypes types{site};
  for (std::size_t n = 0; n < result_.states.size(); ++n) {
    const auto state = result_.states[n];
    if (state == tilecheck::TileState::Untouched) continue;
    const floor::TileType* type = types.find(site.placements[n], n);
    if (type == nullptr) continue;
    const Box box = floor::boxOf(site.placements[n], *type);
    marks.push_back({{box.low, box.high},
                     state == tilecheck::TileState::Confirmed ? TileMark::Kind::Confirmed
                     : state == tilecheck::TileState::Suspect ? TileMark::Kind::Suspect
                                                              : TileMark::Kind::Seen});
  }
  return marks;
}

SiteBox TileWatch::placeOf(const tilecheck::TileSuspect& suspect) const {
  SiteBox all;
  for (const auto& move : suspect.fix.moves) {
    const auto box = boxOfTile(*checked_, move.before);
    if (!box) return {};
    all.add(box->low);
    all.add(box->high);
  }
  return all;
}

Result<void> TileWatch::mend(const tilecheck::TileSuspect& suspect) {
  QStringList serials;
  for (const std::string& serial : suspect.serials) serials << QString::fromStdString(serial);
  return apply(tr("Correct how %1 lies").arg(serials.join(QStringLiteral(", "))),
               [&](floor::Site& site) { return tilecheck::relay(suspect.fix, site); });
}

Result<void> TileWatch::mend(const tilecheck::TagFinding& finding) {
  const tilecheck::PutUid fix = *finding.fix;
  return apply(tr("Register tag %1 of tile %2").arg(fix.position + 1).arg(QString::fromStdString(fix.serial)),
               [&](floor::Site& site) { return tilecheck::put(fix, site); });
}

Result<void> TileWatch::apply(const QString& name, const std::function<bool(floor::Site&)>& edit) {
  bool fits = false;
  const auto done = document_.edit(name, [&](floor::Site& site) { fits = edit(site); });
  if (!done) return done;
  if (!fits) return failure(phrase("Core", "The site was edited meanwhile: nothing was changed."));
  check();
  return {};
}

}  // namespace tessera::ui
