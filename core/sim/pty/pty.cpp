#include "sim/pty/pty.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace tessera::sim {

namespace {

std::string reason() { return std::strerror(errno); }

/// Raw, as a driver without line discipline. The other end sees these settings too, until it makes its own.
bool makeRaw(int fd) {
  termios t{};
  if (tcgetattr(fd, &t) != 0) return false;
  cfmakeraw(&t);
  t.c_cflag |= CLOCAL;
  return tcsetattr(fd, TCSANOW, &t) == 0;
}

/// Renames a fresh link over the old one, so that the name never points nowhere.
Result<void> makeLink(const std::string& link, const std::string& device) {
  struct stat info {};
  if (lstat(link.c_str(), &info) == 0 && !S_ISLNK(info.st_mode))
    return failure("Cannot make the link " + link + ": something that is not a link has this name.");
  const std::string fresh = link + "." + std::to_string(getpid());
  if (symlink(device.c_str(), fresh.c_str()) != 0 || std::rename(fresh.c_str(), link.c_str()) != 0) {
    const std::string why = reason();
    unlink(fresh.c_str());
    return failure("Cannot make the link " + link + ": " + why + ".");
  }
  return {};
}

}  // namespace

Result<Pty> Pty::open(const std::string& link) {
  Pty pty;
  pty.fd_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 128> name{};
  if (pty.fd_ < 0 || grantpt(pty.fd_) != 0 || unlockpt(pty.fd_) != 0 ||
      ptsname_r(pty.fd_, name.data(), name.size()) != 0)
    return failure("Cannot make a pseudo terminal: " + reason() + ".");
  pty.device_ = name.data();
  // Opened and closed once: from then on the master's POLLHUP tells whether somebody is there.
  const int other = ::open(pty.device_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (other < 0 || !makeRaw(other)) {
    const std::string why = reason();
    if (other >= 0) ::close(other);
    return failure("Cannot set up the pseudo terminal " + pty.device_ + ": " + why + ".");
  }
  ::close(other);
  if (!link.empty()) {
    if (auto made = makeLink(link, pty.device_); !made) return tl::unexpected{made.error()};
    pty.link_ = link;
  }
  return pty;
}

Pty::Pty(Pty&& other) noexcept
    : fd_{std::exchange(other.fd_, -1)},
      device_{std::move(other.device_)},
      link_{std::exchange(other.link_, {})},
      backlog_{std::move(other.backlog_)},
      dropped_{other.dropped_} {}

Pty& Pty::operator=(Pty&& other) noexcept {
  if (this == &other) return *this;
  close();
  fd_ = std::exchange(other.fd_, -1);
  device_ = std::move(other.device_);
  link_ = std::exchange(other.link_, {});
  backlog_ = std::move(other.backlog_);
  dropped_ = other.dropped_;
  return *this;
}

Pty::~Pty() { close(); }

void Pty::close() {
  if (!link_.empty()) {
    std::array<char, 128> target{};
    const ssize_t n = readlink(link_.c_str(), target.data(), target.size());
    if (n > 0 && device_ == std::string(target.data(), static_cast<std::size_t>(n))) unlink(link_.c_str());
    link_.clear();
  }
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

bool Pty::connected() const {
  pollfd p{fd_, POLLIN, 0};
  return fd_ >= 0 && ::poll(&p, 1, 0) >= 0 && (p.revents & POLLHUP) == 0;
}

std::vector<std::uint8_t> Pty::read(std::size_t most) {
  std::vector<std::uint8_t> bytes(most);
  const ssize_t n = ::read(fd_, bytes.data(), bytes.size());
  bytes.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return bytes;
}

void Pty::write(std::span<const std::uint8_t> bytes) {
  const std::size_t room = kBacklog - backlog_.size();
  const std::size_t taken = bytes.size() < room ? bytes.size() : room;
  backlog_.insert(backlog_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
  dropped_ += bytes.size() - taken;
  flush();
}

void Pty::flush() {
  if (backlog_.empty()) return;
  if (!connected()) {
    dropped_ += backlog_.size();
    backlog_.clear();
    return;
  }
  const ssize_t n = ::write(fd_, backlog_.data(), backlog_.size());
  if (n > 0) backlog_.erase(backlog_.begin(), backlog_.begin() + n);
}

}  // namespace tessera::sim
