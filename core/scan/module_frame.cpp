#include "scan/module_frame.h"

#include <algorithm>

namespace tessera::scan {
namespace {

constexpr std::uint8_t kFirst = 0xAA;
constexpr std::uint8_t kSecond = 0xBB;
constexpr std::uint8_t kCascade =
    0x88;  // stands before the first three bytes of a longer UID, never at a short one's head
constexpr unsigned kRequest = 0x0201;
constexpr unsigned kAnticollision = 0x0202;
constexpr unsigned kSelectLong = 0x0212;

std::vector<std::uint8_t> question(unsigned command, std::initializer_list<std::uint8_t> data) {
  std::vector<std::uint8_t> body{0xFF, 0xFF, static_cast<std::uint8_t>(command & 0xFFU),
                                 static_cast<std::uint8_t>(command >> 8U)};
  body.insert(body.end(), data);
  std::uint8_t check = 0;
  for (const std::uint8_t byte : body) check = static_cast<std::uint8_t>(check ^ byte);
  body.push_back(check);
  std::vector<std::uint8_t> frame{kFirst, kSecond, static_cast<std::uint8_t>(body.size()), 0};
  for (const std::uint8_t byte : body) {
    frame.push_back(byte);
    if (byte == kFirst) frame.push_back(0);
  }
  return frame;
}

}  // namespace

std::vector<std::uint8_t> moduleQuestion(unsigned turn) {
  switch (turn % 4) {
    case 1:
      return question(kAnticollision, {0x04});
    case 3:
      return question(kSelectLong, {});
    default:
      return question(kRequest, {0x52});
  }
}

std::optional<floor::TagUid> ModuleFrames::feed(std::uint8_t byte) {
  switch (state_) {
    case State::Idle:
      if (byte == kFirst) state_ = State::Second;
      return std::nullopt;
    case State::Second:
      state_ = byte == kSecond ? State::LengthLow : byte == kFirst ? State::Second : State::Idle;
      return std::nullopt;
    case State::LengthLow:
      length_ = byte;
      state_ = State::LengthHigh;
      return std::nullopt;
    case State::LengthHigh:
      length_ |= static_cast<std::size_t>(byte) << 8U;
      size_ = 0;
      stuffed_ = false;
      state_ = length_ >= 6 && length_ <= kLongest ? State::Body : State::Idle;
      return std::nullopt;
    case State::Body:
      break;
  }
  if (stuffed_) {
    stuffed_ = false;
    if (byte == 0) return std::nullopt;
    // AA BB cannot stand within a body: the rest of this frame was lost and the next one begins.
    if (byte == kSecond) {
      state_ = State::LengthLow;
      return std::nullopt;
    }
  }
  body_[size_++] = byte;
  stuffed_ = byte == kFirst;
  if (size_ < length_) return std::nullopt;
  // A check byte AA has its 00 behind it still; outside of a frame that is passed over by itself.
  state_ = State::Idle;
  return uidOfBody();
}

std::optional<floor::TagUid> ModuleFrames::uidOfBody() const {
  const auto body = std::span{body_}.first(size_);
  std::uint8_t check = 0;
  for (const std::uint8_t byte : body) check = static_cast<std::uint8_t>(check ^ byte);
  if (check != 0 || body[4] != 0) return std::nullopt;  // damaged, or "no card"
  const unsigned command = body[2] | static_cast<unsigned>(body[3]) << 8U;
  const auto data = body.subspan(5, body.size() - 6);
  const bool shortOne = command == kAnticollision && data.size() == 4 && data[0] != kCascade;
  const bool longOne = command == kSelectLong && data.size() == 7;
  if (!shortOne && !longOne) return std::nullopt;
  return *floor::TagUid::fromBytes(data);
}

}  // namespace tessera::scan
