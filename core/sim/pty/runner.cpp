#include "sim/pty/runner.h"

#include <poll.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>

namespace tessera::sim {

Seconds monotonicNow() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return Seconds{static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec)};
}

void RealTimeRunner::watch(int fd, std::function<void()> readable) { watchers_.push_back({fd, std::move(readable)}); }

void RealTimeRunner::unwatch(int fd) {
  std::erase_if(watchers_, [fd](const Watcher& w) { return w.fd == fd; });
}

Result<void> RealTimeRunner::run(std::optional<Seconds> end) {
  const int timer = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
  constexpr long kPeriod = static_cast<long>(World::kStep.value() * 1e9 + 0.5);
  const itimerspec each{{0, kPeriod}, {0, kPeriod}};
  if (timer < 0 || timerfd_settime(timer, 0, &each, nullptr) != 0) {
    const std::string why = std::strerror(errno);
    if (timer >= 0) ::close(timer);
    return failure("Cannot make a timer: " + why + ".");
  }
  stopped_ = false;
  while (!stopped_ && !(end && monotonicNow() >= *end)) look(timer);
  ::close(timer);
  return {};
}

/// Waits for the next thing to happen and deals with it.
void RealTimeRunner::look(int timer) {
  std::vector<pollfd> fds{{timer, POLLIN, 0}};
  // A port that nobody holds open reports "hung up" without end: it is left out and asked each millisecond instead.
  const bool listens = port_ && connected_ && world_.hostRoom() > 0;
  fds.push_back({listens ? port_->fd() : -1, POLLIN, 0});
  for (const Watcher& w : watchers_) fds.push_back({w.fd, POLLIN, 0});
  if (::poll(fds.data(), fds.size(), -1) < 0) return;  // interrupted: look again

  std::uint64_t expirations = 0;
  if (fds[0].revents != 0 && ::read(timer, &expirations, sizeof expirations) > 0)
    connected_ = port_ && port_->connected();
  catchUp();
  if (fds[1].revents != 0) readPort();
  // A callback may add and remove watchers: each is called through a copy, and only while it is still there.
  for (std::size_t i = 2; i < fds.size(); ++i) {
    if (fds[i].revents == 0) continue;
    const auto it =
        std::find_if(watchers_.begin(), watchers_.end(), [&](const Watcher& w) { return w.fd == fds[i].fd; });
    if (it == watchers_.end()) continue;
    const auto readable = it->readable;
    readable();
  }
}

void RealTimeRunner::catchUp() {
  const Seconds now = monotonicNow();
  const Seconds behind = now - world_.time();
  if (behind > kGiveUp) {
    skipped_ += behind;
    world_.skipTo(now);
    if (trouble_)
      trouble_("The machine does not keep up: " + std::to_string(std::lround(behind.value() * 1000)) +
               " ms of the world were not simulated.");
  }
  world_.advance(std::min(now, world_.time() + kAtOnce));
  const auto bytes = world_.takeHostBytes();
  if (port_ && !bytes.empty()) port_->write(bytes);
  if (port_ && port_->waiting()) port_->flush();
  for (const std::string& sentence : world_.takeTroubles())
    if (trouble_) trouble_(sentence);
}

void RealTimeRunner::readPort() {
  if (!port_) return;
  const auto bytes = port_->read(world_.hostRoom());
  if (bytes.empty())
    connected_ = port_->connected();
  else
    world_.hostBytes(bytes);
}

}  // namespace tessera::sim
