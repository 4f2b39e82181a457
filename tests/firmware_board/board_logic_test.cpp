#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include "firmware/boards/lm3s6965/echo_timer.h"
#include "firmware/boards/lm3s6965/micros_counter.h"
#include "firmware/boards/lm3s6965/quadrature.h"
#include "firmware/boards/lm3s6965/reset_cause.h"
#include "firmware/boards/lm3s6965/ring.h"
#include "firmware/boards/lm3s6965/stack_paint.h"
#include "firmware/boards/lm3s6965/tick_schedule.h"

namespace tessera::firmware::lm3s6965 {
namespace {

TEST(MicrosCounter, isExactAcrossManyWrapsHoweverItIsAsked) {
  MicrosCounter<50> counter{0};
  std::mt19937 random{7};
  std::uint64_t ticks = 0;
  for (int i = 0; i < 100'000; ++i) {
    ticks += std::uniform_int_distribution<std::uint32_t>{0, 0xFFFFFF}(random);
    const auto raw = static_cast<std::uint32_t>(0 - ticks) & 0xFFFFFF;
    ASSERT_EQ(counter.advance(raw), static_cast<std::uint32_t>(ticks / 50)) << i;
  }
  EXPECT_GT(ticks / 50, 1ULL << 32) << "the microseconds themselves have wrapped too";
}

TEST(MicrosCounter, losesNoPartOfAMicrosecondWhenAskedTickByTick) {
  MicrosCounter<50> counter{0xFFFFFF};
  std::uint32_t micros = 0;
  for (std::uint32_t tick = 1; tick <= 1000; ++tick) micros = counter.advance(0xFFFFFF - tick);
  EXPECT_EQ(micros, 20U);
}

TEST(Quadrature, countsFourPerPeriodBothWays) {
  Quadrature wheel;
  for (unsigned levels : {1U, 3U, 2U, 0U, 1U}) wheel.see(levels);
  EXPECT_EQ(wheel.count(), 5);
  for (unsigned levels : {0U, 2U, 3U, 1U, 0U, 2U}) wheel.see(levels);
  EXPECT_EQ(wheel.count(), -1);
  EXPECT_EQ(wheel.skipped(), 0U);
}

TEST(Quadrature, countsNothingForALookWithoutChangeOrAJumpOfTwo) {
  Quadrature wheel{1};
  wheel.see(1);
  EXPECT_EQ(wheel.count(), 0);
  EXPECT_EQ(wheel.skipped(), 0U);
  wheel.see(2);
  EXPECT_EQ(wheel.count(), 0);
  EXPECT_EQ(wheel.skipped(), 1U);
  wheel.see(0);
  EXPECT_EQ(wheel.count(), 1);
}

TEST(Quadrature, looksOnlyAtItsOwnTwoBits) {
  Quadrature wheel{0xFC};
  wheel.see(0xFD);
  EXPECT_EQ(wheel.count(), 1);
}

TEST(EchoTimer, measuresFromRiseToFallAcrossTheClocksWrap) {
  EchoTimer echo;
  echo.begin();
  EXPECT_EQ(echo.length(), 0U);
  echo.edge(true, 0xFFFFFF00);
  EXPECT_EQ(echo.length(), 0U);
  echo.edge(false, 0x00000100);
  EXPECT_EQ(echo.length(), 0x200U);
}

TEST(EchoTimer, measuresThePulseOfAnUnansweredPing) {
  EchoTimer echo;
  echo.begin();
  echo.edge(true, 0xFFFFFFFF - 20'000);
  echo.edge(false, 17'999);
  EXPECT_EQ(echo.length(), 38'000U);
}

TEST(EchoTimer, forgetsAnEchoThatBelongsToTheLastPing) {
  EchoTimer echo;
  echo.begin();
  echo.edge(true, 100);
  echo.begin();
  echo.edge(false, 300);
  EXPECT_EQ(echo.length(), 0U);
  echo.edge(true, 1000);
  echo.edge(false, 1500);
  EXPECT_EQ(echo.length(), 500U);
}

TEST(EchoTimer, tellsAnEchoOfNoLengthFromNone) {
  EchoTimer echo;
  echo.edge(true, 7);
  echo.edge(false, 7);
  EXPECT_EQ(echo.length(), 1U);
}

TEST(TickSchedule, isDueOncePerPeriodOnAFixedGrid) {
  TickSchedule ticks{0xFFFFF000, 10'000};
  int count = 0;
  for (std::uint32_t elapsed = 0; elapsed <= 1'000'000; elapsed += 70) count += ticks.due(0xFFFFF000 + elapsed) ? 1 : 0;
  EXPECT_EQ(count, 100 - 1 + 0) << "the hundredth is due at 1,000,000, which 70 does not divide";
  EXPECT_TRUE(ticks.due(0xFFFFF000 + 1'000'000));
}

TEST(TickSchedule, dropsWhatWasMissedAndKeepsTheGrid) {
  TickSchedule ticks{0, 10'000};
  EXPECT_FALSE(ticks.due(9'999));
  EXPECT_TRUE(ticks.due(57'000));
  EXPECT_FALSE(ticks.due(57'001));
  EXPECT_FALSE(ticks.due(59'999));
  EXPECT_TRUE(ticks.due(60'000));
}

TEST(ResetCause, believesTheRegister) {
  constexpr auto kRunning = static_cast<std::uint32_t>(LifeMark::Running);
  EXPECT_EQ(decideResetCause(1U << 1, kRunning), wire::ResetCause::PowerOn);
  EXPECT_EQ(decideResetCause(1U << 1 | 1U << 3, kRunning), wire::ResetCause::PowerOn) << "bits of before count nothing";
  EXPECT_EQ(decideResetCause(1U << 2, kRunning), wire::ResetCause::PowerOn) << "brown-out";
  EXPECT_EQ(decideResetCause(1U << 3, kRunning), wire::ResetCause::Watchdog);
  EXPECT_EQ(decideResetCause(1U << 4, static_cast<std::uint32_t>(LifeMark::Restart)), wire::ResetCause::Software);
  EXPECT_EQ(decideResetCause(1U << 4, static_cast<std::uint32_t>(LifeMark::Fault)), wire::ResetCause::Other);
  EXPECT_EQ(decideResetCause(1U << 0, kRunning), wire::ResetCause::Other) << "reset pin";
}

TEST(ResetCause, asksTheMarkInMemoryWhenTheRegisterIsSilent) {
  EXPECT_EQ(decideResetCause(0, static_cast<std::uint32_t>(LifeMark::Running)), wire::ResetCause::Watchdog);
  EXPECT_EQ(decideResetCause(0, static_cast<std::uint32_t>(LifeMark::Restart)), wire::ResetCause::Software);
  EXPECT_EQ(decideResetCause(0, static_cast<std::uint32_t>(LifeMark::Fault)), wire::ResetCause::Other);
  EXPECT_EQ(decideResetCause(0, 0), wire::ResetCause::PowerOn);
  EXPECT_EQ(decideResetCause(0, 0xDEADBEEF), wire::ResetCause::PowerOn);
}

TEST(Ring, takesAsMuchAsItHoldsAndGivesItBackInOrder) {
  Ring<8> ring;
  for (int round = 0; round < 5; ++round) {
    for (std::uint8_t i = 0; i < 8; ++i) EXPECT_TRUE(ring.put(i));
    EXPECT_FALSE(ring.put(99));
    std::uint8_t byte = 0;
    for (std::uint8_t i = 0; i < 8; ++i) {
      ASSERT_TRUE(ring.take(byte));
      EXPECT_EQ(byte, i);
    }
    EXPECT_FALSE(ring.take(byte));
    EXPECT_TRUE(ring.empty());
  }
}

TEST(Ring, losesNothingBetweenTwoSidesThatRunAtOnce) {
  Ring<16> ring;
  constexpr int kBytes = 200'000;
  std::thread producer{[&ring] {
    for (int i = 0; i < kBytes; ++i) {
      while (!ring.put(static_cast<std::uint8_t>(i))) std::this_thread::yield();
    }
  }};
  int wrong = 0;
  for (int i = 0; i < kBytes; ++i) {
    std::uint8_t byte = 0;
    while (!ring.take(byte)) std::this_thread::yield();
    if (byte != static_cast<std::uint8_t>(i)) ++wrong;
  }
  producer.join();
  EXPECT_EQ(wrong, 0);
}

TEST(StackPaint, countsFromTheBottomToTheFirstWordEverTouched) {
  std::vector<std::uint32_t> stack(16, kPaint);
  EXPECT_EQ(paintedBytes(stack), 64U);
  stack[10] = 0;
  EXPECT_EQ(paintedBytes(stack), 40U) << "what lies above was in use, painted or not";
  stack[0] = 1;
  EXPECT_EQ(paintedBytes(stack), 0U);
}

}  // namespace
}  // namespace tessera::firmware::lm3s6965
