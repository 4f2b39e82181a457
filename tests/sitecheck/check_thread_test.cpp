// The check beside whoever edits: the newest site wins, whoever orders never waits, and ThreadSanitizer watches.
#include "sitecheck/live/check_thread.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Site;

std::shared_ptr<const Site> shared(Site site) { return std::make_shared<const Site>(std::move(site)); }

/// Takes results as they come, as the window's thread does.
class Consumer {
public:
  CheckThread& thread() { return thread_; }
  /// The first result from now on that is of this order.
  std::unique_ptr<const CheckResult> resultFor(const CheckOrder& order) {
    while (true) {
      std::unique_lock lock{lock_};
      if (!rung_.wait_for(lock, std::chrono::seconds{60}, [this] { return rings_ > 0; })) return nullptr;
      rings_ = 0;
      lock.unlock();
      auto result = thread_.take();
      if (result && result->order.site == order.site && result->order.trial == order.trial) return result;
    }
  }

private:
  std::mutex lock_;
  std::condition_variable rung_;
  int rings_ = 0;
  CheckThread thread_{[this] {
    const std::lock_guard lock{lock_};
    ++rings_;
    rung_.notify_one();
  }};
};

TEST(CheckThread, findsWhatAFullCheckFinds) {
  Consumer consumer;
  std::mt19937_64 random{7};
  Site site = goodFloor();
  for (int step = 0; step < 30; ++step) {
    editAtRandom(site, random);
    const CheckOrder order{shared(site)};
    consumer.thread().check(order);
    const auto result = consumer.resultFor(order);
    ASSERT_NE(result, nullptr);
    ASSERT_EQ(result->verdict, checkSite(site)) << "step " << step;
  }
}

TEST(CheckThread, comesToTheNewestOfManySitesOrderedInARow) {
  Consumer consumer;
  std::mt19937_64 random{3};
  Site site = goodFloor();
  CheckOrder order;
  for (int step = 0; step < 2000; ++step) {
    editAtRandom(site, random);
    if (step % 100 == 0) site = goodFloor();
    order = {shared(site)};
    consumer.thread().check(order);
  }
  const auto result = consumer.resultFor(order);
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->verdict, checkSite(site));
}

TEST(CheckThread, triesARouteThatIsNotInTheSite) {
  Consumer consumer;
  const auto site = shared(goodFloor());
  const floor::Route outside{"new", {at(0.5, 0.5), at(50.0, 0.5)}, Metres{0.2}};
  const CheckOrder order{site, outside};
  consumer.thread().check(order);
  const auto result = consumer.resultFor(order);
  ASSERT_NE(result, nullptr);
  EXPECT_EQ(result->verdict.size(), checkSite(*site).size()) << "the site itself is as it was";
  ASSERT_FALSE(result->trialFaults.empty());
  EXPECT_EQ(result->trialFaults.front().kind, FaultKind::RouteLeavesRunningZone);
  Site drawn = *site;
  drawn.routes.push_back(outside);
  EXPECT_EQ(checkSite(drawn).size(), result->verdict.size() + result->trialFaults.size());
}

TEST(CheckThread, endsWithOrdersStillWaiting) {
  for (int n = 0; n < 20; ++n) {
    CheckThread thread{[] {}};
    for (int k = 0; k < n; ++k) thread.check({shared(goodFloor())});
  }
}

}  // namespace
}  // namespace tessera::sitecheck
