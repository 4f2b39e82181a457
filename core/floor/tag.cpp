#include "floor/tag.h"

#include <algorithm>

namespace tessera::floor {
namespace {

bool isUidLength(std::size_t n) { return n == 4 || n == 7 || n == 10; }

int digitOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// What an error shows of a text from outside: its beginning, without control characters.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string s{text.substr(0, longest)};
  std::replace_if(
      s.begin(), s.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return text.size() > longest ? s + "..." : s;
}

}  // namespace

Result<TagUid> TagUid::fromBytes(std::span<const std::uint8_t> bytes) {
  if (!isUidLength(bytes.size())) {
    return failure("A tag's UID has 4, 7 or 10 bytes, not " + std::to_string(bytes.size()) + ".");
  }
  TagUid uid;
  std::copy(bytes.begin(), bytes.end(), uid.bytes_.begin());
  uid.size_ = static_cast<std::uint8_t>(bytes.size());
  return uid;
}

Result<TagUid> TagUid::parse(std::string_view text) {
  std::array<std::uint8_t, 10> bytes{};
  std::size_t digits = 0;
  for (char c : text) {
    // A separator stands between bytes; inside a byte it is more likely a slip than a style.
    if ((c == ':' || c == '-' || c == ' ' || c == '\t') && digits % 2 == 0) continue;
    const int digit = digitOf(c);
    if (digit < 0)
      return failure("\"" + shown(text) + "\" is not a tag's UID: it holds other than hexadecimal digits.");
    if (digits == 2 * bytes.size()) return failure("\"" + shown(text) + "\" is not a tag's UID: it is too long.");
    auto& byte = bytes[digits / 2];
    byte = static_cast<std::uint8_t>((byte << 4) | digit);
    ++digits;
  }
  if (digits % 2 != 0 || !isUidLength(digits / 2)) {
    return failure("\"" + shown(text) + "\" is not a tag's UID: it has " + std::to_string(digits) +
                   " hexadecimal digits instead of 8, 14 or 20.");
  }
  return fromBytes(std::span{bytes}.first(digits / 2));
}

std::string TagUid::text() const {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string s;
  s.reserve(2 * size_);
  for (std::uint8_t byte : bytes()) {
    s += kDigits[byte >> 4];
    s += kDigits[byte & 0x0F];
  }
  return s;
}

std::uint64_t TagUid::hash(std::uint64_t salt) const {
  // The 80 bits and the length in two words, then the finaliser of SplitMix64 (Steele et al., OOPSLA 2014) on each.
  const auto mix = [](std::uint64_t v) {
    v = (v ^ (v >> 30)) * 0xBF58476D1CE4E5B9ULL;
    v = (v ^ (v >> 27)) * 0x94D049BB133111EBULL;
    return v ^ (v >> 31);
  };
  std::uint64_t low = 0;
  for (std::size_t i = 0; i < 8; ++i) low |= std::uint64_t{bytes_[i]} << (8 * i);
  const std::uint64_t high = bytes_[8] | (std::uint64_t{bytes_[9]} << 8) | (std::uint64_t{size_} << 16);
  return mix(low ^ mix(high + (salt + 1) * 0x9E3779B97F4A7C15ULL));
}

}  // namespace tessera::floor

std::size_t std::hash<tessera::floor::TagUid>::operator()(const tessera::floor::TagUid& uid) const noexcept {
  return static_cast<std::size_t>(uid.hash(0));
}
