#include "ui/calibrate/calibration.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "calibrate/figure.h"
#include "floor/laid_tile.h"

namespace tessera::ui {
namespace {

constexpr int kEstimateEveryMs = 1000;
constexpr int kRestFactor = 10;  // of the time, so that a long drive's estimate leaves nine tenths to the window
constexpr int kAskAgainMs = 500;
constexpr Metres kFigureMargin{0.30};
constexpr Radians kFigureTurn{0.35};  // no leg of it lies along rows of tags

std::optional<Box> boxOfFloor(const floor::Site& site) {
  std::unordered_map<std::string_view, const floor::TileType*> types;
  for (const floor::TileType& type : site.tileTypes) types.emplace(type.name, &type);
  std::unordered_map<std::string_view, const floor::TileType*> typeOf;
  for (const floor::Tile& tile : site.tiles)
    if (const auto type = types.find(tile.type); type != types.end()) typeOf.emplace(tile.serial, type->second);
  std::optional<Box> all;
  for (const floor::Placement& placement : site.placements) {
    const auto type = typeOf.find(placement.serial);
    if (type == typeOf.end()) continue;
    const Box box = floor::boxOf(placement, *type->second);
    all = all ? boxAround(*all, box) : box;
  }
  return all;
}

}  // namespace

Calibration::Calibration(FleetLink& fleet, SiteDocument& document) : fleet_{fleet}, document_{document} {
  soon_.setSingleShot(true);
  soon_.setInterval(kEstimateEveryMs);
  connect(&soon_, &QTimer::timeout, this, &Calibration::estimate);
  connect(&fleet_, &FleetLink::snapshotChanged, this, &Calibration::take);
  connect(&document_, &SiteDocument::replaced, this, [this] {
    stop();
    vehicle_.reset();
    clear();
  });
  connect(&document_, &SiteDocument::changed, this, [this] {
    // What was recorded of other readers or wheels says nothing of these.
    const floor::VehicleSetup* now = setup();
    const bool same = now != nullptr && against_ && now->readers == against_->readers &&
                      now->wheelDiameter == against_->wheelDiameter;
    if (against_ && !same) clear();
    Q_EMIT changed();
  });
}

const floor::VehicleSetup* Calibration::setup() const {
  return vehicle_ ? document_.map()->vehicle(*vehicle_) : nullptr;
}

void Calibration::start(VehicleId vehicle) {
  if (vehicle_ != vehicle) {
    vehicle_ = vehicle;
    clear();
  }
  const floor::VehicleSetup* now = setup();
  if (now == nullptr) return;
  against_ = *now;
  recording_ = true;
  asked_.invalidate();
  if (const auto snapshot = fleet_.latest()) askToWatch(*snapshot);
  Q_EMIT changed();
}

void Calibration::stop() {
  if (!recording_) return;
  recording_ = false;
  soon_.stop();
  estimate();
  // A locating view that is still looked at asks again by itself.
  if (fleet_.latest()) fleet_.post(supervisor::Watch{});
  Q_EMIT changed();
}

void Calibration::clear() {
  drive_.clear();
  lastRead_.reset();
  result_.reset();
  problem_ = {};
  against_.reset();
  if (recording_ && setup() != nullptr) against_ = *setup();
  Q_EMIT changed();
}

void Calibration::askToWatch(const supervisor::Snapshot& snapshot) {
  if (snapshot.find(*vehicle_) == nullptr || (asked_.isValid() && asked_.elapsed() < kAskAgainMs)) return;
  if (fleet_.post(supervisor::Watch{vehicle_})) asked_.start();
}

void Calibration::take() {
  const auto snapshot = fleet_.latest();
  if (!recording_ || !snapshot) return;
  if (!snapshot->watched || snapshot->watched->vehicle != vehicle_) return askToWatch(*snapshot);
  const locate::Motion& motion = snapshot->watched->motion;
  const auto& motions = drive_.motions();
  // Another supervision counts from elsewhere.
  if (!motions.empty() && motion.at < motions.back().at) clear();
  drive_.add(motion);
  for (const supervisor::ReadView& read : snapshot->find(*vehicle_)->recentReads) {
    if (read.at < drive_.motions().front().at || (lastRead_ && read.at <= *lastRead_)) continue;
    lastRead_ = read.at;
    if (read.place) drive_.add(calibrate::PlacedRead{read.reader, *read.place, read.at});
  }
  if (!soon_.isActive()) soon_.start();
}

void Calibration::estimate() {
  if (!against_ || drive_.motions().empty()) return;
  QElapsedTimer clock;
  clock.start();
  auto found = calibrate::calibrateReaders(drive_, *against_);
  result_.reset();
  problem_ = {};
  if (found) {
    result_ = std::move(*found);
  } else {
    problem_ = found.error().sentence;
  }
  soon_.setInterval(std::max(kEstimateEveryMs, static_cast<int>(kRestFactor * clock.elapsed())));
  Q_EMIT changed();
}

bool Calibration::isReady() const {
  return result_ && setup() != nullptr && calibrate::lacking(drive_, *result_) == calibrate::Lacking::Nothing;
}

bool Calibration::areWheelsReady() const { return isReady() && result_->wheelSigma < calibrate::kWellKnownScale; }

Result<void> Calibration::accept(bool wheels) {
  if (!isReady()) return {};
  wheels = wheels && areWheelsReady();
  const calibrate::Calibration found = *result_;
  const VehicleId id = *vehicle_;
  stop();
  return document_.edit(tr("Calibrate readers"), [&](floor::Site& site) {
    for (floor::VehicleSetup& v : site.vehicles) {
      if (v.id != id || v.readers.size() != found.readers.size()) continue;
      for (std::size_t r = 0; r < v.readers.size(); ++r) {
        if (!calibrate::isDetermined(found.readers[r])) continue;
        // To the tenth of a millimetre: nobody knows it better.
        const auto rounded = [](Metres m) { return Metres{std::round(m.value() * 1e4) / 1e4}; };
        v.readers[r] = {rounded(found.readers[r].mount.x), rounded(found.readers[r].mount.y)};
      }
      if (wheels) v.wheelDiameter = Metres{std::round(v.wheelDiameter.value() * found.wheelScale * 1e6) / 1e6};
    }
  });
}

Result<QString> Calibration::drawFigure() {
  const floor::Site& site = document_.site();
  const std::optional<Box> floor = boxOfFloor(site);
  if (!floor) return failure(phrase("Core", "No tiles are laid: there is nothing to drive over."));
  Point wish{0.5 * (floor->low.x + floor->high.x), 0.5 * (floor->low.y + floor->high.y)};
  const auto snapshot = fleet_.latest();
  const auto* seen = snapshot && vehicle_ ? snapshot->find(*vehicle_) : nullptr;
  if (seen != nullptr && seen->located) wish = seen->pose.position;
  const auto place = calibrate::placeFigure(*floor, wish, kFigureMargin);
  if (!place) return failure(phrase("Core", "The floor is too small for the figure: it needs 1.4 m by 1.4 m."));
  QString name = tr("Calibration", "name of a route");
  for (int n = 2; document_.map()->route(name.toStdString()) != nullptr; ++n)
    name = tr("Calibration %1", "name of a route").arg(n);
  floor::Route route;
  route.name = name.toStdString();
  route.vertices = calibrate::figure(place->centre, place->radius, kFigureTurn);
  const auto done =
      document_.edit(tr("Draw the calibration figure"), [&](floor::Site& s) { s.routes.push_back(route); });
  if (!done) return tl::unexpected{done.error()};
  return name;
}

}  // namespace tessera::ui
