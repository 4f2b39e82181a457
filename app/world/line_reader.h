// Lines from a pipe or a terminal, as far as they have come, without ever waiting.
#pragma once

#include <string>
#include <vector>

namespace tessera::world {

class LineReader {
public:
  static constexpr std::size_t kLongest = 8192;  ///< what is longer is dropped up to its end

  /// The descriptor stays the caller's.
  explicit LineReader(int fd) : fd_{fd} {}
  /// Call when fd is readable. Whole lines, without their ends.
  [[nodiscard]] std::vector<std::string> read();
  /// The other end has closed.
  [[nodiscard]] bool ended() const { return ended_; }

private:
  int fd_;
  std::string part_;
  bool tooLong_ = false;
  bool ended_ = false;
};

}  // namespace tessera::world
