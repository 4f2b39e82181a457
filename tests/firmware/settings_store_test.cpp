#include "firmware/vehicle/settings_store.h"

#include <gtest/gtest.h>

#include "tests/firmware/fake_board.h"

namespace tessera::firmware::test {
namespace {

using wire::Parameter;

void run(FakeBoard& board, SettingsStore& store, std::uint64_t us = 200'000) {
  for (const std::uint64_t end = board.time + us; board.time < end; board.time += 200)
    store.poll(Micros{static_cast<std::int64_t>(board.time)});
}

Settings settingsOf(std::uint8_t address, std::int32_t speed) {
  Settings s;
  s.set(Parameter::Address, address);
  s.set(Parameter::MaxSpeed, speed);
  s.key.fill(address);
  return s;
}

TEST(SettingsStore, findsWhatAHostHasCommissioned) {
  FakeBoard board;
  board.memory.cells = makeEepromImage(settingsOf(5, 300), 41);
  SettingsStore store{board};
  EXPECT_FALSE(store.ready());
  run(board, store);
  ASSERT_TRUE(store.ready());
  EXPECT_TRUE(store.found());
  EXPECT_FALSE(store.faulty());
  EXPECT_EQ(store.settings(), settingsOf(5, 300));
  EXPECT_EQ(store.starts(), 42U);
}

TEST(SettingsStore, countsEachStartInAnotherPage) {
  FakeBoard board;
  board.memory.cells = makeEepromImage(settingsOf(5, 300));
  for (std::uint32_t start = 1; start <= 40; ++start) {
    SettingsStore store{board};
    run(board, store);
    EXPECT_EQ(store.starts(), start);
  }
  for (std::size_t page = kStartCells / kEepromPage; page < kStartCells / kEepromPage + kStartCellCount; ++page)
    EXPECT_LE(board.memory.pageWrites[page], 3U);
}

TEST(SettingsStore, usesDefaultsAndSaysSoWhenTheEepromIsBlank) {
  FakeBoard board;
  SettingsStore store{board};
  run(board, store);
  ASSERT_TRUE(store.ready());
  EXPECT_FALSE(store.found());
  EXPECT_TRUE(store.faulty());
  EXPECT_EQ(store.settings(), Settings{});
  EXPECT_EQ(store.starts(), 1U);
}

TEST(SettingsStore, isReadyWithoutAnEepromAndCountsNoStart) {
  FakeBoard board;
  board.memory.present = false;
  SettingsStore store{board};
  run(board, store, 100'000);
  ASSERT_TRUE(store.ready());
  EXPECT_TRUE(store.faulty());
  EXPECT_EQ(store.starts(), 0U);
}

TEST(SettingsStore, waitsForAChipThatStillWrites) {
  FakeBoard board;
  board.memory.cells = makeEepromImage(settingsOf(5, 300));
  board.memory.busyUntil = 5000;
  SettingsStore store{board};
  run(board, store);
  EXPECT_TRUE(store.found());
}

TEST(SettingsStore, savesInTurnAndMergesSavesThatComeFast) {
  FakeBoard board;
  board.memory.cells = makeEepromImage(settingsOf(5, 300));
  {
    SettingsStore store{board};
    run(board, store);
    for (std::int32_t speed = 100; speed <= 120; ++speed) store.save(settingsOf(5, speed));
    EXPECT_EQ(store.settings(), settingsOf(5, 120)) << "in force at once";
    run(board, store);
    EXPECT_FALSE(store.saving());
    EXPECT_FALSE(store.faulty());
    EXPECT_EQ(board.memory.pageWrites[kCopyAddress[1] / kEepromPage], 1U);
    store.save(settingsOf(5, 200));
    run(board, store);
    EXPECT_EQ(board.memory.pageWrites[kCopyAddress[0] / kEepromPage], 1U);
  }
  SettingsStore again{board};
  run(board, again);
  EXPECT_EQ(again.settings(), settingsOf(5, 200));
  EXPECT_EQ(settingsFromImage(board.memory.cells), settingsOf(5, 200));
}

TEST(SettingsStore, reportsAChipThatFailsLater) {
  FakeBoard board;
  board.memory.cells = makeEepromImage(settingsOf(5, 300));
  SettingsStore store{board};
  run(board, store);
  board.memory.present = false;
  store.save(settingsOf(5, 200));
  run(board, store);
  EXPECT_TRUE(store.faulty());
  EXPECT_TRUE(store.found());
  EXPECT_EQ(store.settings(), settingsOf(5, 200));
}

// The property: whatever byte the power goes at, the next start finds the old settings or the new ones, and a start
// count that no earlier start has used.
TEST(SettingsStore, losesNothingWhenThePowerGoesAtAnyByteOfASave) {
  bool completed = false;
  for (std::size_t cut = 0; cut < 200; ++cut) {
    FakeBoard board;
    board.memory.cells = makeEepromImage(settingsOf(5, 300), 10);
    {
      SettingsStore first{board};
      run(board, first);
      first.save(settingsOf(5, 310));
      run(board, first);
      first.save(settingsOf(5, 320));
      board.memory.bytesToPowerCut = cut;
      run(board, first);
    }
    if (!board.memory.powerCut) completed = true;
    board.memory.powerCut = false;
    board.memory.bytesToPowerCut.reset();
    SettingsStore second{board};
    run(board, second);
    ASSERT_TRUE(second.found()) << "cut after byte " << cut;
    EXPECT_TRUE(second.settings() == settingsOf(5, 310) || second.settings() == settingsOf(5, 320)) << cut;
    EXPECT_EQ(second.starts(), 12U);
    second.save(settingsOf(5, 400));
    run(board, second);
    EXPECT_EQ(settingsFromImage(board.memory.cells), settingsOf(5, 400)) << "and can save again";
  }
  EXPECT_TRUE(completed) << "the cuts reach past the end of the record";
}

TEST(SettingsStore, neverUsesACountTwiceWhenThePowerGoesWhileCounting) {
  for (std::size_t cut = 0; cut < kStartCellSize; ++cut) {
    FakeBoard board;
    board.memory.cells = makeEepromImage(settingsOf(5, 300), 10);
    SettingsStore torn{board};
    board.memory.bytesToPowerCut = cut;
    run(board, torn, 10'000);
    EXPECT_FALSE(torn.ready()) << "the count is in use only when it stands in the EEPROM";
    board.memory.powerCut = false;
    board.memory.bytesToPowerCut.reset();
    SettingsStore next{board};
    run(board, next);
    EXPECT_EQ(next.starts(), 11U);
  }
}

}  // namespace
}  // namespace tessera::firmware::test
