// A tag reader's bytes as tag reads, as they come, whatever the port cuts them into.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "scan/module_frame.h"
#include "scan/tag_line.h"

namespace tessera::scan {

enum class ReaderForm { HexLines, DecimalLines, ReversedDecimalLines, Module };

/// A read, or a sentence about what came and was none.
using Heard = std::variant<TagRead, Sentence>;

class Reader {
public:
  explicit Reader(ReaderForm form = ReaderForm::HexLines) : form_{form} {}

  [[nodiscard]] ReaderForm form() const { return form_; }
  [[nodiscard]] std::vector<Heard> hear(std::span<const std::uint8_t> bytes);
  /// A line that another way brought, typed by a reader that is a keyboard, say.
  [[nodiscard]] Heard line(std::string_view text) const;
  /// What came before is forgotten: the port was opened anew.
  void reset();
  /// What to send now, asked for every tenth of a second; empty: this reader tells by itself.
  [[nodiscard]] std::vector<std::uint8_t> question();

private:
  void endLine(std::vector<Heard>& heard);

  ReaderForm form_;
  std::string line_;
  ModuleFrames frames_;
  unsigned turn_ = 0;
};

}  // namespace tessera::scan
