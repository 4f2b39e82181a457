// One question after the other.
#include "ui/base/ask_series.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/ui/commission/fake_link.h"

namespace tessera::ui {
namespace {

class AskSeriesTest : public testing::Test {
protected:
  FakeLink link;
  AskSeries series{link};
  QSignalSpy finished{&series, &AskSeries::finished};
  QSignalSpy failed{&series, &AskSeries::failed};
  std::vector<wire::Request> two{{wire::MessageType::Get, 2, 0}, {wire::MessageType::Get, 3, 0}};
};

TEST_F(AskSeriesTest, AsksTheNextWhenTheLastIsAnswered) {
  std::vector<std::int32_t> values;
  QObject::connect(&series, &AskSeries::answered, &series,
                   [&](std::size_t, const supervisor::AskAnswer& a) { values.push_back(a.value->value); });
  series.start(VehicleId{1}, two);
  EXPECT_EQ(link.orders.size(), 1U);
  link.answer(wire::Outcome::Done, 11);
  EXPECT_EQ(link.orders.size(), 2U);
  EXPECT_EQ(finished.count(), 0);
  link.answer(wire::Outcome::Done, 12);
  EXPECT_EQ(finished.count(), 1);
  EXPECT_EQ(values, (std::vector<std::int32_t>{11, 12}));
}

TEST_F(AskSeriesTest, AnotherVehiclesAnswerIsNotItsOwn) {
  series.start(VehicleId{1}, two);
  supervisor::Event event;
  event.kind = supervisor::EventKind::Answer;
  event.vehicle = VehicleId{2};
  event.answer = supervisor::AskAnswer{two[0], wire::Value{}};
  link.tell(event);
  EXPECT_EQ(link.orders.size(), 1U);
}

TEST_F(AskSeriesTest, ARefusalOrASilenceEndsItWithTheSentence) {
  series.start(VehicleId{1}, two);
  supervisor::Event event;
  event.kind = supervisor::EventKind::Answer;
  event.vehicle = VehicleId{1};
  event.sentence = "AGV 1 did not answer.";
  event.answer = supervisor::AskAnswer{two[0], std::nullopt};
  link.tell(event);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed.at(0).at(0).toString(), "AGV 1 did not answer.");
  EXPECT_FALSE(series.isRunning());
  EXPECT_EQ(finished.count(), 0);
}

TEST_F(AskSeriesTest, WithoutSupervisionItFailsAtOnce) {
  link.takes = false;
  series.start(VehicleId{1}, two);
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(AskSeriesTest, StoppedItHearsNothingMore) {
  series.start(VehicleId{1}, two);
  series.stop();
  link.answer(wire::Outcome::Done, 1);
  EXPECT_EQ(link.orders.size(), 1U);
  EXPECT_EQ(finished.count(), 0);
}

}  // namespace
}  // namespace tessera::ui
