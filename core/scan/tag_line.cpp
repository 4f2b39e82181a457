#include "scan/tag_line.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace tessera::scan {
namespace {

constexpr double kFarthest = 100'000.0;  // as in a site file

std::string quoted(std::string_view text) {
  std::string s{text.substr(0, 40)};
  std::replace_if(
      s.begin(), s.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return "\"" + s + (text.size() > 40 ? "...\"" : "\"");
}

bool isFiller(char c) { return c == ' ' || c == '\t' || c == '\0'; }

std::string_view stripped(std::string_view text) {
  while (!text.empty() && isFiller(text.front())) text.remove_prefix(1);
  while (!text.empty() && isFiller(text.back())) text.remove_suffix(1);
  return text;
}

// "UID: 04 A1 B2 C3", "Card UID=...": what small programs on a microcontroller like to print.
std::string_view withoutLabel(std::string_view text) {
  for (const std::string_view label : {"UID", "uid", "Uid"}) {
    const auto at = text.find(label);
    if (at == std::string_view::npos) continue;
    text = stripped(text.substr(at + label.size()));
    if (!text.empty() && (text.front() == ':' || text.front() == '=')) text.remove_prefix(1);
    return stripped(text);
  }
  return text;
}

Result<floor::TagUid> decimalUid(std::string_view digits, bool reversed) {
  const auto wrong = [&] {
    return failure(phrase("Core", "The reader sent %1, which is no UID as a decimal number.").with(quoted(digits)));
  };
  // 4 bytes have at most 10 digits, 7 bytes 17 and 10 bytes 25. Readers fill up with zeros to 10.
  if (digits.empty() || digits.size() > 25) return wrong();
  const std::size_t size = digits.size() <= 10 ? 4 : digits.size() <= 17 ? 7 : 10;
  std::array<std::uint8_t, 10> bytes{};
  for (const char c : digits) {
    if (c < '0' || c > '9') return wrong();
    unsigned carry = static_cast<unsigned>(c - '0');
    for (std::size_t i = size; i-- > 0;) {
      carry += bytes[i] * 10U;
      bytes[i] = static_cast<std::uint8_t>(carry & 0xFFU);
      carry >>= 8U;
    }
    if (carry != 0) return wrong();
  }
  if (reversed) std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
  return floor::TagUid::fromBytes(std::span{bytes}.first(size));
}

std::optional<Metres> coordinate(std::string_view text) {
  text = stripped(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double v = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), v, std::chars_format::fixed);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || !(std::abs(v) <= kFarthest)) return {};
  return Metres{v + 0.0};
}

std::optional<Point> recordOf(std::string_view text) {
  const auto comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = coordinate(text.substr(0, comma));
  const auto y = coordinate(text.substr(comma + 1));
  return x && y ? std::optional{Point{*x, *y}} : std::nullopt;
}

}  // namespace

Result<TagRead> readLine(std::string_view line, LineForm form) {
  if (line.size() > kLongestLine)
    return failure(phrase("Core", "The reader sent %1, which is too long for a UID.").with(quoted(line)));
  const auto at = line.find('@');
  const std::string_view digits = withoutLabel(stripped(line.substr(0, at)));
  TagRead read;
  if (form == LineForm::Hex) {
    const auto uid = floor::TagUid::parse(digits);
    if (!uid)
      return failure(phrase("Core", "The reader sent %1, which is no UID of 4, 7 or 10 bytes.").with(quoted(line)));
    read.uid = *uid;
  } else {
    const auto uid = decimalUid(digits, form == LineForm::ReversedDecimal);
    if (!uid) return passOn(uid);
    read.uid = *uid;
  }
  if (at == std::string_view::npos) return read;
  read.place = recordOf(line.substr(at + 1));
  if (!read.place)
    return failure(phrase("Core", "Tag %1 holds %2, which is no place: expected @X,Y in metres.")
                       .with(read.uid.text(), quoted(stripped(line.substr(at)))));
  return read;
}

}  // namespace tessera::scan
