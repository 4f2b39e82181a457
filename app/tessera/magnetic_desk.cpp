#include "app/tessera/magnetic_desk.h"

#include <utility>

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
  connect(&keeper, &Keeper::magneticMapLoaded, this, [this](quint64 request, const auto& map) {
    if (request == asked_) onLoaded(map);
  });
  connect(&keeper, &Keeper::requestFailed, this, [this](quint64 request, const QString& sentence) {
    if (request == asked_) onFailed(sentence);
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
  show(std::make_shared<const locate::MagneticMap>());
  askedKey_ = key;
  asked_ = keeper_.loadMagneticMap(key, simulated);
  if (asked_ == 0) onFailed(tr("The storage cannot be asked just now."));
}

void MagneticDesk::onLoaded(const std::shared_ptr<const locate::MagneticMap>& map) {
  asked_ = 0;
  if (map == nullptr || map->empty()) return;
  show(map);
  unkept_ = key_ != askedKey_;
  if (session_.state() == FleetSession::State::Live) hand();
}

void MagneticDesk::onFailed(const QString& sentence) {
  asked_ = 0;
  Q_EMIT failed(tr("What was learned of the iron in this floor cannot be read and is begun anew: %1").arg(sentence));
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
  // Learned before the stored map came, it would take that one's place.
  if (awaited_ || isLoading() || picture->magnetic == map_) return;
  unkept_ = true;
  show(picture->magnetic);
}

void MagneticDesk::forget() {
  asked_ = 0;
  show(std::make_shared<const locate::MagneticMap>());
  unkept_ = true;
  keep();
  if (session_.state() == FleetSession::State::Live) hand();
}

}  // namespace tessera::desktop
