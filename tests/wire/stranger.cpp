#include "wire/stranger.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>

namespace tessera::wire {

Stranger::Stranger(const std::vector<std::string>& command, const std::vector<std::string>& rest) {
  terminal_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ::grantpt(terminal_);
  ::unlockpt(terminal_);
  const std::string path = ::ptsname(terminal_);
  kept_ = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios raw{};
  ::tcgetattr(kept_, &raw);
  ::cfmakeraw(&raw);
  ::tcsetattr(kept_, TCSANOW, &raw);
  std::vector<std::string> words = command;
  words.push_back(path);
  words.insert(words.end(), rest.begin(), rest.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
}

Stranger::~Stranger() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  ::close(kept_);
  ::close(terminal_);
}

void Stranger::say(Bytes bytes) {
  spoken_ = std::chrono::steady_clock::now();
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(terminal_, bytes.data() + done, bytes.size() - done);
    if (n <= 0) return;
    done += static_cast<std::size_t>(n);
  }
}

std::optional<Stranger::Said> Stranger::listen() {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{10};
  while (said_.empty() && std::chrono::steady_clock::now() < deadline) {
    pollfd ready{terminal_, POLLIN, 0};
    if (::poll(&ready, 1, 50) <= 0) {
      if (::waitpid(process_, nullptr, WNOHANG) != 0) {
        process_ = -1;
        break;
      }
      continue;
    }
    std::array<std::uint8_t, 256> buffer{};
    const ssize_t n = ::read(terminal_, buffer.data(), buffer.size());
    if (n <= 0) break;
    decoder_.feed(Bytes{buffer}.first(static_cast<std::size_t>(n)), [this](const Frame& f) {
      said_.push_back({f.header, {f.payload.begin(), f.payload.end()}, std::chrono::steady_clock::now() - spoken_});
    });
  }
  if (said_.empty()) return std::nullopt;
  Said said = said_.front();
  said_.pop_front();
  return said;
}

}  // namespace tessera::wire
