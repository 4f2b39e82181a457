// The frame that host and vehicle exchange. One frame is at most one packet of the E32 radio (58 bytes).
//
//   0  sync     0xA5
//   1  n        payload length, 0 to 49
//   2  to       address of the receiver (0 host, 1..254 vehicles, 255 every vehicle)
//   3  from     address of the sender
//   4  type     MessageType
//   5  counter  low 16 bits of the sender's frame counter, little-endian
//   7  payload  n bytes
// 7+n  crc      CRC-16/CCITT-FALSE over bytes 1 .. 6+n, little-endian
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "wire/bytes.h"

namespace tessera::wire {

inline constexpr std::uint8_t kSync = 0xA5;
inline constexpr std::size_t kMaxFrame = 58;
inline constexpr std::size_t kFrameOverhead = 9;
inline constexpr std::size_t kMaxPayload = kMaxFrame - kFrameOverhead;
inline constexpr std::uint8_t kHostAddress = 0;
inline constexpr std::uint8_t kEveryone = 255;

struct FrameHeader {
  std::uint8_t to = 0;
  std::uint8_t from = 0;
  std::uint8_t type = 0;
  std::uint16_t counter = 0;
  bool operator==(const FrameHeader&) const = default;
};

struct Frame {
  FrameHeader header;
  Bytes payload;  ///< points into the decoder's or caller's buffer
};

/// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, no reflection; of "123456789" it is 0x29B1.
[[nodiscard]] std::uint16_t crc16(Bytes data);

/// Writes a whole frame to `out`; returns its size, or 0 when the payload is too long or `out` too small.
[[nodiscard]] std::size_t encodeFrame(const FrameHeader& header, Bytes payload, std::span<std::uint8_t> out);

/// Finds frames in a stream of bytes that may hold noise, halves of frames and several frames in a row.
/// After damage it looks again from the byte behind the false start, so that a good frame is never swallowed.
class FrameDecoder {
public:
  struct Counters {
    std::uint32_t frames = 0;   ///< whole frames with a good checksum
    std::uint32_t badCrc = 0;   ///< frame-like stretches with a wrong checksum
    std::uint32_t skipped = 0;  ///< bytes that belong to no frame
  };

  /// Calls sink(const Frame&) for every whole frame; the payload is valid during the call only.
  template <class Sink>
  void feed(Bytes data, Sink&& sink) {
    for (std::uint8_t byte : data) {
      buffer_[size_++] = byte;
      Frame frame;
      while (size_ > 0 && take(frame)) {
        sink(static_cast<const Frame&>(frame));
        drop(frame.payload.size() + kFrameOverhead);
      }
    }
  }
  /// A silence on the line: a half frame will not be completed. Looks for whole frames inside it, then forgets it.
  template <class Sink>
  void flush(Sink&& sink) {
    while (size_ > 0) {
      skip();
      Frame frame;
      while (size_ > 0 && take(frame)) {
        sink(static_cast<const Frame&>(frame));
        drop(frame.payload.size() + kFrameOverhead);
      }
    }
  }
  [[nodiscard]] bool pending() const { return size_ > 0; }
  [[nodiscard]] const Counters& counters() const { return counters_; }

private:
  bool take(Frame& frame);
  void drop(std::size_t count);
  void skip();

  std::array<std::uint8_t, kMaxFrame> buffer_{};
  std::size_t size_ = 0;
  Counters counters_;
};

}  // namespace tessera::wire
