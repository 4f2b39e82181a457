#include "system/pty_bridge.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

namespace tessera::system_test {

PtyBridge::PtyBridge() {
  for (End& end : ends_) {
    end.master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ::grantpt(end.master);
    ::unlockpt(end.master);
    std::array<char, 128> path{};
    ::ptsname_r(end.master, path.data(), path.size());
    end.path = path.data();
    end.kept = ::open(path.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios raw{};
    ::tcgetattr(end.kept, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(end.kept, TCSANOW, &raw);
  }
  if (::pipe2(stop_.data(), O_CLOEXEC) == 0) thread_ = std::thread{[this] { carry(); }};
}

PtyBridge::~PtyBridge() {
  ::close(stop_[1]);
  if (thread_.joinable()) thread_.join();
  ::close(stop_[0]);
  for (const End& end : ends_) {
    ::close(end.kept);
    ::close(end.master);
  }
}

void PtyBridge::carry() const {
  while (true) {
    std::array<pollfd, 3> ready{{{ends_[0].master, POLLIN, 0}, {ends_[1].master, POLLIN, 0}, {stop_[0], POLLIN, 0}}};
    if (::poll(ready.data(), ready.size(), -1) < 0 || ready[2].revents != 0) return;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (ready[i].revents == 0) continue;
      std::array<char, 512> bytes{};
      const ssize_t size = ::read(ends_[i].master, bytes.data(), bytes.size());
      if (size <= 0 || ::write(ends_[1 - i].master, bytes.data(), static_cast<std::size_t>(size)) != size) return;
    }
  }
}

}  // namespace tessera::system_test
