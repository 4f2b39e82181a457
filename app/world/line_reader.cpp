#include "app/world/line_reader.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

namespace tessera::world {

std::vector<std::string> LineReader::read() {
  std::array<char, 4096> piece{};
  // One read only: the caller was told that there is something, a second one might wait.
  const ssize_t n = ::read(fd_, piece.data(), piece.size());
  if (n <= 0) {
    ended_ = n == 0 || (errno != EINTR && errno != EAGAIN);
    return {};
  }
  std::vector<std::string> lines;
  for (ssize_t i = 0; i < n; ++i) {
    const char c = piece[static_cast<std::size_t>(i)];
    if (c == '\n') {
      if (!tooLong_) lines.push_back(std::exchange(part_, {}));
      part_.clear();
      tooLong_ = false;
    } else if (part_.size() < kLongest) {
      part_.push_back(c);
    } else {
      tooLong_ = true;
    }
  }
  return lines;
}

}  // namespace tessera::world
