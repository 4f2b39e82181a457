// Every message goes to bytes and back; every other length and every value that nobody sends is refused.
#include "wire/messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "wire/random_messages.h"

namespace tessera::wire {
namespace {

constexpr int kRounds = 20'000;

template <class Message>
std::vector<std::uint8_t> encoded(const Message& m) {
  std::vector<std::uint8_t> out(kMaxPayload - 4);
  out.resize(encode(m, out));
  return out;
}

// decode(encode(m)) == m, and every shorter or longer body is refused.
template <class Make, class Decode>
void roundTrips(std::size_t size, Make make, Decode decode) {
  Random random{size};
  for (int i = 0; i < kRounds; ++i) {
    const auto m = make(random);
    std::vector<std::uint8_t> bytes = encoded(m);
    ASSERT_EQ(bytes.size(), size);
    ASSERT_EQ(decode(bytes), m);
    if (i > 100) continue;
    for (std::size_t n = 0; n < bytes.size(); ++n) ASSERT_FALSE(decode(Bytes{bytes}.first(n))) << n;
    bytes.push_back(0);
    ASSERT_FALSE(decode(bytes));
    std::vector<std::uint8_t> small(size - 1);
    ASSERT_EQ(encode(m, small), 0U) << "does not fit";
  }
}

TEST(Messages, helloRoundTrips) { roundTrips(8, randomHello, decodeHello); }
TEST(Messages, identityRoundTrips) { roundTrips(17, randomIdentity, decodeIdentity); }
TEST(Messages, hailRoundTrips) { roundTrips(5, randomHail, decodeHail); }
TEST(Messages, valueRoundTrips) { roundTrips(8, randomValue, decodeValue); }

TEST(Messages, requestsRoundTrip) {
  Random random{3};
  for (int i = 0; i < kRounds; ++i) {
    const Request m = randomRequest(random);
    const auto bytes = encoded(m);
    ASSERT_EQ(bytes.size(), m.type == MessageType::Set ? 5U : 1U);
    ASSERT_EQ(decodeRequest(m.type, bytes), m);
    ASSERT_FALSE(decodeRequest(MessageType::Cycle, bytes));
    ASSERT_FALSE(decodeRequest(m.type == MessageType::Set ? MessageType::Get : MessageType::Set, bytes));
  }
}

TEST(Messages, reportsRoundTripWithTheirEvents) {
  Random random{4};
  std::size_t most = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Report m = randomReport(random);
    const auto bytes = encoded(m);
    std::size_t size = Report::kFixedSize;
    for (std::size_t k = 0; k < m.eventCount; ++k) size += wireSize(m.events[k]);
    ASSERT_EQ(bytes.size(), size);
    ASSERT_EQ(decodeReport(bytes), m);
    most = std::max<std::size_t>(most, m.eventCount);
    ASSERT_FALSE(decodeReport(Bytes{bytes}.first(bytes.size() - 1))) << "half an event, or half a report";
  }
  EXPECT_GE(most, 5U);
}

TEST(Messages, aReportOfTheLongestKindIsOnePacket) {
  Report m;
  m.eventCount = Report::kMaxEvents;  // thirteen departures of two bytes
  const auto body = encoded(m);
  ASSERT_EQ(body.size(), 45U);
  std::array<std::uint8_t, kMaxFrame> out{};
  EXPECT_EQ(sealFrame({}, 1, {0, 1, static_cast<std::uint8_t>(MessageType::Report), 0}, body, out), kMaxFrame);
  EXPECT_EQ(decodeReport(body), m);
}

TEST(Messages, aReportWhoseEventsDoNotFitIsNotWritten) {
  Report m;
  m.eventCount = 3;
  for (auto& e : m.events) e.kind = EventKind::Uid10;
  std::array<std::uint8_t, 200> out{};
  EXPECT_EQ(encode(m, out), 0U) << "3 x 12 bytes into 26";
  m.eventCount = 2;
  EXPECT_EQ(encode(m, out), 19U + 24U);
  m.eventCount = Report::kMaxEvents + 1;
  EXPECT_EQ(encode(m, out), 0U);
}

TEST(Messages, valuesThatNobodySendsAreRefused) {
  Report report;
  report.eventCount = 1;
  std::vector<std::uint8_t> bytes = encoded(report);
  for (unsigned state = 0; state < 256; ++state) {
    bytes[2] = static_cast<std::uint8_t>(state);
    EXPECT_EQ(decodeReport(bytes).has_value(), state <= 6);
  }
  bytes[2] = 0;
  bytes[19] = 0x40;  // an event of a fifth kind
  EXPECT_FALSE(decodeReport(bytes));
  bytes = encoded(Value{});
  for (unsigned outcome = 0; outcome < 256; ++outcome) {
    bytes[3] = static_cast<std::uint8_t>(outcome);
    EXPECT_EQ(decodeValue(bytes).has_value(), outcome <= 5);
  }
}

TEST(Messages, anythingAtAllIsDecodedOrRefused) {
  Random random{6};
  for (int i = 0; i < 200'000; ++i) {
    std::vector<std::uint8_t> bytes(random() % 60);
    for (auto& b : bytes) b = anyOf<std::uint8_t>(random);
    if (const auto m = decodeReport(bytes)) {
      ASSERT_EQ(encoded(*m), bytes);
    }
    if (const auto m = decodeIdentity(bytes)) {
      ASSERT_EQ(encoded(*m), bytes);
    }
    if (const auto m = decodeValue(bytes)) {
      ASSERT_EQ(encoded(*m), bytes);
    }
    if (const auto m = decodeRequest(MessageType::Set, bytes)) {
      ASSERT_EQ(encoded(*m), bytes);
    }
    static_cast<void>(findEntry(bytes, anyOf<std::uint8_t>(random)));
  }
}

}  // namespace
}  // namespace tessera::wire
