#include "sim/world.h"

#include <algorithm>
#include <cmath>

namespace tessera::sim {

namespace {

/// Of a step: an instant this little before the next one counts as that one.
constexpr double kRounding = 1e-6;
/// Steps between two looks of the rangers at each other's vehicles; they measure no faster.
constexpr std::uint64_t kSceneSteps = 10;
constexpr std::uint64_t kTruthSteps = 20;

std::string nameOf(VehicleId id) { return "vehicle " + std::to_string(id.value); }

}  // namespace

World::World(const WorldConfig& config)
    : config_{config},
      air_{config.air, RandomStream{config.seed, "air"}},
      host_{air_,
            E32Registers::of(config.radio.channel, airRateOf(config.radio.airRate).value_or(5), config.radio.baud),
            kStep},
      noise_{config.seed, "noise"},
      epoch_{config.start},
      time_{config.start} {}

World::~World() {
  for (auto& v : vehicles_) v->body->host().kill();
}

void World::add(std::unique_ptr<VehicleBody> vehicle, Metres extent) {
  auto added = std::unique_ptr<Vehicle>(new Vehicle{std::move(vehicle), E32{air_, E32Registers{}, kStep}, extent});
  added->radio.setPowered(false, time_);
  vehicles_.push_back(std::move(added));
  showObstacles();
}

Result<void> World::start(VehicleId id) {
  Vehicle* v = find(id);
  if (v == nullptr) return failure("The world has no " + nameOf(id) + ".");
  v->body->host().kill();
  v->radio.setPowered(false, time_);
  v->wanted = false;
  if (auto started = v->body->start(time_); !started)
    return failure("Cannot start " + nameOf(id) + ": " + started.error().sentence.english());
  v->wanted = true;
  v->radio.setPowered(true, time_);
  return {};
}

Result<void> World::startAll() {
  for (const VehicleId id : vehicles())
    if (auto started = start(id); !started) return started;
  return {};
}

void World::advance(Seconds now) {
  if (!std::isfinite(now.value())) return;
  const double due = (now - epoch_) / kStep + kRounding;
  while (static_cast<double>(steps_ + 1) <= due) {
    ++steps_;
    time_ = epoch_ + static_cast<double>(steps_) * kStep;
    step(time_);
  }
}

void World::skipTo(Seconds now) {
  if (!std::isfinite(now.value()) || now <= time_) return;
  epoch_ = now;
  time_ = now;
  steps_ = 0;
}

void World::step(Seconds now) {
  if (ticks_ % kSceneSteps == 0 && vehicles_.size() > 1) showObstacles();
  for (auto& v : vehicles_) stepVehicle(*v, now);
  host_.advance(now);
  deliver(now);
  if (ticks_ % kTruthSteps == 0) writeTruth();
  ++ticks_;
}

void World::stepVehicle(Vehicle& v, Seconds now) {
  VehicleBody& body = *v.body;
  body.setRadioReady(v.radio.ready());
  body.giveRadioBytes(v.radio.takeUart(now));
  body.step(now);
  const bool runs = body.host().running();
  if (v.wanted && !runs) {
    v.wanted = false;
    v.radio.setPowered(false, now);
    troubles_.push_back(nameOf(body.id()) + " ended by itself: " + body.host().trouble());
  }
  // Bytes come before a change of mode: a firmware lets its bytes leave before it changes the mode, and says nothing
  // until the change is over.
  const auto bytes = body.takeRadioBytes();
  if (!runs) return;
  v.radio.fromUart(bytes, now);
  v.radio.setMode(body.radioMode(), now);
  v.radio.advance(now);
}

void World::deliver(Seconds now) {
  for (const Air::Delivery& d : air_.settle(now)) {
    if (d.module == host_.module()) host_.receive(d.packet, d.at);
    for (auto& v : vehicles_)
      if (d.module == v->radio.module()) v->radio.receive(d.packet, d.at);
  }
}

void World::hostBytes(std::span<const std::uint8_t> bytes) {
  host_.fromUart(bytes.first(std::min(bytes.size(), hostRoom())), time_);
}

std::size_t World::hostRoom() const { return kPortRoom - std::min(kPortRoom, host_.onWire()); }

std::vector<std::uint8_t> World::takeHostBytes() { return host_.takeUart(time_); }

void World::setHostMode(firmware::RadioMode mode) { host_.setMode(mode, time_); }

World::Vehicle* World::find(VehicleId id) const {
  const auto it = std::find_if(vehicles_.begin(), vehicles_.end(), [&](const auto& v) { return v->body->id() == id; });
  return it == vehicles_.end() ? nullptr : it->get();
}

std::vector<VehicleId> World::vehicles() const {
  std::vector<VehicleId> ids;
  for (const auto& v : vehicles_) ids.push_back(v->body->id());
  return ids;
}

std::optional<TrueState> World::truth(VehicleId id) const {
  const Vehicle* v = find(id);
  if (v == nullptr) return std::nullopt;
  return TrueState{time_, id, v->body->pose(), v->body->speed(), v->body->turnRate()};
}

void World::writeTruth() {
  if (!truthLog_) return;
  for (const VehicleId id : vehicles()) {
    if (auto written = truthLog_->write(*truth(id)); !written) {
      troubles_.push_back(written.error().sentence);
      truthLog_.reset();
      return;
    }
  }
}

std::vector<std::string> World::takeTroubles() { return std::exchange(troubles_, {}); }

bool World::kill(VehicleId id) {
  Vehicle* v = find(id);
  if (v == nullptr) return false;
  v->wanted = false;
  v->body->host().kill();
  v->radio.setPowered(false, time_);
  return true;
}

bool World::running(VehicleId id) const {
  const Vehicle* v = find(id);
  return v != nullptr && v->body->host().running();
}

bool World::push(VehicleId id, Offset by, Radians turn) {
  Vehicle* v = find(id);
  if (v == nullptr) return false;
  const Pose pose = v->body->pose();
  v->body->setPose({pose.position + by, wrapped(pose.heading + turn)});
  return true;
}

void World::addObstacle(const Post& post) {
  obstacles_.push_back(post);
  showObstacles();
}

void World::clearObstacles() {
  obstacles_.clear();
  showObstacles();
}

void World::showObstacles() {
  for (auto& seer : vehicles_) {
    Scene scene = config_.scene;
    scene.posts.insert(scene.posts.end(), obstacles_.begin(), obstacles_.end());
    for (const auto& other : vehicles_)
      if (other != seer) scene.posts.push_back({other->body->pose().position, other->extent});
    seer->body->setScene(std::move(scene));
  }
}

void World::inject(std::span<const std::uint8_t> bytes) { air_.inject(host_.registers().tuning(), bytes); }

void World::noise(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(noise_.uniform() * 256);
  inject(bytes);
}

const E32* World::radio(VehicleId id) const {
  const Vehicle* v = find(id);
  return v == nullptr ? nullptr : &v->radio;
}

VehicleBody* World::body(VehicleId id) {
  Vehicle* v = find(id);
  return v == nullptr ? nullptr : v->body.get();
}

}  // namespace tessera::sim
