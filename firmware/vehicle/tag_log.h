// Turns what the readers see into events for the host: a tag came under a reader, or left it. Events are numbered and
// kept until the host says that it has them, so that a lost radio packet loses no tag.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/vehicle/time.h"
#include "wire/messages.h"

namespace tessera::firmware {

/// One finished read attempt. length 0: no tag.
struct Reading {
  std::uint8_t reader = 0;
  std::uint8_t counter = 0;  ///< grows with each attempt of that reader
  std::uint8_t length = 0;   ///< 0, 4, 7 or 10
  std::array<std::uint8_t, 10> uid{};
  bool operator==(const Reading&) const = default;
};

class TagLog {
public:
  static constexpr std::size_t kCapacity = 32;
  static constexpr std::size_t kMaxReaders = 8;
  /// A tag has left after this many empty attempts running, as a single one misses often.
  static constexpr int kMisses = 3;

  /// An answer whose counter has been seen already is passed over.
  void take(const Reading& reading, Micros now);
  /// The host has every event before `next`. Numbers that were not reported in this session mean nothing.
  void acknowledge(std::uint8_t next);
  /// A host that knows nothing yet: tags that lie under the readers are announced again.
  void beginSession(Micros now);
  /// Puts in the oldest events, as many as fit, with their age at `now`.
  void fill(wire::Report& report, Micros now);

  [[nodiscard]] std::size_t waiting() const { return count_; }
  /// Events were dropped since the last fill().
  [[nodiscard]] bool lost() const { return lost_; }

private:
  struct Event {
    std::uint8_t reader = 0;
    wire::EventKind kind = wire::EventKind::Left;
    std::array<std::uint8_t, 10> uid{};
    Micros time{0};
  };
  struct Head {
    bool heard = false;
    std::uint8_t counter = 0;
    std::uint8_t length = 0;  ///< of the tag under the reader, 0 = none
    std::array<std::uint8_t, 10> uid{};
    Micros lastGood{0};
    int misses = 0;
  };
  void add(const Event& event);
  void enter(std::uint8_t reader, Micros time);
  void leave(std::uint8_t reader);

  std::array<Event, kCapacity> ring_{};
  std::array<Head, kMaxReaders> heads_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::uint8_t first_ = 0;    ///< number of the oldest event
  std::size_t reported_ = 0;  ///< how many of the oldest have been reported in this session
  bool lost_ = false;
};

}  // namespace tessera::firmware
