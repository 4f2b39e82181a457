// The host foresees what the firmware makes of the commands under way: the firmware's own drive control, on a vehicle
// that does at once what is wanted, comes to where the predictor expects it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/angle.h"
#include "drive/predictor.h"
#include "firmware/vehicle/drive_control.h"

namespace tessera::firmware::test {
namespace {

constexpr double kTick = 0.01;  // s

class Ideal {
public:
  Ideal() { control_.configure({}); }
  void step(const drive::Command* command) {
    const Motion m = command != nullptr ? control_.hold(static_cast<float>(command->speed.value()),
                                                        static_cast<float>(-command->heading.value()),
                                                        static_cast<float>(-pose.heading.value()))
                                        : control_.stop();
    const double turn = static_cast<double>(m.turnRate) * kTick;
    const Radians middle = pose.heading + Radians{0.5 * turn};
    pose.position = pose.position + turned({Metres{static_cast<double>(m.speed) * kTick}, Metres{}}, middle);
    pose.heading = wrapped(pose.heading + Radians{turn});
    way += std::abs(static_cast<double>(m.speed)) * kTick;
  }
  Pose pose;
  double way = 0.0;

private:
  DriveControl control_;
};

std::vector<drive::TimedCommand> commandsFrom(std::mt19937& random) {
  std::uniform_real_distribution<double> share{0.0, 1.0};
  std::vector<drive::TimedCommand> commands;
  Seconds at{};
  Radians heading{};
  for (int n = 1 + static_cast<int>(random() % 4); n > 0; --n) {
    // From the vehicle's next breath to a far corner, standing ones and the usual small corrections among them.
    const double widest = random() % 2 == 0 ? 0.3 : 3.0;
    heading = wrapped(heading + Radians{widest * (share(random) - 0.5)});
    const bool stands = random() % 4 == 0;
    const double forwards = random() % 5 == 0 ? -1.0 : 1.0;
    const MetresPerSecond speed{stands ? 0.0 : forwards * (0.05 + 0.4 * share(random))};
    const Seconds until = at + Seconds{std::round(100.0 * (0.1 + 1.1 * share(random))) * kTick};
    commands.push_back({{speed, heading}, at, until});
    at = until;
  }
  return commands;
}

TEST(Foresight, isWhatTheFirmwareDoes) {
  std::mt19937 random{7};
  drive::VehicleAbility ability = drive::abilityOf({});
  ability.usualLag = Seconds{1e-3};
  double missed = 0.0;
  double driven = 0.0;
  for (int run = 0; run < 400; ++run) {
    const auto commands = commandsFrom(random);
    const Seconds end = std::min(commands.back().until + Seconds{0.3}, Seconds{4.9});
    Ideal vehicle;
    drive::VehicleState state;
    for (int tick = 0; tick < static_cast<int>(std::lround(end.value() / kTick)); ++tick) {
      const Seconds now{(tick + 0.5) * kTick};
      const drive::TimedCommand* inForce = nullptr;
      for (const drive::TimedCommand& c : commands)
        if (c.from <= now && now < c.until) inForce = &c;
      vehicle.step(inForce != nullptr ? &inForce->command : nullptr);
      // In parts, as from report to report.
      if (tick % 37 == 36) state = drive::predict(state, commands, Seconds{(tick + 1) * kTick}, ability);
    }
    state = drive::predict(state, commands, end, ability);
    const double miss = distance(state.pose.position, vehicle.pose.position).value();
    EXPECT_LT(miss, 0.012 + 0.03 * vehicle.way) << "run " << run;
    EXPECT_NEAR(turnBetween(state.pose.heading, vehicle.pose.heading).value(), 0.0, 0.05) << "run " << run;
    missed += miss;
    driven += vehicle.way;
  }
  EXPECT_GT(driven, 50.0);
  EXPECT_LT(missed, 0.01 * driven);
}

}  // namespace
}  // namespace tessera::firmware::test
