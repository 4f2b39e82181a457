// The conversation with an E32 module in configuration mode: asks for its registers, or writes them, reads them back
// and compares. Sans IO: bytes and time in, bytes and an outcome out. What else is on the line (frames of vehicles
// when the module is in normal mode after all, noise after a change of jumpers) is passed over: an answer counts when
// the module gives the same one twice.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/units.h"
#include "link/e32_parameters.h"

namespace tessera::link {

class E32Dialogue {
public:
  static constexpr Seconds kNever{std::numeric_limits<double>::infinity()};

  enum class Outcome {
    Running,
    Done,      ///< parameters() holds what the module holds; after a write, that is what was written
    Silent,    ///< not one byte came
    Garbled,   ///< bytes came, but no answer among them
    NotTaken,  ///< it answers, and holds something else than was written: parameters()
  };

  /// Reads.
  E32Dialogue() = default;
  /// Writes to the module's lasting memory. Error: parameters that no module has.
  [[nodiscard]] static Result<E32Dialogue> writing(const E32Parameters& wanted);

  /// Bytes for the module, often none. Call when bytes came and at wake() at the latest. The first call begins.
  [[nodiscard]] std::vector<std::uint8_t> poll(Seconds now);
  void ingest(wire::Bytes bytes, Seconds now);
  [[nodiscard]] Seconds wake() const;
  [[nodiscard]] Outcome outcome() const { return outcome_; }
  /// The newest that the module has told twice.
  [[nodiscard]] const std::optional<E32Parameters>& parameters() const { return parameters_; }
  /// Nullopt: the module does not tell; some do not.
  [[nodiscard]] const std::optional<E32Version>& version() const { return version_; }

private:
  enum class Step { Begin, Asking, Writing, AskingVersion, Over };
  std::vector<std::uint8_t> say(Step step, wire::Bytes words, Seconds now, Seconds patience);
  std::vector<std::uint8_t> ask(Seconds now);
  std::vector<std::uint8_t> writeOrEnd(Seconds now);
  std::vector<std::uint8_t> heardParameters(Seconds now);
  [[nodiscard]] std::optional<E32Parameters> answer() const;
  [[nodiscard]] bool answered() const;
  std::vector<std::uint8_t> end(Outcome outcome);

  std::optional<E32Registers> toWrite_;
  std::optional<E32Parameters> wanted_;
  std::optional<E32Parameters> once_;  ///< told once, to be told again
  std::optional<E32Parameters> parameters_;
  std::optional<E32Version> version_;
  std::vector<std::uint8_t> heard_;  ///< since the last question
  bool anything_ = false;
  Step step_ = Step::Begin;
  Outcome outcome_ = Outcome::Running;
  Seconds deadline_{0.0};
  Seconds lastByte_{0.0};
  int asked_ = 0;
  int written_ = 0;
};

}  // namespace tessera::link
