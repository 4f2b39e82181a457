// Another key over the air, from the order to the EEPROM: firmware, paced and lossy radio, supervisor, in virtual time.
#include "wire/pairing.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "scenario/scenario.h"

namespace tessera::scenario {
namespace {

using link::PairingEnd;
using supervisor::EventKind;

const wire::Key kNew{0xC0, 0xC1, 0xC2, 0xC3, 0xC4, 0xC5, 0xC6, 0xC7, 0xC8, 0xC9, 0xCA, 0xCB, 0xCC, 0xCD, 0xCE, 0xCF};
constexpr VehicleId kOne{1};

std::vector<PairingEnd> endsOf(Scenario& scenario) {
  std::vector<PairingEnd> ends;
  for (const auto& e : scenario.recorder().events())
    if (e.kind == EventKind::Paired) ends.push_back(e.pairing.value());
  return ends;
}
bool settled(Scenario& scenario) {
  const auto ends = endsOf(scenario);
  return !ends.empty() && ends.back() != PairingEnd::Unknown;
}
bool inTouch(Scenario& scenario) {
  return scenario.view().contact == supervisor::Contact::Connected && scenario.view().link.reports > 0 &&
         scenario.view().link.age < Seconds{1};
}
std::size_t pairsOnTheAir(Scenario& scenario) {
  const auto& heard = scenario.world().tap().heard();
  return static_cast<std::size_t>(std::count_if(heard.begin(), heard.end(), [](const auto& packet) {
    return packet.size() > 4 && packet[4] == static_cast<std::uint8_t>(wire::MessageType::Pair);
  }));
}
void pairFirst(Scenario& scenario) {
  ASSERT_TRUE(scenario.until(Seconds{30}, [&] { return inTouch(scenario); })) << scenario.sentences();
  scenario.supervisor().post(supervisor::Pair{kOne, kNew});
}

TEST(Pairing, outlastsARestart) {
  Scenario scenario{{}};
  ASSERT_NO_FATAL_FAILURE(pairFirst(scenario));
  ASSERT_TRUE(scenario.until(Seconds{20}, [&] { return settled(scenario); })) << scenario.sentences();
  EXPECT_EQ(endsOf(scenario).back(), PairingEnd::NewKey) << scenario.sentences();
  ASSERT_TRUE(scenario.world().kill(kOne));
  ASSERT_TRUE(scenario.until(Seconds{20}, [&] { return !inTouch(scenario); }));
  ASSERT_TRUE(scenario.world().start(kOne));
  EXPECT_TRUE(scenario.until(Seconds{20}, [&] { return inTouch(scenario); })) << scenario.sentences();
  EXPECT_EQ(scenario.eventCount(EventKind::WrongKey), 0U) << scenario.sentences();
  scenario.supervisor().post(supervisor::RunRoute{kOne, "paper", MetresPerSecond{0.2}});
  EXPECT_TRUE(scenario.until(Seconds{60}, [&] { return scenario.view().progress > Metres{0.5}; }));
}

// The battery is pulled at every stage of it: before the vehicle has heard it, while it writes, when it has answered.
TEST(Pairing, leavesNoVehicleWithoutAKeyWhateverTheInstantOfAPowerCut) {
  int old = 0;
  int fresh = 0;
  for (int ms = 0; ms <= 120; ms += 8) {
    Scenario scenario{{}};
    ASSERT_NO_FATAL_FAILURE(pairFirst(scenario));
    ASSERT_TRUE(scenario.until(Seconds{20}, [&] { return pairsOnTheAir(scenario) > 0; }));
    scenario.go(Seconds{ms / 1000.0});
    ASSERT_TRUE(scenario.world().kill(kOne));
    scenario.go(Seconds{3});
    ASSERT_TRUE(scenario.world().start(kOne));
    ASSERT_TRUE(scenario.until(Seconds{60}, [&] { return settled(scenario) && inTouch(scenario); }))
        << ms << " ms\n"
        << scenario.sentences();
    const PairingEnd end = endsOf(scenario).back();
    EXPECT_TRUE(end == PairingEnd::NewKey || end == PairingEnd::OldKey) << ms << " ms\n" << scenario.sentences();
    ++(end == PairingEnd::NewKey ? fresh : old);
  }
  EXPECT_GT(old, 0) << "some cuts must come before it was kept";
  EXPECT_GT(fresh, 0) << "some cuts must come after";
}

TEST(Pairing, comesToItsEndOverABadRadio) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ScenarioSetup setup;
    setup.seed = seed;
    setup.world.drop = 0.3;
    setup.world.replay = 0.1;
    Scenario scenario{setup};
    ASSERT_NO_FATAL_FAILURE(pairFirst(scenario));
    ASSERT_TRUE(scenario.until(Seconds{120}, [&] { return settled(scenario) && inTouch(scenario); }))
        << scenario.sentences();
  }
}

