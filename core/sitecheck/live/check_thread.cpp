#include "sitecheck/live/check_thread.h"

#include <utility>

namespace tessera::sitecheck {

CheckThread::CheckThread(std::function<void()> ready) : ready_{std::move(ready)}, thread_{[this] { run(); }} {}

CheckThread::~CheckThread() {
  ending_.store(true);
  ring();
  thread_.join();
}

void CheckThread::ring() {
  bell_.fetch_add(1, std::memory_order_release);
  bell_.notify_one();
}

void CheckThread::check(CheckOrder order) {
  orders_.put(std::make_unique<CheckOrder>(std::move(order)));
  ring();
}

void CheckThread::run() {
  SiteChecker checker;  // of this thread alone: it remembers what it checked last
  std::uint32_t heard = 0;
  while (true) {
    bell_.wait(heard, std::memory_order_acquire);
    heard = bell_.load(std::memory_order_acquire);
    if (ending_.load()) return;
    auto order = orders_.take();
    if (order == nullptr) continue;
    checker.setOptions(order->options);
    const Verdict& verdict = checker.check(order->site);
    Faults trial = order->trial ? checker.tryRoute(*order->trial) : Faults{};
    results_.put(std::make_unique<CheckResult>(CheckResult{std::move(*order), verdict, std::move(trial)}));
    ready_();
  }
}

}  // namespace tessera::sitecheck
