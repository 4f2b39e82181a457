// A pty with fake vehicles behind it, under a name that stays when the pty is pulled and another one is put there.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/supervisor_thread.h"
#include "link/fake_vehicle.h"

namespace tessera::test {

class PtyRadio {
public:
  explicit PtyRadio(std::vector<FakeVehicle*> vehicles) : vehicles_{std::move(vehicles)} {}
  ~PtyRadio() { pull(); }
  PtyRadio(const PtyRadio&) = delete;
  PtyRadio& operator=(const PtyRadio&) = delete;

  [[nodiscard]] std::string name() const { return directory_.path().toStdString() + "/radio"; }
  void put() {
    master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    ::grantpt(master_);
    ::unlockpt(master_);
    std::array<char, 128> path{};
    ::ptsname_r(master_, path.data(), path.size());
    termios raw{};
    ::tcgetattr(master_, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(master_, TCSANOW, &raw);
    std::filesystem::create_symlink(path.data(), name());
  }
  void pull() {
    if (master_ < 0) return;
    ::close(master_);
    master_ = -1;
    std::filesystem::remove(name());
  }
  /// Lets the vehicles hear and answer what has come; waits for bytes for at most `milliseconds`.
  void serve(int milliseconds) {
    if (master_ < 0 || !reads) {
      ::poll(nullptr, 0, milliseconds);
      return;
    }
    pollfd wait{master_, POLLIN, 0};
    ::poll(&wait, 1, milliseconds);
    std::array<std::uint8_t, 512> buffer{};
    const ssize_t size = ::read(master_, buffer.data(), buffer.size());
    if (size > 0)
      decoder_.feed(wire::Bytes{buffer}.first(static_cast<std::size_t>(size)),
                    [this](const wire::Frame& f) { hear(f); });
    while (!answers_.empty() && answers_.front().first <= host::steadyNow()) {
      const auto& bytes = answers_.front().second;
      if (::write(master_, bytes.data(), bytes.size()) < 0) ++writesFailed;
      answers_.erase(answers_.begin());
    }
  }

  bool reads = true;
  int writesFailed = 0;

private:
  void hear(const wire::Frame& frame) {
    const Seconds now = host::steadyNow();
    for (FakeVehicle* v : vehicles_)
      if (auto answer = v->hear(frame, now)) answers_.emplace_back(now + answer->delay, std::move(answer->bytes));
    std::stable_sort(answers_.begin(), answers_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  std::vector<FakeVehicle*> vehicles_;
  QTemporaryDir directory_;
  int master_ = -1;
  wire::FrameDecoder decoder_;
  std::vector<std::pair<Seconds, std::vector<std::uint8_t>>> answers_;
};

}  // namespace tessera::test
