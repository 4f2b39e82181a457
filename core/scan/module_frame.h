// Frames of serial modules around an MFRC522 that are asked for each tag (docs/readers.md states every byte).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "floor/tag.h"

namespace tessera::scan {

/// Finds answers that carry a UID among any bytes. Keeps at most one frame's bytes.
class ModuleFrames {
public:
  static constexpr std::size_t kLongest = 64;  ///< of a body, check byte included

  /// The UID that this byte completes.
  [[nodiscard]] std::optional<floor::TagUid> feed(std::uint8_t byte);
  void reset() { *this = {}; }

private:
  enum class State { Idle, Second, LengthLow, LengthHigh, Body };
  [[nodiscard]] std::optional<floor::TagUid> uidOfBody() const;

  State state_ = State::Idle;
  std::size_t length_ = 0;
  std::size_t size_ = 0;
  std::array<std::uint8_t, kLongest> body_{};
  bool stuffed_ = false;  ///< the last byte of the body was AA: a 00 behind it does not count
};

/// What to ask, in turns of a tenth of a second: a card in the field, its UID of 4 bytes, a card, its UID of 7.
[[nodiscard]] std::vector<std::uint8_t> moduleQuestion(unsigned turn);

}  // namespace tessera::scan
