// The small parts of a vehicle's agent.
#include <gtest/gtest.h>

#include "supervisor/episode.h"
#include "supervisor/odometer.h"
#include "supervisor/parameter_texts.h"
#include "supervisor/sentences.h"

namespace tessera::supervisor {
namespace {

TEST(Odometer, unwrapsBothWays) {
  Odometer odometer;
  EXPECT_EQ(odometer.add(65000), Metres{0.0});
  EXPECT_NEAR(odometer.add(464).value(), 1.0, 1e-9);
  EXPECT_NEAR(odometer.add(64536).value(), -0.464, 1e-9);
}

TEST(Odometer, keepsTheWayWhenTheVehicleCountsAnew) {
  Odometer odometer;
  (void)odometer.add(0);
  (void)odometer.add(5000);
  odometer.restart();
  EXPECT_NEAR(odometer.add(0).value(), 5.0, 1e-9);
  EXPECT_NEAR(odometer.add(200).value(), 5.2, 1e-9);
}

TEST(Episode, beginsOnceAndEndsOnceAfterItsQuiet) {
  using Change = Episode::Change;
  Episode episode{Seconds{5.0}};
  EXPECT_EQ(episode.update(false, Seconds{0}), Change::None);
  EXPECT_EQ(episode.seen(Seconds{1}, 2), Change::Begins);
  EXPECT_EQ(episode.seen(Seconds{2}), Change::None);
  EXPECT_EQ(episode.update(false, Seconds{6.9}), Change::None);
  EXPECT_EQ(episode.update(false, Seconds{7.0}), Change::Ends);
  EXPECT_EQ(episode.count(), 3U);
  EXPECT_EQ(episode.update(false, Seconds{20}), Change::None);
  EXPECT_EQ(episode.seen(Seconds{21}), Change::Begins);
  EXPECT_EQ(episode.count(), 1U);
}

TEST(AnswerSentence, namesParametersWithTheirUnitAndActions) {
  using wire::MessageType;
  const auto said = [](MessageType type, std::uint8_t number, std::int32_t value) {
    link::Answered answered;
    answered.request = {type, number, value};
    answered.value = wire::Value{0, number, wire::Outcome::Done, value};
    return answerSentence("AGV 1", answered);
  };
  EXPECT_EQ(said(MessageType::Set, 5, 300),
            "AGV 1, setting the highest speed to 300 mm/s: done, the value is 300 mm/s.");
  EXPECT_EQ(said(MessageType::Get, 8, -91),
            "AGV 1, reading the magnetic declination: done, the value is -91/65536 turn.");
  EXPECT_EQ(said(MessageType::Get, 99, 1), "AGV 1, reading parameter 99: done, the value is 1.");
  EXPECT_EQ(said(MessageType::Do, 2, 0), "AGV 1, restarting: done.");
}

TEST(ParameterTexts, nameEveryParameterOfTheProtocol) {
  for (const int first : {1, 64})
    for (int n = first; n <= (first == 1 ? 22 : 68); ++n)
      EXPECT_EQ(parameterName(static_cast<std::uint8_t>(n)).english().substr(0, 4), "the ") << n;
}

}  // namespace
}  // namespace tessera::supervisor
