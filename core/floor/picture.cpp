#include "floor/picture.h"

#include <array>
#include <cstdint>

namespace tessera::floor {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 64;

constexpr std::array<std::uint8_t, 256> valuesOfDigits() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoDigit);
  for (std::size_t n = 0; n < kDigits.size(); ++n)
    values[static_cast<unsigned char>(kDigits[n])] = static_cast<std::uint8_t>(n);
  return values;
}
constexpr std::array<std::uint8_t, 256> kValues = valuesOfDigits();

std::uint32_t byteAt(std::string_view bytes, std::size_t at) {
  return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U;
}

}  // namespace

bool isPicture(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1A\n") || bytes.starts_with("\xFF\xD8\xFF");
}

std::string toBase64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::uint32_t group = byteAt(bytes, at) << 16U | byteAt(bytes, at + 1) << 8U | byteAt(bytes, at + 2);
    for (std::size_t n = 0; n < 4; ++n) text += at + n <= bytes.size() ? kDigits[group >> (18U - 6U * n) & 63U] : '=';
  }
  return text;
}

std::optional<std::string> fromBase64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  const std::size_t filling = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  const std::string_view digits = text.substr(0, text.size() - filling);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  for (std::size_t n = 0; n < digits.size(); ++n) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(digits[n])];
    if (value == kNoDigit) return std::nullopt;
    bits = bits << 6U | value;
    // Each digit but a group's first completes a byte.
    if (n % 4 != 0) bytes += static_cast<char>(bits >> (6U - 2U * (n % 4)) & 255U);
  }
  // Bits that are left over are zero: one picture, one text.
  const std::uint32_t rest = filling == 2 ? 15U : filling == 1 ? 3U : 0U;
  if ((bits & rest) != 0) return std::nullopt;
  return bytes;
}

}  // namespace tessera::floor
