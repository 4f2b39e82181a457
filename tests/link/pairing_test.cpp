// Another key for a vehicle, from the host's side: what is proved, what stays unknown, and how that ends.
#include <gtest/gtest.h>

#include "link/channel_fixture.h"

namespace tessera::link {
namespace {

using test::ChannelRig;
using test::FakeAir;
using test::keyOf;

const wire::Key kNew{0xC0, 0xC1, 0xC2};

class PairingOnAChannel : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{10}));
  }
  [[nodiscard]] std::vector<PairingEnd> ends() const {
    std::vector<PairingEnd> all;
    for (const auto& e : rig.all<PairingEnded>()) all.push_back(e.how);
    return all;
  }
  bool endsWith(PairingEnd how, Seconds within = Seconds{20}) {
    return rig.runUntil([&] { return !ends().empty() && ends().back() == how; }, within);
  }
  [[nodiscard]] const wire::Key& keyUsed() const { return rig.peer(1).session.longTermKey(); }
  bool answersAgain() {
    const auto reports = rig.peer(1).quality.reports;
    return rig.runUntil([&] { return rig.connected() && rig.peer(1).quality.reports > reports + 3; }, Seconds{20});
  }

  ChannelRig rig{2};
};

TEST_F(PairingOnAChannel, endsWithTheNewKeyAndANewSession) {
  ASSERT_TRUE(rig.channel->pair(VehicleId{1}, kNew));
  ASSERT_TRUE(endsWith(PairingEnd::NewKey, Seconds{2}));
  EXPECT_EQ(rig.fake(1).key, kNew);
  EXPECT_EQ(keyUsed(), kNew);
  EXPECT_TRUE(answersAgain());
  EXPECT_EQ(rig.fake(1).pairs, 1U);
  EXPECT_EQ(rig.count<WrongKey>(), 0U);
  EXPECT_EQ(rig.air->overlaps, 0U);
}

TEST_F(PairingOnAChannel, survivesEveryLoss) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    FakeAir::Options options;
    options.loss = 0.3;
    options.seed = seed;
    ChannelRig lossy{2, options};
    ASSERT_TRUE(lossy.runUntil([&] { return lossy.connected(); }, Seconds{60}));
    ASSERT_TRUE(lossy.channel->pair(VehicleId{1}, kNew) ||
                lossy.runUntil([&] { return lossy.channel->pair(VehicleId{1}, kNew); }, Seconds{10}));
    const auto settled = [&] {
      const auto all = lossy.all<PairingEnded>();
      return !all.empty() && all.back().how != PairingEnd::Unknown;
    };
    ASSERT_TRUE(lossy.runUntil(settled, Seconds{120})) << "seed " << seed;
    const PairingEnd end = lossy.all<PairingEnded>().back().how;
    EXPECT_EQ(lossy.fake(1).key, end == PairingEnd::NewKey ? kNew : keyOf(1)) << "seed " << seed;
    EXPECT_EQ(lossy.peer(1).session.longTermKey(), lossy.fake(1).key) << "seed " << seed;
    EXPECT_TRUE(lossy.runUntil([&] { return lossy.connected(); }, Seconds{60})) << "seed " << seed;
  }
}

TEST_F(PairingOnAChannel, findsOutWhenTheAnswerIsLost) {
  rig.fake(1).takesPairsInSilence = true;
  ASSERT_TRUE(rig.channel->pair(VehicleId{1}, kNew));
  ASSERT_TRUE(endsWith(PairingEnd::NewKey));
  EXPECT_EQ(keyUsed(), kNew);
  EXPECT_TRUE(answersAgain());
}

TEST_F(PairingOnAChannel, findsOutThatThePairWasNotHeard) {
  rig.fake(1).hearsNoPair = true;
  ASSERT_TRUE(rig.channel->pair(VehicleId{1}, kNew));
  ASSERT_TRUE(endsWith(PairingEnd::OldKey));
  EXPECT_EQ(ends(), (std::vector{PairingEnd::Unknown, PairingEnd::OldKey}));
  EXPECT_EQ(keyUsed(), keyOf(1));
  EXPECT_TRUE(answersAgain());
  EXPECT_FALSE(rig.peer(1).session.pairing());
}

