// Checks a site beside whoever edits it. The newest order wins: one that has not been begun makes way for the next.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "sitecheck/live/newest.h"
#include "sitecheck/site_checker.h"

namespace tessera::sitecheck {

struct CheckOrder {
  std::shared_ptr<const floor::Site> site;
  std::optional<floor::Route> trial = {};  ///< a route that is just being drawn or dragged, as it would be
  CheckOptions options = {};
};

struct CheckResult {
  CheckOrder order;
  Verdict verdict;     ///< on the site as it stands
  Faults trialFaults;  ///< of the trial in that site
};

class CheckThread {
public:
  /// `ready` is called on the thread whenever there is a result to take.
  explicit CheckThread(std::function<void()> ready);
  /// Waits for a check that runs: a second or two on the largest floors.
  ~CheckThread();
  CheckThread(const CheckThread&) = delete;
  CheckThread& operator=(const CheckThread&) = delete;

  /// Requires a site.
  void check(CheckOrder order);
  /// The newest result; null: none since the last taking.
  [[nodiscard]] std::unique_ptr<const CheckResult> take() { return results_.take(); }

private:
  void run();
  void ring();

  std::function<void()> ready_;
  Newest<CheckOrder> orders_;
  Newest<CheckResult> results_;
  std::atomic<std::uint32_t> bell_{0};  ///< counts what the thread has to wake up for
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace tessera::sitecheck
