#include "sim/commission.h"

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "sim/air.h"
#include "sim/commission_bench.h"
#include "sim/native_host.h"

namespace tessera::sim {
namespace {

using wire::Parameter;

constexpr Seconds kCalibrationPatience{120.0};
constexpr Seconds kBenchPollPeriod{0.1};
constexpr int kCalibrations = 3;
constexpr Seconds kSavingTime{0.5};  // the firmware writes its settings behind its other work

int codeOf(std::span<const int> values, double wanted) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::lround(wanted) == values[i]) return static_cast<int>(i);
  return -1;
}

Result<void> calibrate(CommissionBench& bench) {
  const auto started =
      bench.request({wire::MessageType::Do, static_cast<std::uint8_t>(wire::Action::CalibrateCompass)});
  if (!started || started->outcome != wire::Outcome::Started)
    return failure("On the bench the vehicle did not begin to calibrate its compass.");
  const Seconds end = bench.now() + kCalibrationPatience;
  bool seen = false;
  while (bench.now() < end) {
    const auto report = bench.poll();
    bench.run(kBenchPollPeriod);
    if (!report) continue;
    if (report->state == wire::VehicleState::Faulted)
      return failure("On the bench the vehicle fell into fault " + std::to_string(report->faults) + ".");
    const bool calibrating = report->state == wire::VehicleState::Calibrating;
    if (seen && !calibrating) return {};
    seen = seen || calibrating;
  }
  return failure("On the bench the vehicle did not finish calibrating its compass.");
}

}  // namespace

Result<firmware::Settings> settingsFor(const floor::VehicleSetup& setup, const floor::RadioSetup& radio,
                                       const BodyParameters& body) {
  static constexpr std::array<int, 8> kBauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
  const std::array<std::pair<Parameter, double>, 11> values{{
      {Parameter::Address, setup.id.value},
      {Parameter::WheelDiameter, setup.wheelDiameter.value() * 1e6},
      {Parameter::TrackWidth, setup.track.value() * 1e6},
      {Parameter::CountsPerTurn, body.plant.countsPerTurn},
      {Parameter::MaxSpeed, setup.maxSpeed.value() * 1e3},
      {Parameter::MaxTurnRate, setup.maxTurnRate.value() * 1e3},
      {Parameter::Acceleration, setup.acceleration.value() * 1e3},
      {Parameter::ReaderCount, static_cast<double>(setup.readers.size())},
      {Parameter::RadioChannel, radio.channel},
      {Parameter::RadioAirRate, airRateOf(radio.airRate).value_or(-1)},
      {Parameter::RadioBaud, codeOf(kBauds, radio.baud)},
  }};
  firmware::Settings settings;
  settings.key = setup.key;
  for (const auto& [parameter, value] : values) {
    if (settings.set(parameter, static_cast<std::int32_t>(std::lround(value))) == wire::Outcome::Done) continue;
    return failure("Vehicle \"" + setup.name + "\" cannot take " + std::to_string(value) + " for parameter " +
                   std::to_string(static_cast<int>(parameter)) + ".");
  }
  if (body.headingLearning) {
    const auto length = static_cast<std::int32_t>(std::lround(body.headingLearning->value() * 1e3));
    if (settings.set(Parameter::HeadingLearning, length) != wire::Outcome::Done)
      return failure("Vehicle \"" + setup.name + "\" cannot learn over " + std::to_string(length) + " mm.");
  }
  return settings;
}

Result<EepromImage> commissionEeprom(const floor::VehicleSetup& setup, const floor::Site& site,
                                     const BodyParameters& body, std::uint64_t seed) {
  const auto settings = settingsFor(setup, site.radio, body);
  if (!settings) return tl::unexpected{settings.error()};
  VehicleWorldConfig config;
  config.setup = setup;
  config.body = body;
  // Nobody calibrates on a wet floor: the firmware turns by its wheels, and refuses what is not a whole turn then.
  config.body.plant.slip = 0.0;
  config.body.plant.speedNoise = 0.0;
  config.northToY = site.northToY;
  config.seed = seed;
  auto owned = std::make_unique<NativeHost>(firmware::makeEepromImage(*settings));
  NativeHost& host = *owned;
  VehicleBody vehicle{config, std::move(owned)};
  if (const auto started = vehicle.start(Seconds{}); !started) return tl::unexpected{started.error()};
  CommissionBench bench{vehicle, setup.key, Seconds{}};
  if (const auto identity = bench.open(); !identity) return tl::unexpected{identity.error()};
  // A vehicle with a noisy compass may refuse what it measured; whoever stands beside tries again.
  for (int turn = 0; turn < kCalibrations; ++turn) {
    if (const auto done = calibrate(bench); !done) return tl::unexpected{done.error()};
    bench.run(kSavingTime);
    const auto kept = firmware::settingsFromImage(host.eeprom());
    if (!kept || kept->get(Parameter::CompassOffsetX) == settings->get(Parameter::CompassOffsetX)) continue;
    host.kill();
    return host.eeprom();
  }
  return failure("On the bench vehicle \"" + setup.name + "\" kept no compass calibration in " +
                 std::to_string(kCalibrations) + " tries.");
}

}  // namespace tessera::sim
