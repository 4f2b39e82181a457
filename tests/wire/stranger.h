// A vehicle in a process of its own behind a pseudo terminal, known by its frames alone.
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "wire/messages.h"

namespace tessera::wire {

class Stranger {
public:
  /// Starts `command` with the terminal's path behind its first argument (a script's name) and `rest` after that.
  Stranger(const std::vector<std::string>& command, const std::vector<std::string>& rest);
  ~Stranger();
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

  struct Said {
    FrameHeader header;
    std::vector<std::uint8_t> payload;
    std::chrono::steady_clock::duration after;  ///< since the last say()
  };
  void say(Bytes bytes);
  /// The next frame; nullopt when none comes for ten seconds, or the process has ended.
  std::optional<Said> listen();

private:
  int terminal_ = -1;
  int kept_ = -1;  ///< our own handle on the other side, so that the terminal lives before the process has opened it
  int process_ = -1;
  FrameDecoder decoder_;
  std::deque<Said> said_;
  std::chrono::steady_clock::time_point spoken_;
};

}  // namespace tessera::wire
