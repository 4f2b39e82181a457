// The queue before the storage thread, without Qt: order, bounds, and threads. Run under ThreadSanitizer as well.
#include "store/store_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace tessera::store {
namespace {

using supervisor::Severity;
using namespace std::chrono_literals;

Note queuedNote(int number, Severity severity = Severity::Info) {
  Note note;
  note.utcMs = number;
  note.event.severity = severity;
  return note;
}

std::vector<int> numbersOf(const std::vector<Note>& notes) {
  std::vector<int> numbers;
  for (const Note& note : notes) numbers.push_back(static_cast<int>(note.utcMs));
  return numbers;
}

Work takeNow(StoreQueue& queue) { return queue.take(StoreQueue::Clock::now(), false); }

TEST(StoreQueue, givesNotesOfAllSeveritiesInTheOrderInWhichTheyCame) {
  StoreQueue queue;
  EXPECT_TRUE(queue.note({queuedNote(1), queuedNote(2, Severity::Error), queuedNote(3)}));
  EXPECT_TRUE(queue.note({queuedNote(4, Severity::Warning), queuedNote(5)}));
  EXPECT_EQ(numbersOf(takeNow(queue).notes), (std::vector{1, 2, 3, 4, 5}));
  EXPECT_TRUE(queue.empty());
}

TEST(StoreQueue, putsWhatIsGivenBackBeforeWhatCameSince) {
  StoreQueue queue;
  queue.note({queuedNote(1), queuedNote(2, Severity::Error), queuedNote(3)});
  Work first = takeNow(queue);
  queue.note({queuedNote(4, Severity::Error), queuedNote(5)});
  queue.giveBack(std::move(first));
  Work second = takeNow(queue);
  EXPECT_EQ(numbersOf(second.notes), (std::vector{1, 2, 3, 4, 5}));
  queue.giveBack(std::move(second));
  queue.note({queuedNote(6)});
  EXPECT_EQ(numbersOf(takeNow(queue).notes), (std::vector{1, 2, 3, 4, 5, 6}));
}

TEST(StoreQueue, dropsTheOldestOfTheLeastSevereWhenThereAreTooManyAndCountsThem) {
  StoreQueue queue{{.notes = 4, .requests = 4}};
  queue.note({queuedNote(1), queuedNote(2, Severity::Warning), queuedNote(3), queuedNote(4, Severity::Error)});
  queue.note({queuedNote(5), queuedNote(6, Severity::Error)});
  Work work = takeNow(queue);
  EXPECT_EQ(numbersOf(work.notes), (std::vector{2, 4, 5, 6}));
  EXPECT_EQ(work.lost, 2U);
  queue.note({queuedNote(7, Severity::Error), queuedNote(8, Severity::Error)});
  queue.giveBack(std::move(work));
  const Work rest = takeNow(queue);
  EXPECT_EQ(numbersOf(rest.notes), (std::vector{4, 6, 7, 8}));
  EXPECT_EQ(rest.lost, 4U) << "those of the first taking were not told yet";
  EXPECT_EQ(takeNow(queue).lost, 0U);
}

TEST(StoreQueue, letsANewerStateOfASiteTakeTheWaitingOnesPlace) {
  StoreQueue queue;
  queue.change(KeepSite{"a", nullptr, 1, true});
  queue.change(KeepSite{"b", nullptr, 2, true});
  queue.change(KeepSite{"a", nullptr, 3, false});
  const Work work = takeNow(queue);
  ASSERT_EQ(work.changes.size(), 2U);
  EXPECT_EQ(std::get<KeepSite>(work.changes[0]).key, "a");
  EXPECT_EQ(std::get<KeepSite>(work.changes[0]).utcMs, 3);
  EXPECT_FALSE(std::get<KeepSite>(work.changes[0]).differsFromFile);
  EXPECT_EQ(std::get<KeepSite>(work.changes[1]).key, "b");
}

TEST(StoreQueue, keepsASiteAfterTheRenamingThatWasAskedForBefore) {
  StoreQueue queue;
  queue.change(KeepSite{"a", nullptr, 1, true});
  queue.change(RenameSite{"a", "b"});
  queue.change(KeepSite{"a", nullptr, 2, true});
  const Work work = takeNow(queue);
  ASSERT_EQ(work.changes.size(), 3U);
  EXPECT_EQ(std::get<KeepSite>(work.changes[0]).utcMs, 1);
  EXPECT_EQ(std::get<RenameSite>(work.changes[1]).to, "b");
  EXPECT_EQ(std::get<KeepSite>(work.changes[2]).utcMs, 2);
}

TEST(StoreQueue, handsOutRequestsAloneWhileAllElseHasToWait) {
  StoreQueue queue{{.notes = 4, .requests = 2}};
  queue.note({queuedNote(1)});
  EXPECT_TRUE(queue.ask({7, ListSites{}}));
  EXPECT_TRUE(queue.ask({8, ListSites{}}));
  EXPECT_FALSE(queue.ask({9, ListSites{}})) << "full";
  const Work work = queue.take(StoreQueue::Clock::now() + 10s, true);
  EXPECT_TRUE(work.notes.empty());
  ASSERT_EQ(work.requests.size(), 2U);
  EXPECT_EQ(work.requests[0].id, 7U);
  EXPECT_EQ(numbersOf(takeNow(queue).notes), (std::vector{1}));
}

TEST(StoreQueue, takesNothingMoreWhenClosedButHandsOutTheRest) {
  StoreQueue queue;
  queue.note({queuedNote(1)});
  queue.close();
  EXPECT_FALSE(queue.note({queuedNote(2)}));
  EXPECT_FALSE(queue.change(RemoveSite{"a"}));
  EXPECT_FALSE(queue.ask({1, ListSites{}}));
  EXPECT_EQ(numbersOf(queue.take(StoreQueue::Clock::now() + 10s, false).notes), (std::vector{1}));
}

TEST(StoreQueue, losesAndDoublesNothingBetweenThreadsThoughTheDiskFailsNowAndThen) {
  constexpr int kEach = 3000;
  StoreQueue queue;
  std::vector<std::thread> senders;
  for (int sender = 0; sender < 3; ++sender)
    senders.emplace_back([&queue, sender] {
      for (int i = 0; i < kEach; ++i) {
        queue.note({queuedNote(sender * kEach + i, static_cast<Severity>(i % 3))});
        if (i % 100 == 0) queue.change(KeepSite{std::to_string(sender), nullptr, i, true});
        if (i % 50 == 0) queue.ask({static_cast<std::uint64_t>(i), ListSites{}});
      }
    });
  std::vector<int> next{0, kEach, 2 * kEach};
  std::vector<std::int64_t> lastKept(3, -1);
  int failures = 0;
  std::thread closer{[&] {
    for (std::thread& sender : senders) sender.join();
    queue.close();
  }};
  for (int round = 0; !queue.closed() || !queue.empty(); ++round) {
    Work work = queue.take(StoreQueue::Clock::now() + 20ms, round % 7 == 1);
    if (round % 3 == 0) {
      ++failures;
      queue.giveBack(std::move(work));
      continue;
    }
    for (const Note& note : work.notes) {
      const auto sender = static_cast<std::size_t>(note.utcMs / kEach);
      ASSERT_EQ(note.utcMs, next[sender]++);
    }
    for (const SiteChange& change : work.changes) {
      const auto& keep = std::get<KeepSite>(change);
      const auto sender = static_cast<std::size_t>(std::stoi(keep.key));
      EXPECT_GE(keep.utcMs, lastKept[sender]);
      lastKept[sender] = keep.utcMs;
    }
    EXPECT_EQ(work.lost, 0U);
  }
  closer.join();
  EXPECT_EQ(next, (std::vector{kEach, 2 * kEach, 3 * kEach}));
  EXPECT_EQ(lastKept, (std::vector<std::int64_t>(3, kEach - 100)));
  EXPECT_GT(failures, 0);
}

}  // namespace
}  // namespace tessera::store
