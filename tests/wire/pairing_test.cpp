#include "wire/pairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tessera::wire {
namespace {

constexpr Key kPresent{0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F};
constexpr Key kFresh{0xC0, 0xC1, 0xC2, 0xC3, 0xC4, 0xC5, 0xC6, 0xC7, 0xC8, 0xC9, 0xCA, 0xCB, 0xCC, 0xCD, 0xCE, 0xCF};
constexpr PairingNonce kNonce{{0x1A2B3C4D, 42, 1}, 1006};

TEST(Pairing, bringsTheNewKeyToWhoHasThePresentOne) {
  EXPECT_EQ(openPair(makePair(kPresent, kFresh, kNonce), kPresent, kNonce), kFresh);
  EXPECT_EQ(openPair(makePair(kFactoryKey, kFresh, kNonce), kFactoryKey, kNonce), kFresh);
}

TEST(Pairing, keepsTheNewKeyFromWhoHasNot) {
  Key other = kPresent;
  other[15] ^= 1;
  const Pair pair = makePair(kPresent, kFresh, kNonce);
  EXPECT_FALSE(openPair(pair, other, kNonce));
  EXPECT_NE(pair.masked, kFresh) << "it does not travel openly";
}

TEST(Pairing, isWorthNothingInAnotherSessionOrUnderAnotherCounter) {
  const Pair pair = makePair(kPresent, kFresh, kNonce);
  for (auto change : {+[](PairingNonce& n) { ++n.session.host; }, +[](PairingNonce& n) { ++n.session.boot; },
                      +[](PairingNonce& n) { ++n.session.hello; }, +[](PairingNonce& n) { ++n.counter; }}) {
    PairingNonce other = kNonce;
    change(other);
    EXPECT_FALSE(openPair(pair, kPresent, other));
  }
}

TEST(Pairing, noticesEveryChangedBit) {
  std::array<std::uint8_t, 24> body{};
  ASSERT_EQ(encode(makePair(kPresent, kFresh, kNonce), body), body.size());
  for (std::size_t bit = 0; bit < 8 * body.size(); ++bit) {
    auto changed = body;
    changed[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    const auto pair = decodePair(changed);
    ASSERT_TRUE(pair);
    EXPECT_FALSE(openPair(*pair, kPresent, kNonce)) << "bit " << bit;
  }
}

// Two new keys under one mask would give their difference away.
TEST(Pairing, masksEachFrameWithAnotherStream) {
  std::set<Key> seen;
  for (std::uint32_t counter = 0; counter < 100; ++counter) {
    PairingNonce nonce = kNonce;
    nonce.counter = counter;
    seen.insert(makePair(kPresent, kFresh, nonce).masked);
  }
  EXPECT_EQ(seen.size(), 100U);
}

// Mask and proof come of different words, so that giving a vehicle the key that it has betrays nothing of it.
TEST(Pairing, hidesAKeyThatStays) {
  const Pair pair = makePair(kPresent, kPresent, kNonce);
  std::array<std::uint8_t, 8> head{};
  for (std::size_t i = 0; i < head.size(); ++i) head[i] = static_cast<std::uint8_t>(pair.masked[i] ^ pair.proof[i]);
  EXPECT_FALSE(std::equal(head.begin(), head.end(), kPresent.begin()));
  EXPECT_EQ(openPair(pair, kPresent, kNonce), kPresent);
}

TEST(Pairing, messagesFitAPacketAndRefuseOtherLengths) {
  std::array<std::uint8_t, kMaxPayload> body{};
  EXPECT_EQ(encode(Pair{}, body), 24U);
  EXPECT_EQ(encode(Paired{}, body), 9U);
  for (std::size_t size = 0; size <= 40; ++size) {
    EXPECT_EQ(decodePair(Bytes{body}.first(size)).has_value(), size == 24) << size;
    EXPECT_EQ(decodePaired(Bytes{body}.first(size)).has_value(), size == 9) << size;
  }
  const Paired paired{0x11223344, 0x55667788, Outcome::Failed};
  EXPECT_EQ(decodePaired(Bytes{body}.first(encode(paired, body))), paired);
  body[8] = 6;
  EXPECT_FALSE(decodePaired(Bytes{body}.first(9))) << "no such outcome";
}

}  // namespace
}  // namespace tessera::wire
