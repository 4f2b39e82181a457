// Little-endian reading and writing over a caller's buffer. Neither ever leaves its span: an overrun sets a flag
// that the caller asks once, at the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tessera::wire {

using Bytes = std::span<const std::uint8_t>;

class ByteWriter {
public:
  explicit ByteWriter(std::span<std::uint8_t> out) : out_{out} {}
  void u8(std::uint8_t v) {
    if (size_ < out_.size())
      out_[size_++] = v;
    else
      overrun_ = true;
  }
  void u16(std::uint16_t v) {
    u8(static_cast<std::uint8_t>(v));
    u8(static_cast<std::uint8_t>(v >> 8));
  }
  void u32(std::uint32_t v) {
    u16(static_cast<std::uint16_t>(v));
    u16(static_cast<std::uint16_t>(v >> 16));
  }
  void i16(std::int16_t v) { u16(static_cast<std::uint16_t>(v)); }
  void i32(std::int32_t v) { u32(static_cast<std::uint32_t>(v)); }
  void bytes(Bytes v) {
    for (std::uint8_t b : v) u8(b);
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t room() const { return out_.size() - size_; }
  [[nodiscard]] bool overrun() const { return overrun_; }
  [[nodiscard]] Bytes written() const { return {out_.data(), size_}; }

private:
  std::span<std::uint8_t> out_;
  std::size_t size_ = 0;
  bool overrun_ = false;
};

class ByteReader {
public:
  explicit ByteReader(Bytes in) : in_{in} {}
  std::uint8_t u8() {
    if (at_ < in_.size()) return in_[at_++];
    overrun_ = true;
    return 0;
  }
  std::uint16_t u16() {
    const std::uint16_t low = u8();
    return static_cast<std::uint16_t>(low | (u8() << 8));
  }
  std::uint32_t u32() {
    const std::uint32_t low = u16();
    return low | (std::uint32_t{u16()} << 16);
  }
  std::int16_t i16() { return static_cast<std::int16_t>(u16()); }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  /// The next n bytes, or an empty span (and the overrun flag) when there are fewer.
  Bytes bytes(std::size_t n) {
    if (n > remaining()) {
      overrun_ = true;
      return {};
    }
    at_ += n;
    return in_.subspan(at_ - n, n);
  }
  [[nodiscard]] std::size_t remaining() const { return in_.size() - at_; }
  [[nodiscard]] bool overrun() const { return overrun_; }

private:
  Bytes in_;
  std::size_t at_ = 0;
  bool overrun_ = false;
};

}  // namespace tessera::wire
