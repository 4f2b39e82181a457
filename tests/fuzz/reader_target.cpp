#include <cmath>

#include "fuzz/targets.h"
#include "scan/reader.h"

namespace tessera::fuzz {
namespace {

using scan::ReaderForm;

constexpr ReaderForm kForms[] = {ReaderForm::HexLines, ReaderForm::DecimalLines, ReaderForm::ReversedDecimalLines,
                                 ReaderForm::Module};

void requireGood(const scan::Heard& heard) {
  if (const auto* read = std::get_if<scan::TagRead>(&heard)) {
    const std::size_t n = read->uid.bytes().size();
    require(n == 4 || n == 7 || n == 10, "a UID has one of three lengths");
    require(!read->place || (std::abs(read->place->x.value()) <= 1e5 && std::abs(read->place->y.value()) <= 1e5),
            "a place is one that a site may hold");
    return;
  }
  const std::string& sentence = std::get<Sentence>(heard).english();
  require(sentence.ends_with(".") && sentence.size() < 200, "what is no read is told in a short sentence");
}

Input readerInput(std::string_view text) { return {text.begin(), text.end()}; }

}  // namespace

void reader(std::span<const std::uint8_t> input) {
  for (const ReaderForm form : kForms) {
    scan::Reader whole{form};
    const auto heard = whole.hear(input);
    for (const auto& h : heard) requireGood(h);
    // However the port cuts it, it is the same.
    scan::Reader cut{form};
    std::size_t n = 0;
    for (const std::uint8_t byte : input) {
      for (const auto& h : cut.hear({&byte, 1})) require(n < heard.size() && h == heard[n++], "bytes one by one");
    }
    require(n == heard.size(), "nothing is lost between two bytes");
    // Never stuck: a frame that was begun may swallow some good ones, never all. (For hexadecimal lines a decimal UID
    // of ten digits is a sentence.)
    const std::vector<std::uint8_t> good =
        form == ReaderForm::Module
            ? std::vector<std::uint8_t>{0xAA, 0xBB, 0x0A, 0, 0x52, 0x51, 0x02, 0x02, 0, 0x4C, 0xD9, 0, 0x80, 0x16}
            : readerInput("\r\n0077705923\r\n");
    std::size_t reads = 0;
    for (int i = 0; i < 8; ++i) reads = whole.hear(good).size();
    require(reads == 1, "it goes on after anything");
  }
}

std::vector<Input> readerSeeds() {
  return {readerInput("04A1B2C3\r\n04:A1:B2:C3:D4:E5:F6@12.35,-0.6\r\n"),
          readerInput("0077705923\r\n3283263748 @ 1,2\n69495546249912580\r"),
          readerInput("\x02"
                      "0102030405060708090A\x03"),
          {0xAA, 0xBB, 0x0A, 0, 0x52, 0x51, 0x02, 0x02, 0, 0x4C, 0xD9, 0, 0x80, 0x16},
          {0xAA, 0xBB, 0x0D, 0, 0x52, 0x51, 0x12, 0x02, 0, 4, 0xAA, 0, 0xB2, 0xC3, 0xD4, 0xE5, 0xF6, 0x0B},
          {0xAA, 0xBB, 0x06, 0, 0x52, 0x51, 0x01, 0x02, 0x14, 0x14}};
}

}  // namespace tessera::fuzz
