#include "app/tessera/magnetic_desk.h"

#include <utility>

#include "ui/base/wording.h"

namespace tessera::desktop {
namespace {

constexpr int kKeepEachMs = 60'000;

}  // namespace

MagneticDesk::MagneticDesk(ui::SiteDocument& document, FleetSession& session, Keeper& keeper, ui::FloorCanvas& canvas)
    : session_{session}, keeper_{keeper}, canvas_{canvas} {
  // The keeper heard of it before: its key is the new site's.
  connect(&document, &ui::SiteDocument::replaced, this, [this] {
    keep();
    open(keeper_.key(), false);
    if (session_.state() == FleetSession::State::Live) hand();
  });
  connect(&keeper, &Keeper::keyChanged, this, [this] {
    keep();
    key_ = keeper_.key();
    unkept_ = !map_->empty();
  });
  connect(&session, &FleetSession::stateChanged, this, &MagneticDesk::onSessionState);
  connect(&session, &ui::FleetLink::snapshotChanged, this, &MagneticDesk::onSnapshot);
  minute_.setInterval(kKeepEachMs);
  connect(&minute_, &QTimer::timeout, this, &MagneticDesk::keep);
  minute_.start();
}

MagneticDesk::~MagneticDesk() { keep(); }

void MagneticDesk::keep() {
  if (std::exchange(unkept_, false)) keeper_.keepMagneticMap(key_, simulated_, map_);
}

void MagneticDesk::open(const std::string& key, bool simulated) {
  key_ = key;
  simulated_ = simulated;
  auto kept = Keeper::magneticMap(key, simulated);
  if (!kept)
    Q_EMIT failed(tr("What was learned of the iron in this floor cannot be read and is begun anew: %1")
                      .arg(ui::text(kept.error().sentence)));
  show(kept && *kept ? *kept : std::make_shared<const locate::MagneticMap>());
}

void MagneticDesk::show(std::shared_ptr<const locate::MagneticMap> map) {
  map_ = std::move(map);
  canvas_.setMagneticMap(map_);
  Q_EMIT changed();
}

void MagneticDesk::onSessionState() {
  if (session_.state() != FleetSession::State::Live) return keep();
  // Simulated iron must not lead a vehicle over the real floor, nor the other way round.
  const bool simulated = session_.choice() && session_.choice()->kind == ui::ConnectionChoice::Kind::Demo;
  if (simulated != simulated_) {
    keep();
    open(key_, simulated);
  }
  hand();
}

void MagneticDesk::hand() {
  awaited_ = true;
  session_.post(supervisor::UseMagneticMap{map_});
}

void MagneticDesk::onSnapshot() {
  const auto picture = session_.latest();
  if (!picture || !picture->magnetic) return;
  if (picture->magnetic == map_) awaited_ = false;
  if (awaited_ || picture->magnetic == map_) return;
  unkept_ = true;
  show(picture->magnetic);
}

void MagneticDesk::forget() {
  show(std::make_shared<const locate::MagneticMap>());
  unkept_ = true;
  keep();
  if (session_.state() == FleetSession::State::Live) hand();
}

}  // namespace tessera::desktop
