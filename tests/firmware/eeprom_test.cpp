#include "firmware/vehicle/eeprom.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/firmware/fake_board.h"

namespace tessera::firmware::test {
namespace {

// Runs until the write has ended; returns how long it took, in µs, and checks that no poll waits.
std::uint64_t finish(FakeBoard& board, Eeprom& eeprom) {
  const std::uint64_t start = board.time;
  while (eeprom.busy() && board.time - start < 1'000'000) {
    eeprom.poll(Micros{static_cast<std::int64_t>(board.time)});
    board.time += 100;
  }
  return board.time - start;
}

TEST(Eeprom, writesAcrossPagesAndReadsBack) {
  FakeBoard board;
  Eeprom eeprom{board};
  std::array<std::uint8_t, 100> data;
  std::iota(data.begin(), data.end(), std::uint8_t{1});
  ASSERT_TRUE(eeprom.write(20, data));
  EXPECT_FALSE(eeprom.write(20, data)) << "one write at a time";
  finish(board, eeprom);
  EXPECT_FALSE(eeprom.failed());
  std::array<std::uint8_t, 100> back{};
  ASSERT_TRUE(eeprom.read(20, back));
  EXPECT_EQ(back, data);
  EXPECT_EQ(board.memory.cells[19], 0xFF);
  EXPECT_EQ(board.memory.cells[120], 0xFF);
}

TEST(Eeprom, sendsEachPageOnceAndWaitsForTheWriteCycle) {
  FakeBoard board;
  Eeprom eeprom{board};
  std::array<std::uint8_t, 64> data{};
  ASSERT_TRUE(eeprom.write(0, data));
  const std::uint64_t took = finish(board, eeprom);
  EXPECT_EQ(board.memory.pageWrites[0], 1U);
  EXPECT_EQ(board.memory.pageWrites[1], 1U);
  EXPECT_GE(took, 10'000U);
  EXPECT_LE(took, 13'000U);
}

TEST(Eeprom, givesUpWhenTheChipDoesNotAnswer) {
  FakeBoard board;
  board.memory.present = false;
  Eeprom eeprom{board};
  std::array<std::uint8_t, 8> data{};
  EXPECT_FALSE(eeprom.read(0, data));
  ASSERT_TRUE(eeprom.write(0, data));
  EXPECT_LE(finish(board, eeprom), 30'000U);
  EXPECT_TRUE(eeprom.failed());
}

TEST(Eeprom, refusesMoreThanItCanHold) {
  FakeBoard board;
  Eeprom eeprom{board};
  std::array<std::uint8_t, Eeprom::kMaxWrite + 1> data{};
  EXPECT_FALSE(eeprom.write(0, data));
  EXPECT_FALSE(eeprom.busy());
}

}  // namespace
}  // namespace tessera::firmware::test
