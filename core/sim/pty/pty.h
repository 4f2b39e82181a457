// The world's end of a pseudo terminal: to the program at the other end it is a serial port with a radio behind it.
// Bytes for a port that nobody holds open are lost, as on a real adapter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace tessera::sim {

class Pty {
public:
  /// Bytes kept for a reader that does not keep up; what comes beyond is dropped.
  static constexpr std::size_t kBacklog = 4096;

  /// Opens a raw pseudo terminal. link: a symbolic link to make to it, replacing an older link; empty: none.
  /// Error: no terminal to be had, or the link's place is taken by something else.
  [[nodiscard]] static Result<Pty> open(const std::string& link = {});
  Pty(Pty&& other) noexcept;
  Pty& operator=(Pty&& other) noexcept;
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;
  /// The other end sees the device go.
  ~Pty();

  /// What to open at the other end: the link where there is one.
  [[nodiscard]] const std::string& path() const { return link_.empty() ? device_ : link_; }
  [[nodiscard]] const std::string& device() const { return device_; }
  [[nodiscard]] int fd() const { return fd_; }
  /// Whether somebody holds the other end open. While nobody does, do not poll() fd() but ask again now and then.
  [[nodiscard]] bool connected() const;

  /// What has arrived, at most `most` bytes. Never waits.
  [[nodiscard]] std::vector<std::uint8_t> read(std::size_t most = 4096);
  /// Never waits.
  void write(std::span<const std::uint8_t> bytes);
  /// Writes what waits, as far as the other end takes it.
  void flush();
  [[nodiscard]] bool waiting() const { return !backlog_.empty(); }
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

private:
  Pty() = default;
  void close();

  int fd_ = -1;
  std::string device_;
  std::string link_;
  std::vector<std::uint8_t> backlog_;
  std::uint64_t dropped_ = 0;
};

}  // namespace tessera::sim
