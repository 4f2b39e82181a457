// What must hold on every channel: any air rate and factor, any losses and delays, any number of vehicles.
#include <gtest/gtest.h>

#include <map>

#include "link/channel_fixture.h"

namespace tessera::link {
namespace {

using test::ChannelRig;
using test::FakeAir;

struct Case {
  std::uint8_t vehicles;
  double airRate;
  int baud;
  double factor;
  double loss;
  double jitter;  ///< ms
  std::uint32_t seed;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << int{c.vehicles} << " vehicles, " << c.airRate << " bit/s, factor " << c.factor << ", loss " << c.loss
             << ", jitter " << c.jitter << " ms";
}

class AnyChannel : public ::testing::TestWithParam<Case> {
protected:
  [[nodiscard]] static FakeAir::Options options() {
    const Case& c = GetParam();
    return {c.airRate, c.baud, c.factor, c.loss, Seconds{c.jitter / 1000}, c.seed};
  }
  // Time for a few dozen exchanges at this rate.
  [[nodiscard]] static Seconds span(double exchanges) {
    return Seconds{exchanges * 2.2 * GetParam().factor * wire::loRaAirtime(58, GetParam().airRate)};
  }
};

TEST_P(AnyChannel, connectsAndNeverSendsIntoAnotherTransmission) {
  ChannelRig rig{GetParam().vehicles, options()};
  rig.askEvery = Seconds{0.003};  // its holder may ask at any time
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, span(60) + Seconds{20}));
  for (std::uint8_t id = 1; id <= GetParam().vehicles; ++id) rig.drive(id);
  rig.run(span(200));
  EXPECT_EQ(rig.air->overlaps, 0U);
  EXPECT_GT(rig.count<Reported>(), 100U);
}

TEST_P(AnyChannel, servesEveryVehicleAlike) {
  ChannelRig rig{GetParam().vehicles, options()};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, span(60) + Seconds{20}));
  for (std::uint8_t id = 1; id <= GetParam().vehicles; ++id) rig.drive(id);
  std::map<int, std::size_t> sent;
  const std::size_t before = rig.events.size();
  rig.run(span(200));
  for (std::size_t i = before; i < rig.events.size(); ++i)
    if (const auto* c = std::get_if<CommandSent>(&rig.events[i])) ++sent[c->vehicle.value];
  std::size_t most = 0;
  std::size_t least = 1000000;
  for (std::uint8_t id = 1; id <= GetParam().vehicles; ++id) {
    most = std::max(most, sent[id]);
    least = std::min(least, sent[id]);
  }
  EXPECT_GT(least, 0U);
  EXPECT_LE(most - least, 2 + most / 10);
}

TEST_P(AnyChannel, tellsEveryTagEventOnceAndInOrder) {
  ChannelRig rig{GetParam().vehicles, options()};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, span(60) + Seconds{20}));
  for (std::uint8_t id = 1; id <= GetParam().vehicles; ++id) rig.drive(id);
  std::mt19937 random{GetParam().seed};
  std::uint8_t number = 0;
  for (int round = 0; round < 40; ++round) {
    for (auto k = random() % 3; k > 0; --k) rig.fake(1).read(0, {number++, 1, 2, 3}, rig.air->now);
    rig.run(span(2.5));
  }
  rig.runUntil([&] { return false; }, span(40));
  std::uint8_t expected = 0;
  for (const Reported& r : rig.all<Reported>()) {
    if (r.vehicle != VehicleId{1}) continue;
    for (const TimedTagEvent& t : r.tags) EXPECT_EQ(t.event.uid[0], expected++);
  }
  EXPECT_EQ(expected, number);
  EXPECT_EQ(rig.peer(1).quality.tagEventsLost, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Rates, AnyChannel,
    ::testing::Values(Case{1, 19200, 115200, 1.0, 0.0, 0, 1}, Case{1, 19200, 115200, 1.8, 0.02, 3, 2},
                      Case{3, 19200, 115200, 1.8, 0.02, 3, 3}, Case{4, 19200, 115200, 1.8, 0.05, 5, 4},
                      Case{5, 19200, 115200, 1.8, 0.02, 3, 5}, Case{9, 19200, 115200, 3.2, 0.1, 3, 6},
                      Case{4, 9600, 9600, 1.8, 0.02, 5, 7}, Case{2, 2400, 9600, 1.0, 0.02, 5, 8},
                      Case{2, 2400, 9600, 3.2, 0.02, 5, 9}, Case{2, 300, 9600, 1.8, 0.0, 5, 10}));

}  // namespace
}  // namespace tessera::link