TEST_F(PairingOnAChannel, callsWithBothKeysAfterAPowerCutAtTheWrongMoment) {
  for (const bool kept : {false, true}) {
    ChannelRig cut{1};
    ASSERT_TRUE(cut.runUntil([&] { return cut.connected(); }, Seconds{10}));
    cut.fake(1).hearsNoPair = true;
    ASSERT_TRUE(cut.channel->pair(VehicleId{1}, kNew));
    cut.run(Seconds{0.15});
    cut.fake(1).on = false;
    ASSERT_TRUE(cut.runUntil([&] { return cut.count<PairingEnded>() == 1; }, Seconds{10}));
    EXPECT_EQ(cut.all<PairingEnded>().back().how, PairingEnd::Unknown);
    cut.run(Seconds{5});
    cut.fake(1).restart();
    cut.fake(1).on = true;
    if (kept) cut.fake(1).key = kNew;
    ASSERT_TRUE(cut.runUntil([&] { return cut.count<PairingEnded>() == 2; }, Seconds{30})) << kept;
    EXPECT_EQ(cut.all<PairingEnded>().back().how, kept ? PairingEnd::NewKey : PairingEnd::OldKey);
    EXPECT_TRUE(cut.runUntil([&] { return cut.connected(); }, Seconds{10}));
  }
}

TEST_F(PairingOnAChannel, tellsARefusal) {
  for (const auto& [outcome, end] :
       {std::pair{wire::Outcome::Busy, PairingEnd::Busy}, std::pair{wire::Outcome::OutOfRange, PairingEnd::Garbled}}) {
    rig.fake(1).pairOutcome = outcome;
    ASSERT_TRUE(rig.channel->pair(VehicleId{1}, kNew));
    ASSERT_TRUE(endsWith(end, Seconds{2}));
    EXPECT_EQ(keyUsed(), keyOf(1));
    EXPECT_TRUE(answersAgain());
  }
  EXPECT_EQ(rig.count<Identified>(), 2U) << "the session went on";
}

TEST_F(PairingOnAChannel, keepsBothKeysForAVehicleWhoseMemoryFails) {
  rig.fake(1).pairOutcome = wire::Outcome::Failed;
  ASSERT_TRUE(rig.channel->pair(VehicleId{1}, kNew));
  ASSERT_TRUE(endsWith(PairingEnd::Failed, Seconds{2}));
  ASSERT_TRUE(answersAgain());
  rig.fake(1).restart();
  rig.fake(1).key = kNew;  // the write had done its work after all
  EXPECT_TRUE(endsWith(PairingEnd::NewKey, Seconds{30}));
}

TEST_F(PairingOnAChannel, triesAKeyThatAnEarlierHostHasOffered) {
  for (const bool has : {false, true}) {
    ChannelConfig config;
    config.vehicles.push_back({VehicleId{1}, keyOf(1), kNew});
    ChannelRig again{1};
    again.channel = std::make_unique<Channel>(config);
    again.channel->opened(again.air->now);
    if (has) again.fake(1).key = kNew;
    ASSERT_TRUE(again.runUntil([&] { return again.count<PairingEnded>() > 0; }, Seconds{20})) << has;
    EXPECT_EQ(again.all<PairingEnded>().back().how, has ? PairingEnd::NewKey : PairingEnd::OldKey);
  }
}

TEST_F(PairingOnAChannel, refusesAVehicleThatIsNotThereAndASecondPairing) {
  EXPECT_FALSE(rig.channel->pair(VehicleId{9}, kNew));
  ASSERT_TRUE(rig.channel->pair(VehicleId{1}, kNew));
  EXPECT_FALSE(rig.channel->pair(VehicleId{1}, kNew));
  rig.fake(2).on = false;
  ASSERT_TRUE(rig.runUntil([&] { return !rig.peer(2).connected(); }, Seconds{10}));
  EXPECT_FALSE(rig.channel->pair(VehicleId{2}, kNew));
}

// A stranger who knows no key repeats what was said while the pairing went on.
TEST_F(PairingOnAChannel, isNotMovedByReplays) {
  const auto said = [&] { return rig.air->vehicleFrames; };
  ASSERT_TRUE(rig.channel->pair(VehicleId{1}, kNew));
  ASSERT_TRUE(endsWith(PairingEnd::NewKey, Seconds{2}));
  ASSERT_TRUE(answersAgain());
  const wire::Key third{0x33};
  ASSERT_TRUE(rig.channel->pair(VehicleId{1}, third));
  for (const auto& [at, bytes] : said()) rig.air->inject(bytes, rig.air->now + Seconds{0.001});
  ASSERT_TRUE(endsWith(PairingEnd::NewKey));
  EXPECT_TRUE(rig.runUntil([&] { return keyUsed() == third; }, Seconds{10}));
  EXPECT_EQ(rig.fake(1).key, third);
}

}  // namespace
}  // namespace tessera::link
