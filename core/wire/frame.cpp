#include "wire/frame.h"

#include <algorithm>

namespace tessera::wire {

std::uint16_t crc16(Bytes data) {
  std::uint16_t crc = 0xFFFF;
  for (std::uint8_t byte : data) {
    crc = static_cast<std::uint16_t>(crc ^ (byte << 8));
    for (int bit = 0; bit < 8; ++bit) {
      const bool top = (crc & 0x8000U) != 0;
      crc = static_cast<std::uint16_t>(crc << 1);
      if (top) crc = static_cast<std::uint16_t>(crc ^ 0x1021U);
    }
  }
  return crc;
}

std::size_t encodeFrame(const FrameHeader& header, Bytes payload, std::span<std::uint8_t> out) {
  if (payload.size() > kMaxPayload || out.size() < payload.size() + kFrameOverhead) return 0;
  ByteWriter w{out};
  w.u8(kSync);
  w.u8(static_cast<std::uint8_t>(payload.size()));
  w.u8(header.to);
  w.u8(header.from);
  w.u8(header.type);
  w.u16(header.counter);
  w.bytes(payload);
  w.u16(crc16(w.written().subspan(1)));
  return w.size();
}

// Tries to read one frame from the front of the buffer, dropping what cannot be the start of one.
// True: a frame stands at the front. False: more bytes are needed.
bool FrameDecoder::take(Frame& frame) {
  while (size_ > 0) {
    if (buffer_[0] != kSync || (size_ > 1 && buffer_[1] > kMaxPayload)) {
      skip();
      continue;
    }
    if (size_ < 2) return false;
    const std::size_t total = buffer_[1] + kFrameOverhead;
    if (size_ < total) return false;
    const Bytes whole{buffer_.data(), total};
    ByteReader r{whole.subspan(1)};
    const std::size_t n = r.u8();
    frame.header.to = r.u8();
    frame.header.from = r.u8();
    frame.header.type = r.u8();
    frame.header.counter = r.u16();
    frame.payload = r.bytes(n);
    if (r.u16() == crc16(whole.subspan(1, total - 3))) {
      ++counters_.frames;
      return true;
    }
    ++counters_.badCrc;
    skip();
  }
  return false;
}

void FrameDecoder::drop(std::size_t count) {
  const auto begin = buffer_.begin();
  std::copy(begin + static_cast<std::ptrdiff_t>(count), begin + static_cast<std::ptrdiff_t>(size_), begin);
  size_ -= count;
}

// One byte is not the start of a frame; go on at the next sync byte.
void FrameDecoder::skip() {
  std::size_t next = 1;
  while (next < size_ && buffer_[next] != kSync) ++next;
  counters_.skipped += static_cast<std::uint32_t>(next);
  drop(next);
}

}  // namespace tessera::wire
