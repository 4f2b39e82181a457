#include "app/tessera/runtime.h"

#include <QByteArray>
#include <QList>

#ifdef Q_OS_UNIX
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <csignal>
#endif
#include <cstddef>
#include <cstring>
#include <utility>

namespace tessera::desktop {

#ifdef Q_OS_UNIX

#ifdef Q_OS_LINUX
namespace {
// Whether somebody listens at a display of this machine (":1" or ":1.0"); Qt would end the program where nobody does.
// Displays of other machines are left to Qt.
bool answers(const QByteArray& display) {
  bool isNumber = false;
  const int number = display.mid(1).split('.').front().toInt(&isNumber);
  if (!display.startsWith(':') || !isNumber) return true;
  const QByteArray path = "/tmp/.X11-unix/X" + QByteArray::number(number);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  // The second name is Linux's own, which needs no file.
  for (const QByteArray& name : {path, QByteArray{1, '\0'} + path}) {
    const int handle = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (handle < 0) return true;
    std::memcpy(static_cast<void*>(address.sun_path), name.constData(), static_cast<std::size_t>(name.size()));
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + static_cast<std::size_t>(name.size()));
    const bool there = ::connect(handle, reinterpret_cast<const sockaddr*>(&address), length) == 0;
    ::close(handle);
    if (there) return true;
  }
  return false;
}
}  // namespace
#endif

std::string whyNoWindow() {
#ifdef Q_OS_LINUX
  if (!qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") || !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) return {};
  if (const QByteArray display = qgetenv("DISPLAY"); !display.isEmpty()) {
    if (answers(display)) return {};
    return "The display " + display.toStdString() +
           " (variable DISPLAY) does not answer. Start it from a desktop, or use tessera-cli, which needs no display.";
  }
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
