#include "link/e32_dialogue.h"

#include <algorithm>

namespace tessera::link {
namespace {

constexpr Seconds kAnswerPatience{0.4};  // the module answers within some 20 ms, adapters and networks add to that
constexpr Seconds kQuiet{0.03};          // after an answer's last byte: nothing follows
constexpr Seconds kKeepTime{0.3};        // for the module to keep what was written
constexpr int kMostQuestions = 5;        // without two equal answers
constexpr int kMostWrites = 3;
constexpr std::size_t kMostHeard = 1024;  // a module in normal mode may speak without end

}  // namespace

Result<E32Dialogue> E32Dialogue::writing(const E32Parameters& wanted) {
  auto registers = encodeE32(wanted);
  if (!registers) return tl::unexpected{registers.error()};
  E32Dialogue dialogue;
  dialogue.toWrite_ = *registers;
  dialogue.wanted_ = wanted;
  return dialogue;
}

Seconds E32Dialogue::wake() const {
  if (step_ == Step::Over) return kNever;
  return answered() ? std::min(deadline_, lastByte_ + kQuiet) : deadline_;
}

void E32Dialogue::ingest(wire::Bytes bytes, Seconds now) {
  if (bytes.empty() || step_ == Step::Begin || step_ == Step::Over) return;
  anything_ = true;
  lastByte_ = now;
  const std::size_t room = kMostHeard - std::min(kMostHeard, heard_.size());
  heard_.insert(heard_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(room, bytes.size())));
}

// The last six bytes in a row that can be an answer: rubbish comes before it.
std::optional<E32Parameters> E32Dialogue::answer() const {
  const wire::Bytes all{heard_};
  for (std::size_t end = all.size(); end >= kE32RegistersSize; --end)
    if (const auto found = decodeE32(all.subspan(end - kE32RegistersSize, kE32RegistersSize))) return found;
  return std::nullopt;
}

bool E32Dialogue::answered() const {
  if (step_ == Step::AskingVersion) return heard_.size() >= 4;
  return step_ == Step::Asking && answer().has_value();
}

std::vector<std::uint8_t> E32Dialogue::say(Step step, wire::Bytes words, Seconds now, Seconds patience) {
  step_ = step;
  heard_.clear();
  deadline_ = now + patience;
  return {words.begin(), words.end()};
}

std::vector<std::uint8_t> E32Dialogue::ask(Seconds now) {
  if (asked_ == kMostQuestions) return end(anything_ ? Outcome::Garbled : Outcome::Silent);
  ++asked_;
  return say(Step::Asking, kE32Read, now, kAnswerPatience);
}

std::vector<std::uint8_t> E32Dialogue::end(Outcome outcome) {
  step_ = Step::Over;
  outcome_ = outcome;
  return {};
}

std::vector<std::uint8_t> E32Dialogue::poll(Seconds now) {
  if (step_ != Step::Begin && now < wake()) return {};
  switch (step_) {
    case Step::Begin:
      return ask(now);
    case Step::Asking:
      return heardParameters(now);
    case Step::Writing:
      asked_ = 0;
      once_.reset();
      return ask(now);
    case Step::AskingVersion:
      for (std::size_t at = 0; at + 4 <= heard_.size() && !version_; ++at)
        version_ = decodeE32Version(wire::Bytes{heard_}.subspan(at, 4));
      return end(Outcome::Done);
    case Step::Over:
      break;
  }
  return {};
}

std::vector<std::uint8_t> E32Dialogue::heardParameters(Seconds now) {
  const auto told = answer();
  const bool twice = told && told == once_;
  once_ = told;
  if (!twice) return ask(now);
  parameters_ = told;
  if (wanted_ && (written_ == 0 || told != wanted_)) return writeOrEnd(now);
  return say(Step::AskingVersion, kE32AskVersion, now, kAnswerPatience);
}

// Only after the module has answered, so that nothing of this goes on the air by mistake.
std::vector<std::uint8_t> E32Dialogue::writeOrEnd(Seconds now) {
  if (written_ == kMostWrites) return end(Outcome::NotTaken);
  ++written_;
  return say(Step::Writing, *toWrite_, now, kKeepTime);
}

}  // namespace tessera::link
