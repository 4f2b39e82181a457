#include "sim/vehicle_body.h"

#include <utility>

namespace tessera::sim {
namespace {

// A ranger pings each 60 ms or slower: finer than this, distances need not follow the vehicle.
constexpr Seconds kRangingPeriod{0.01};

PlantParameters sized(PlantParameters plant, const floor::VehicleSetup& setup) {
  plant.wheelDiameter = setup.wheelDiameter;
  plant.track = setup.track;
  return plant;
}

}  // namespace

BodyParameters bodyParametersFor(const floor::VehicleSetup& setup) {
  BodyParameters body;
  body.plant = sized(body.plant, setup);
  body.readers.radius = setup.readerRadius;
  return body;
}

VehicleBody::VehicleBody(const VehicleWorldConfig& config, std::unique_ptr<VehicleHost> host)
    : id_{config.setup.id},
      plant_{sized(config.body.plant, config.setup), config.start, RandomStream{config.seed, "plant", id_.value}},
      compass_{config.body.compass, config.northToY, config.spots, RandomStream{config.seed, "compass", id_.value}},
      readers_{config.body.readers, config.setup.readers, config.map, config.seed, id_.value},
      rangers_{config.body.rangers, RandomStream{config.seed, "rangers", id_.value}},
      battery_{config.body.battery},
      scene_{config.scene},
      host_{std::move(host)} {}

Result<void> VehicleBody::start(Seconds now) {
  now_ = now;
  nextRanging_ = now;
  duty_ = {};
  fromVehicle_.clear();
  toVehicle_.clear();
  signals_.encoderCounts = plant_.encoderCounts();
  signals_.field = compass_.measure(pose());
  host_->setSignals(signals_);
  return host_->start(now);
}

void VehicleBody::step(Seconds now) {
  const Seconds dt = now - now_;
  if (dt.value() <= 0.0) return;
  now_ = now;
  plant_.step(dt, duty_, battery_.volts());
  battery_.step(dt, duty_);
  readers_.step(now, pose(), battery_.volts());

  signals_.encoderCounts = plant_.encoderCounts();
  signals_.field = compass_.measure(pose());
  if (now >= nextRanging_) {
    signals_.range = rangers_.measure(pose(), scene_);
    nextRanging_ = now + kRangingPeriod;
  }
  host_->setSignals(signals_);
  host_->fromReaders(readers_.take(now));
  host_->fromRadio(std::exchange(toVehicle_, {}));
  host_->advance(now);

  Actions actions = host_->take();
  duty_ = host_->running() ? actions.duty : std::array<int, 2>{};
  radioMode_ = actions.radioMode;
  readers_.receive(actions.toReaders, now);
  fromVehicle_.insert(fromVehicle_.end(), actions.toRadio.begin(), actions.toRadio.end());
}

std::vector<std::uint8_t> VehicleBody::takeRadioBytes() { return std::exchange(fromVehicle_, {}); }

void VehicleBody::giveRadioBytes(std::span<const std::uint8_t> bytes) {
  toVehicle_.insert(toVehicle_.end(), bytes.begin(), bytes.end());
}

}  // namespace tessera::sim