TEST(Pairing, isRefusedForAVehicleWithAnotherKey) {
  ScenarioSetup setup;
  setup.wrongKey = true;
  Scenario scenario{setup};
  ASSERT_TRUE(scenario.until(Seconds{30}, [&] { return scenario.eventCount(EventKind::WrongKey) > 0; }));
  scenario.supervisor().post(supervisor::Pair{kOne, kNew});
  EXPECT_TRUE(scenario.until(Seconds{5}, [&] { return scenario.eventCount(EventKind::OrderRefused) > 0; }));
  EXPECT_EQ(pairsOnTheAir(scenario), 0U);
}

TEST(Pairing, isRefusedForAVehicleThatDrives) {
  Scenario scenario{{}};
  ASSERT_NO_FATAL_FAILURE(scenario.orderRoutes());
  ASSERT_TRUE(scenario.until(Seconds{30}, [&] { return scenario.view().progress > Metres{0.2}; }));
  scenario.supervisor().post(supervisor::Pair{kOne, kNew});
  EXPECT_TRUE(scenario.until(Seconds{5}, [&] { return scenario.eventCount(EventKind::OrderRefused) > 0; }))
      << scenario.sentences();
}

TEST(Pairing, isTakenUpByTheNextSupervisorThatKnowsWhichKeyWasOffered) {
  for (const bool taken : {false, true}) {
    ScenarioSetup setup;
    if (taken) setup.wrongKey = true;  // as if the vehicle had taken a key of which this host never heard the end
    const auto site = floor::loadSite(std::string{TESSERA_SITES} + "/paper.tessera.json").value();
    setup.offeredKeys = {{kOne, taken ? site.vehicles.front().key : kNew}};
    Scenario scenario{setup};
    ASSERT_TRUE(scenario.until(Seconds{30}, [&] { return settled(scenario); })) << scenario.sentences();
    EXPECT_EQ(endsOf(scenario).back(), taken ? PairingEnd::NewKey : PairingEnd::OldKey) << scenario.sentences();
    EXPECT_TRUE(scenario.until(Seconds{10}, [&] { return inTouch(scenario); }));
  }
}

// As in commissioning: the site's new vehicle has the factory key and address; it gets its own key, then its address.
TEST(AFreshVehicle, isFoundPairedAndGivenItsAddress) {
  constexpr VehicleId kFresh{254};
  ScenarioSetup setup;
  setup.change = [&](floor::Site& site) {
    site.vehicles.resize(1);
    site.vehicles[0].id = kFresh;
    site.vehicles[0].key = wire::kFactoryKey;
  };
  setup.assignments = {{kFresh, "paper"}};
  setup.world.fresh = {kFresh.value};
  Scenario scenario{setup};
  ASSERT_TRUE(scenario.until(Seconds{30}, [&] { return inTouch(scenario); })) << scenario.sentences();
  EXPECT_NE(scenario.view().faults & wire::kFaultEeprom, 0) << "it has no settings yet";
  scenario.supervisor().post(supervisor::Pair{kFresh, kNew});
  ASSERT_TRUE(scenario.until(Seconds{20}, [&] { return settled(scenario) && inTouch(scenario); }));
  EXPECT_EQ(endsOf(scenario).back(), PairingEnd::NewKey) << scenario.sentences();
  EXPECT_TRUE(scenario.until(Seconds{5}, [&] { return (scenario.view().faults & wire::kFaultEeprom) == 0; }));
  using wire::MessageType;
  scenario.supervisor().post(
      supervisor::Ask{kFresh, {MessageType::Set, static_cast<std::uint8_t>(wire::Parameter::Address), 17}});
  ASSERT_TRUE(scenario.until(Seconds{5}, [&] { return scenario.eventCount(EventKind::Answer) > 0; }));
  scenario.go(Seconds{0.2});
  scenario.world().kill(kFresh);
  ASSERT_TRUE(scenario.world().start(kFresh));
  scenario.go(Seconds{5});
  EXPECT_FALSE(inTouch(scenario)) << "it answers at 17 from now on";
}

}  // namespace
}  // namespace tessera::scenario
