// What a program with a window asks of the computer before and while it runs.
#pragma once

#include <QSocketNotifier>
#include <functional>
#include <memory>
#include <string>

namespace tessera::desktop {

/// Empty: a window can be shown; otherwise why not, and what to do. Qt itself would abort.
[[nodiscard]] std::string whyNoWindow();

/// While it lives, Ctrl-C and a polite kill call `end` from the event loop instead of ending the program on the spot:
/// the vehicles stop first.
class PoliteEnd {
public:
  explicit PoliteEnd(std::function<void()> end);
  ~PoliteEnd();
  PoliteEnd(const PoliteEnd&) = delete;
  PoliteEnd& operator=(const PoliteEnd&) = delete;

private:
  int ends_[2] = {-1, -1};
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace tessera::desktop
