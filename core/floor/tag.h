// The number that identifies one RFID transponder.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace tessera::floor {

/// UID of an ISO 14443-A tag: 4, 7 or 10 bytes. A default one is empty and belongs to no tag.
class TagUid {
public:
  TagUid() = default;
  /// Error: a length other than 4, 7 or 10 bytes.
  [[nodiscard]] static Result<TagUid> fromBytes(std::span<const std::uint8_t> bytes);
  /// Hexadecimal digits, upper or lower case, optionally parted by ':', '-' or blanks. Error: names the text.
  [[nodiscard]] static Result<TagUid> parse(std::string_view text);

  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  /// Upper-case hexadecimal digits without separators.
  [[nodiscard]] std::string text() const;
  /// Well spread 64 bits; another salt gives an unrelated value.
  [[nodiscard]] std::uint64_t hash(std::uint64_t salt) const;
  auto operator<=>(const TagUid&) const = default;

private:
  std::array<std::uint8_t, 10> bytes_{};
  std::uint8_t size_ = 0;
};

}  // namespace tessera::floor

template <>
struct std::hash<tessera::floor::TagUid> {
  std::size_t operator()(const tessera::floor::TagUid& uid) const noexcept;
};
