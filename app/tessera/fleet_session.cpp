#include "app/tessera/fleet_session.h"

#include <QRandomGenerator>
#include <QTemporaryDir>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/world/world_options.h"
#include "floor/site_json.h"
#include "supervisor/site_change.h"
#include "ui/base/wording.h"

namespace tessera::desktop {
namespace {

constexpr int kLookMs = 50;
constexpr int kEditMs = 200;
constexpr int kPatienceMs = 3000;  // a vehicle out of reach stops by itself; nobody waits for it longer

}  // namespace

host::PortChoice portChoiceOf(const ui::ConnectionChoice& choice, const QString& port, int baud) {
  switch (choice.kind) {
    case ui::ConnectionChoice::Kind::Tcp:
      return {host::PortChoice::Tcp{choice.host, choice.tcpPort}};
    case ui::ConnectionChoice::Kind::Serial:
      return {host::PortChoice::Serial{choice.port, choice.baud}};
    case ui::ConnectionChoice::Kind::Demo:
      break;
  }
  return {host::PortChoice::Serial{port, baud}};
}

FleetSession::FleetSession(QObject* parent) : ui::FleetLink{parent} {
  editing_.setSingleShot(true);
  editing_.setInterval(kEditMs);
  connect(&editing_, &QTimer::timeout, this, &FleetSession::passSiteOn);
  stopping_.setInterval(kLookMs);
  connect(&stopping_, &QTimer::timeout, this, &FleetSession::lookWhetherStopped);
}

FleetSession::~FleetSession() { close(); }

std::shared_ptr<const supervisor::Snapshot> FleetSession::latest() const {
  return thread_ && !outdated_ ? thread_->latest() : nullptr;
}

bool FleetSession::post(supervisor::Order order) {
  const bool stops =
      std::holds_alternative<supervisor::Stop>(order) || std::holds_alternative<supervisor::StopAll>(order);
  if (outdated_ && !stops) return false;
  if (const auto* pair = std::get_if<supervisor::Pair>(&order)) {
    if (const auto kept = keys_.add(pair->vehicle, pair->newKey); !kept) {
      Q_EMIT failed(ui::text(kept.error().sentence));
      return false;
    }
    offered_[pair->vehicle] = pair->newKey;
  }
  // An order may name a route that was drawn just now.
  if (editing_.isActive()) passSiteOn();
  return thread_ && thread_->post(std::move(order));
}

bool FleetSession::refuses(const floor::SiteMap& map) {
  if (map.contradictions().empty()) return false;
  next_.reset();
  editing_.stop();
  beginEnd();
  Q_EMIT failed(
      tr("No vehicle is supervised with a site that contradicts itself: %1 Mend it first, in the panel Faults.")
          .arg(ui::text(map.contradictions().front().sentence)));
  return true;
}

void FleetSession::connectTo(const ui::ConnectionChoice& choice, std::shared_ptr<const floor::SiteMap> map) {
  map_ = std::move(map);
  if (refuses(*map_)) return;
  if (state_ != State::Off) {
    next_ = choice;
    beginEnd();
    return;
  }
  choice_ = choice;
  if (choice.kind == ui::ConnectionChoice::Kind::Demo)
    startWorld();
  else
    supervise(portChoiceOf(choice, choice.port, map_->site().radio.baud));
}

void FleetSession::disconnectGently() {
  next_.reset();
  beginEnd();
}

void FleetSession::beginEnd() {
  if (state_ == State::Stopping || state_ == State::Off) return;
  if (state_ == State::Starting || state_ == State::Resting) {
    finish();
    return;
  }
  FleetSession::post(supervisor::StopAll{});
  patience_ = kPatienceMs;
  setState(State::Stopping);
  stopping_.start();
}

QStringList FleetSession::close() {
  stopping_.stop();
  next_.reset();
  QStringList moving;
  if (thread_) moving = unconfirmed(thread_->close());
  finish();
  return moving;
}

// The supervision waits for none that is out of reach; yet the last that was heard of it may be that it drove.
QStringList FleetSession::unconfirmed(bool stood) const {
  QStringList names;
  const auto picture = thread_->latest();
  if (!picture) return names;
  const bool open = picture->port.state == supervisor::PortState::Open;
  for (const supervisor::VehicleView& v : picture->vehicles) {
    const bool confirmed = stood && open && v.contact == supervisor::Contact::Connected;
    if (v.command && v.command->status != supervisor::CommandStatus::Done && !confirmed)
      names.push_back(QString::fromStdString(v.name));
  }
  return names;
}

void FleetSession::useSite(std::shared_ptr<const floor::SiteMap> map) {
  const bool same = map_ && goesOnWith(map->site());
  map_ = std::move(map);
  if (state_ == State::Off || state_ == State::Stopping || refuses(*map_) || state_ == State::Resting) return;
  if (!same) {
    outdated_ = true;
    connectTo(*choice_, map_);
    Q_EMIT snapshotChanged();
  } else if (!editing_.isActive()) {
    editing_.start();
  }
}

// A vehicle that was paired stands in the site with its new key.
bool FleetSession::goesOnWith(const floor::Site& site) const {
  std::vector<floor::VehicleSetup> vehicles = map_->site().vehicles;
  for (auto& was : vehicles) {
    const auto is =
        std::find_if(site.vehicles.begin(), site.vehicles.end(), [&](const auto& v) { return v.id == was.id; });
    const auto key = offered_.find(was.id);
    if (is != site.vehicles.end() && key != offered_.end() && is->key == key->second) was.key = is->key;
  }
  return supervisor::sameFleet(map_->site().radio, vehicles, site);
}

std::optional<wire::Key> FleetSession::offeredKey(VehicleId vehicle) const {
  const auto found = offered_.find(vehicle);
  return found == offered_.end() ? std::nullopt : std::optional{found->second};
}

void FleetSession::passSiteOn() {
  editing_.stop();
  if (thread_) thread_->post(supervisor::UseSite{map_});
}

std::optional<host::PortChoice> FleetSession::rest() {
  if (state_ != State::Live) return std::nullopt;
  endThread();
  setState(State::Resting);
  Q_EMIT snapshotChanged();
  return port_;
}

void FleetSession::resume() {
  if (state_ == State::Resting) supervise(host::PortChoice{*port_});
}

Seconds FleetSession::liveFor() const { return thread_ ? host::steadyNow() - since_ : Seconds{}; }

void FleetSession::endThread() {
  editing_.stop();
  if (!thread_) return;
  thread_->close();
  const auto events = thread_->takeEvents();
  thread_.reset();
  if (!events.empty()) Q_EMIT eventsArrived(events);
}

void FleetSession::tellWorld(const std::string& line) {
  if (world_) world_->command(line);
}

void FleetSession::startWorld() {
  setState(State::Starting);
  folder_ = std::make_unique<QTemporaryDir>();
  const auto file = std::filesystem::path{folder_->path().toStdString()} / "site.tessera.json";
  if (const auto saved = floor::saveSite(map_->site(), file); !saved) {
    Q_EMIT failed(ui::text(saved.error().sentence));
    finish();
    return;
  }
  world::WorldOptions options;
  options.site = file.string();
  options.kind = emulated_ ? world::Kind::Qemu : world::Kind::Native;
  auto words = world::worldArguments(options);
  words.emplace_back("--with-parent");
  // A name that stays when the port is pulled and plugged in again.
  const QString port = folder_->filePath(QStringLiteral("radio"));
  words.insert(words.end(), {"--link", port.toStdString()});
  world_ = std::make_unique<process::WorldProcess>();
  connect(world_.get(), &process::WorldProcess::ready, this,
          [this, port] { supervise(portChoiceOf(*choice_, port, map_->site().radio.baud)); });
  connect(world_.get(), &process::WorldProcess::answered, this, &FleetSession::worldAnswered);
  connect(world_.get(), &process::WorldProcess::complained, this, &FleetSession::worldComplained);
  // Not from within the process' own signal: it ends there.
  connect(world_.get(), &process::WorldProcess::died, this, &FleetSession::onWorldDied, Qt::QueuedConnection);
  world_->begin(words);
}

void FleetSession::supervise(const host::PortChoice& port) {
  supervisor::Config config;
  // Nonces must never come twice; a seeded run would repeat the last one's.
  config.seed = QRandomGenerator::system()->generate64();
  config.byMagneticMap = true;
  config.offeredKeys = offered_ = keys_.unknownTo(map_->site());
  auto supervisor = supervisor::Supervisor::create(map_, config);
  if (!supervisor) {
    Q_EMIT failed(ui::text(supervisor.error().sentence));
    finish();
    return;
  }
  thread_ = std::make_unique<host::SupervisorThread>(std::move(*supervisor), port);
  port_ = port;
  since_ = host::steadyNow();
  connect(thread_.get(), &host::SupervisorThread::snapshotChanged, this, &FleetSession::snapshotChanged);
  connect(thread_.get(), &host::SupervisorThread::eventsArrived, this, [this] {
    if (!thread_) return;
    const auto events = thread_->takeEvents();
    if (!events.empty()) Q_EMIT eventsArrived(events);
  });
  thread_->start();
  setState(State::Live);
}

void FleetSession::lookWhetherStopped() {
  patience_ -= kLookMs;
  if (patience_ > 0 && !allStand()) return;
  stopping_.stop();
  finish();
}

bool FleetSession::allStand() const {
  const auto picture = thread_ ? thread_->latest() : nullptr;
  if (!picture || picture->port.state != supervisor::PortState::Open) return true;
  return std::all_of(picture->vehicles.begin(), picture->vehicles.end(), [](const supervisor::VehicleView& v) {
    return v.contact != supervisor::Contact::Connected || (v.command && v.command->mode == wire::CommandMode::Stop &&
                                                           v.command->status == supervisor::CommandStatus::Done);
  });
}

void FleetSession::finish() {
  if (state_ == State::Off) return;
  endThread();
  outdated_ = false;
  offered_.clear();
  if (world_) world_.release()->deleteLater();
  port_.reset();
  folder_.reset();
  setState(State::Off);
  Q_EMIT snapshotChanged();
  if (!next_) return;
  const auto next = *std::exchange(next_, std::nullopt);
  connectTo(next, map_);
}

void FleetSession::onWorldDied(const QString& sentence) {
  Q_EMIT failed(sentence);
  close();
}

void FleetSession::setState(State state) {
  if (state == state_) return;
  state_ = state;
  Q_EMIT stateChanged();
}

}  // namespace tessera::desktop
