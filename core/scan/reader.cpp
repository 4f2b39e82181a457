#include "scan/reader.h"

#include <algorithm>

namespace tessera::scan {
namespace {

constexpr std::uint8_t kStartOfText = 0x02;
constexpr std::uint8_t kEndOfText = 0x03;

bool endsLine(std::uint8_t byte) { return byte == '\r' || byte == '\n' || byte == kEndOfText; }

}  // namespace

Heard Reader::line(std::string_view text) const {
  const LineForm form = form_ == ReaderForm::DecimalLines           ? LineForm::Decimal
                        : form_ == ReaderForm::ReversedDecimalLines ? LineForm::ReversedDecimal
                                                                    : LineForm::Hex;
  auto read = readLine(text, form);
  if (read) return *read;
  return read.error().sentence;
}

void Reader::endLine(std::vector<Heard>& heard) {
  const bool blank = std::all_of(line_.begin(), line_.end(), [](char c) { return c == ' ' || c == '\t' || c == '\0'; });
  if (!blank && line_.size() <= kLongestLine) heard.push_back(line(line_));
  line_.clear();
}

std::vector<Heard> Reader::hear(std::span<const std::uint8_t> bytes) {
  std::vector<Heard> heard;
  for (const std::uint8_t byte : bytes) {
    if (form_ == ReaderForm::Module) {
      if (const auto uid = frames_.feed(byte)) heard.emplace_back(TagRead{*uid, std::nullopt});
    } else if (endsLine(byte)) {
      endLine(heard);
    } else if (byte == kStartOfText) {
      line_.clear();
    } else if (line_.size() <= kLongestLine) {  // one more than can be a read is enough to know that it is none
      line_ += static_cast<char>(byte);
      if (line_.size() > kLongestLine)
        heard.emplace_back(phrase("Core", "The reader sends other than lines: check its kind and baud rate."));
    }
  }
  return heard;
}

void Reader::reset() {
  line_.clear();
  frames_.reset();
  turn_ = 0;
}

std::vector<std::uint8_t> Reader::question() {
  return form_ == ReaderForm::Module ? moduleQuestion(turn_++) : std::vector<std::uint8_t>{};
}

}  // namespace tessera::scan
