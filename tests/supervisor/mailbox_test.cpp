// The hand-over between threads: orders, events and snapshots pass whole, in order, and nobody waits. Run under
// ThreadSanitizer as well.
#include "supervisor/mailbox.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <thread>
#include <vector>

#include "supervisor/pump.h"
#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

TEST(BoundedQueue, refusesWhenFullAndKeepsTheOrder) {
  BoundedQueue<int, 4> queue;
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(queue.tryPush(int{i}));
  EXPECT_FALSE(queue.tryPush(99));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(queue.tryPop(), i);
  EXPECT_EQ(queue.tryPop(), std::nullopt);
  EXPECT_TRUE(queue.tryPush(5));
  EXPECT_EQ(queue.tryPop(), 5);
}

TEST(BoundedQueue, losesAndDoublesNothingBetweenManyThreads) {
  constexpr int kThreads = 3;
  constexpr int kEach = 5000;
  BoundedQueue<std::string, 64> queue;
  std::vector<std::thread> senders;
  senders.reserve(kThreads);
  for (int t = 0; t < kThreads; ++t)
    senders.emplace_back([&queue, t] {
      for (int i = 0; i < kEach; ++i) {
        std::string text = std::to_string(t) + ":" + std::to_string(i);
        while (!queue.tryPush(std::move(text))) std::this_thread::yield();
      }
    });
  std::vector<int> next(kThreads, 0);
  for (int got = 0; got < kThreads * kEach;) {
    const auto text = queue.tryPop();
    if (!text) {
      std::this_thread::yield();
      continue;
    }
    const auto thread = static_cast<std::size_t>((*text)[0] - '0');
    ASSERT_EQ(*text, std::to_string(thread) + ":" + std::to_string(next[thread]++));
    ++got;
  }
  for (std::thread& s : senders) s.join();
  EXPECT_EQ(queue.tryPop(), std::nullopt);
}

TEST(Mailbox, countsEventsThatNobodyFetches) {
  Mailbox mailbox;
  for (int i = 0; i < 5000; ++i) mailbox.publish(Event{});
  EXPECT_EQ(mailbox.takeEvents().size(), 4096U);
  EXPECT_EQ(mailbox.eventsDropped(), 904U);
}

TEST(Mailbox, servesThreadsThatOrderAndReadWhileTheSupervisorTicks) {
  test::SupervisorRig rig;
  const auto mailbox = std::make_shared<Mailbox>();
  Pump pump{std::move(rig.supervisor), mailbox};
  rig.host.ingest = [&](wire::Bytes b, Seconds t) { pump.supervisor().ingest(b, t); };
  rig.host.poll = [&](Seconds t) {
    const Pump::Turn turn = pump.turn(t);
    for (auto& v : rig.vehicles) v->advance(t);
    return std::pair{turn.bytes, turn.wake};
  };
  std::atomic<bool> over{false};
  std::atomic<int> snapshots{0};
  std::thread operatorThread{[&] {
    for (int i = 0; !over; ++i) {
      mailbox->post(i % 2 == 0 ? Order{Pause{VehicleId{1}}} : Order{Resume{VehicleId{1}}});
      std::this_thread::yield();
    }
  }};
  std::thread reader{[&] {
    Seconds last{-1.0};
    while (!over) {
      const auto picture = mailbox->latest();
      if (picture && picture->time > last) {
        last = picture->time;
        ++snapshots;
        EXPECT_EQ(picture->vehicles.size(), 1U);
      }
      (void)mailbox->takeEvents();
      std::this_thread::yield();
    }
  }};
  mailbox->post(RunRoute{VehicleId{1}, "paper", MetresPerSecond{0.2}});
  for (int i = 0; i < 100000 && snapshots < 20; ++i) rig.run(Seconds{0.5});
  over = true;
  operatorThread.join();
  reader.join();
  EXPECT_GE(snapshots, 20);
  EXPECT_EQ(mailbox->latest()->vehicles[0].contact, Contact::Connected);
}

TEST(Pump, closesWhenTheVehiclesStandAndTakesNoMoreOrders) {
  test::SupervisorRig rig;
  const auto mailbox = std::make_shared<Mailbox>();
  Pump pump{std::move(rig.supervisor), mailbox};
  bool closed = false;
  rig.host.ingest = [&](wire::Bytes b, Seconds t) { pump.supervisor().ingest(b, t); };
  rig.host.poll = [&](Seconds t) {
    const Pump::Turn turn = pump.turn(t);
    closed = closed || turn.closed;
    for (auto& v : rig.vehicles) v->advance(t);
    return std::pair{turn.bytes, turn.wake};
  };
  mailbox->post(RunRoute{VehicleId{1}, "paper", MetresPerSecond{0.2}});
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed > 0.15; }, Seconds{10}));
  pump.close(rig.air->now + Seconds{3});
  mailbox->post(RunRoute{VehicleId{1}, "paper", MetresPerSecond{0.2}});
  ASSERT_TRUE(rig.runUntil([&] { return closed; }, Seconds{2.9}));
  EXPECT_EQ(rig.vehicle(1).speed, 0.0);
}

TEST(Pump, closesAtItsDeadlineWhenAVehicleDoesNotObey) {
  test::SupervisorRig rig;
  Pump pump{std::move(rig.supervisor), std::make_shared<Mailbox>()};
  rig.vehicle(1).fake.report.speed = 100;
  rig.vehicle(1).fake.beforeReport = {};
  bool closed = false;
  rig.host.ingest = [&](wire::Bytes b, Seconds t) { pump.supervisor().ingest(b, t); };
  rig.host.poll = [&](Seconds t) {
    const Pump::Turn turn = pump.turn(t);
    closed = closed || turn.closed;
    return std::pair{turn.bytes, turn.wake};
  };
  rig.run(Seconds{2});
  pump.close(rig.air->now + Seconds{2});
  rig.run(Seconds{1.9});
  EXPECT_FALSE(closed);
  rig.run(Seconds{0.2});
  EXPECT_TRUE(closed);
}

}  // namespace
}  // namespace tessera::supervisor
