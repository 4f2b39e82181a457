// Another key over the air, as the vehicle takes it: kept before it is answered, never neither, never by a stranger.
#include <gtest/gtest.h>

#include "tests/firmware/vehicle_bench.h"

namespace tessera::firmware::test {
namespace {

using wire::Outcome;

const wire::Key kNew{0xC0, 0xC1, 0xC2, 0xC3, 0xC4, 0xC5, 0xC6, 0xC7, 0xC8, 0xC9, 0xCA, 0xCB, 0xCC, 0xCD, 0xCE, 0xCF};
const wire::Key kOther{0x77};
constexpr int kKeepingMs = 120;

class PairingTest : public ::testing::Test {
protected:
  wire::Key kept() { return settingsFromImage(bench.board.memory.cells)->key; }
  void pair(const wire::Key& key) {
    bench.host.paired.reset();
    bench.send(bench.host.pair(key));
    bench.run(kKeepingMs);
  }
  bool answersTo(const wire::Key& key) {
    bench.host.useKey(key);
    bench.host.identity.reset();
    bench.say(bench.host.hello(++nonce));
    return bench.host.identity.has_value();
  }
  VehicleBench bench;
  std::uint32_t nonce = 1000;
};

TEST_F(PairingTest, keepsTheNewKeyAndAnswersUnderIt) {
  ASSERT_TRUE(bench.open());
  pair(kNew);
  ASSERT_TRUE(bench.host.paired);
  EXPECT_TRUE(bench.host.pairedUnderNewKey);
  EXPECT_EQ(*bench.host.paired, (wire::Paired{1, bench.host.counter(), Outcome::Done}));
  EXPECT_EQ(kept(), kNew);
  EXPECT_FALSE(answersTo(VehicleBench::kKey)) << "the old key is worth nothing";
  EXPECT_TRUE(answersTo(kNew));
  bench.switchOn();
  bench.run(200);
  EXPECT_TRUE(answersTo(kNew)) << "after a start as well";
}

TEST_F(PairingTest, obeysNothingOfTheSessionThatBroughtTheKey) {
  ASSERT_TRUE(bench.open());
  pair(kNew);
  bench.host.report.reset();
  bench.host.hail.reset();
  bench.host.useKey(kNew);
  bench.say(bench.host.poll());
  EXPECT_FALSE(bench.host.report);
  EXPECT_TRUE(bench.host.hail) << "says under the new key that it has no session";
}

TEST_F(PairingTest, answersAPairThatIsRepeatedWithoutWritingAgain) {
  ASSERT_TRUE(bench.open());
  pair(kNew);
  const auto cells = bench.board.memory.cells;
  bench.host.paired.reset();
  pair(kNew);
  ASSERT_TRUE(bench.host.paired) << "the first answer may have been lost";
  EXPECT_EQ(bench.host.paired->outcome, Outcome::Done);
  EXPECT_EQ(bench.host.paired->ack, bench.host.counter());
  EXPECT_EQ(bench.board.memory.cells, cells);
}

TEST_F(PairingTest, takesNoThirdKeyInTheFormerSession) {
  ASSERT_TRUE(bench.open());
  pair(kNew);
  pair(kOther);
  EXPECT_FALSE(bench.host.paired);
  EXPECT_EQ(kept(), kNew);
}

TEST_F(PairingTest, refusesAReplay) {
  ASSERT_TRUE(bench.open());
  const auto recorded = bench.host.pair(kNew);
  bench.send(recorded);
  bench.run(kKeepingMs);
  bench.host.useKey(kNew);
  bench.say(bench.host.hello(2));
  bench.say(bench.host.poll());
  bench.host.paired.reset();
  pair(kOther);
  ASSERT_EQ(kept(), kOther);
  bench.host.paired.reset();
  bench.send(recorded);
  bench.run(kKeepingMs);
  EXPECT_FALSE(bench.host.paired);
  EXPECT_EQ(kept(), kOther);
}

TEST_F(PairingTest, isDeafToWhoDoesNotHaveThePresentKey) {
  ASSERT_TRUE(bench.open());
  const auto before = bench.board.memory.cells;
  TestHost stranger{VehicleBench::kAddress, kOther};
  stranger.identity = wire::Identity{};  // makes its Pair under a session that there is not
  bench.send(stranger.pair(kOther));
  bench.run(kKeepingMs);
  EXPECT_FALSE(bench.host.paired);
  EXPECT_EQ(bench.board.memory.cells, before);
  bench.say(bench.host.poll());
  EXPECT_NE(bench.host.report->faults & wire::kFaultForged, 0);
}

TEST_F(PairingTest, takesNoKeyWhileItDrives) {
  ASSERT_TRUE(bench.open());
  bench.drive(200, 0.0, 1000);
  pair(kNew);
  ASSERT_TRUE(bench.host.paired);
  EXPECT_EQ(bench.host.paired->outcome, Outcome::Busy);
  EXPECT_FALSE(bench.host.pairedUnderNewKey);
  EXPECT_EQ(kept(), VehicleBench::kKey);
}

TEST_F(PairingTest, saysUnderTheOldKeyThatItCouldNotKeepTheNewOne) {
  ASSERT_TRUE(bench.open());
  bench.board.memory.present = false;
  bench.send(bench.host.pair(kNew));
  bench.run(3000);
  bench.board.memory.present = true;
  ASSERT_TRUE(bench.host.paired);
  EXPECT_EQ(bench.host.paired->outcome, Outcome::Failed);
  EXPECT_FALSE(bench.host.pairedUnderNewKey);
  EXPECT_TRUE(answersTo(VehicleBench::kKey));
}

// Whatever byte the power goes at: the next start has the old key or the new one, whole, and all other settings.
TEST(PairingPowerCut, leavesTheOldKeyOrTheNewOne) {
  bool completed = false;
  bool old = false;
  for (std::size_t cut = 0; cut < 160; cut += 3) {
    VehicleBench bench;
    ASSERT_TRUE(bench.open());
    bench.board.memory.bytesToPowerCut = cut;
    bench.send(bench.host.pair(kNew));
    bench.run(kKeepingMs);
    const bool told = bench.host.paired && bench.host.paired->outcome == Outcome::Done;
    if (!bench.board.memory.powerCut) completed = true;
    bench.board.memory.powerCut = false;
    bench.switchOn();
    bench.run(200);
    const auto settings = settingsFromImage(bench.board.memory.cells);
    ASSERT_TRUE(settings) << "cut after byte " << cut;
    EXPECT_EQ(settings->get(wire::Parameter::Address), VehicleBench::kAddress);
    const bool isNew = settings->key == kNew;
    EXPECT_TRUE(isNew || settings->key == VehicleBench::kKey) << "cut after byte " << cut;
    EXPECT_TRUE(isNew || !told) << "what was confirmed has been kept";
    old = old || !isNew;
    bench.host.useKey(settings->key);
    bench.host.identity.reset();
    bench.say(bench.host.hello(99));
    EXPECT_TRUE(bench.host.identity) << "cut after byte " << cut;
  }
  EXPECT_TRUE(completed && old) << "the cuts reach from before the record to past its end";
}

TEST(PairingFactory, aVehicleWithAnEmptyEepromIsFoundUnderTheFactoryKeyAndPaired) {
  VehicleBench bench;
  bench.board.memory.cells.fill(0xFF);
  bench.switchOn();
  bench.host = TestHost{kUncommissionedAddress, wire::kFactoryKey};
  ASSERT_TRUE(bench.open());
  bench.send(bench.host.pair(kNew));
  bench.run(kKeepingMs);
  ASSERT_TRUE(bench.host.paired);
  EXPECT_TRUE(bench.host.pairedUnderNewKey);
  EXPECT_EQ(settingsFromImage(bench.board.memory.cells)->key, kNew);
}

}  // namespace
}  // namespace tessera::firmware::test
