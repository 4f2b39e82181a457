#include "app/tessera/runtime.h"

#include <QtGlobal>

#ifdef Q_OS_UNIX
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#endif
#include <utility>

namespace tessera::desktop {

#ifdef Q_OS_UNIX

std::string whyNoWindow() {
#ifdef Q_OS_LINUX
  if (!qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
      !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    return {};
  return "There is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set). Start it from a "
         "desktop, or use tessera-cli, which needs none.";
#else
  return {};
#endif
}

namespace {
// A signal handler can reach nothing but a global.
volatile sig_atomic_t writeEnd = -1;
}  // namespace

PoliteEnd::PoliteEnd(std::function<void()> end) {
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends_) != 0) return;
  writeEnd = ends_[1];
  notifier_ = std::make_unique<QSocketNotifier>(ends_[0], QSocketNotifier::Read);
  QObject::connect(notifier_.get(), &QSocketNotifier::activated, notifier_.get(), [this, end = std::move(end)] {
    char byte = 0;
    if (::read(ends_[0], &byte, 1) == 1) end();
  });
  struct sigaction action {};
  action.sa_handler = [](int) {
    const char byte = 1;
    [[maybe_unused]] const auto written = ::write(writeEnd, &byte, 1);
  };
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // a second one ends the program at once
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

PoliteEnd::~PoliteEnd() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  notifier_.reset();
  for (const int end : ends_) ::close(end);
}

#else

std::string whyNoWindow() { return {}; }
PoliteEnd::PoliteEnd(std::function<void()>) {}
PoliteEnd::~PoliteEnd() = default;

#endif

}  // namespace tessera::desktop
