#include "link/e32_dialogue.h"

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <random>

namespace tessera::link {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Outcome = E32Dialogue::Outcome;

/// A module in configuration mode, and what may be wrong with it.
class Module {
public:
  /// What comes back for these words.
  Bytes hear(const Bytes& words) {
    if (!words.empty()) said.push_back(words);
    if (words.empty() || silent) return {};
    if (words[0] == 0xC1 && asked++ >= deafFor) return answer(registers);
    if (words[0] == 0xC3 && tellsVersion) return {0xC3, 0x32, 0x27, 0x02};
    if (words[0] == 0xC0 && keeps) std::copy(words.begin(), words.end(), registers.begin());
    if (words[0] == 0xC0 && echoes) return answer(registers);
    return {};
  }
  std::function<Bytes(E32Registers)> answer = [](E32Registers r) { return Bytes(r.begin(), r.end()); };

  E32Registers registers{0xC0, 0x00, 0x00, 0x1A, 0x17, 0x44};
  bool silent = false;
  bool keeps = true;
  bool echoes = true;
  bool tellsVersion = true;
  int deafFor = 0;  ///< questions
  int asked = 0;
  std::vector<Bytes> said;
};

/// Runs it to its end, each byte of an answer on its own, 20 ms after the question. Returns how long it took.
Seconds converse(E32Dialogue& dialogue, Module& module, const Bytes& chatter = {}) {
  Seconds now{100.0};
  std::deque<std::pair<Seconds, std::uint8_t>> line;
  while (dialogue.outcome() == Outcome::Running && now < Seconds{200.0}) {
    const Bytes words = dialogue.poll(now);
    if (!words.empty())
      for (const std::uint8_t byte : chatter) line.emplace_back(now + Seconds{0.001}, byte);
    Seconds at = now + Seconds{0.02};
    for (const std::uint8_t byte : module.hear(words)) line.emplace_back(at += Seconds{0.001}, byte);
    if (dialogue.outcome() != Outcome::Running) break;
    now = std::max(now, dialogue.wake());
    if (!line.empty() && line.front().first <= now) {
      now = line.front().first;
      const std::uint8_t byte = line.front().second;
      line.pop_front();
      dialogue.ingest({&byte, 1}, now);
    }
  }
  return now - Seconds{100.0};
}

TEST(E32DialogueTest, readsWhatTheModuleHolds) {
  Module module;
  E32Dialogue dialogue;
  const Seconds took = converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Done);
  EXPECT_EQ(dialogue.parameters(), decodeE32(module.registers));
  EXPECT_EQ(dialogue.version(), (E32Version{0x32, 0x27, 0x02}));
  EXPECT_LT(took, Seconds{0.5});
  EXPECT_EQ(module.said.size(), 3U) << "asked twice, as one answer could be a chance, and for the version";
}

TEST(E32DialogueTest, doesWithoutAVersion) {
  Module module;
  module.tellsVersion = false;
  E32Dialogue dialogue;
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Done);
  EXPECT_FALSE(dialogue.version());
}

TEST(E32DialogueTest, asksAgainWhereNoAnswerCame) {
  Module module;
  module.deafFor = 2;
  E32Dialogue dialogue;
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Done);
}

TEST(E32DialogueTest, givesAMuteModuleUp) {
  Module module;
  module.silent = true;
  E32Dialogue dialogue;
  const Seconds took = converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Silent);
  EXPECT_FALSE(dialogue.parameters());
  EXPECT_LT(took, Seconds{3.0});
}

TEST(E32DialogueTest, tellsChatterFromSilence) {
  Module module;  // in normal mode: vehicles' frames come out of it, no answer
  module.silent = true;
  E32Dialogue dialogue;
  converse(dialogue, module, {0xA5, 0x09, 0x00, 0x07, 0x84, 0x00, 0x00, 0x2B});
  EXPECT_EQ(dialogue.outcome(), Outcome::Garbled);
}

TEST(E32DialogueTest, findsTheAnswerInRubbish) {
  Module module;
  module.answer = [](E32Registers r) {
    Bytes bytes;
    for (const int byte : {0xFF, 0x00, 0xC0, 0xC0, 0x13}) bytes.push_back(static_cast<std::uint8_t>(byte));
    for (const std::uint8_t byte : r) bytes.push_back(byte);
    return bytes;
  };
  module.registers = {0xC0, 0xC0, 0xC0, 0x3D, 0x18, 0x44};  // the head's byte stands in the address as well
  E32Dialogue dialogue;
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Done);
  EXPECT_EQ(dialogue.parameters(), decodeE32(module.registers));
}

TEST(E32DialogueTest, believesNoAnswerThatIsNotRepeated) {
  Module module;
  std::uint8_t turn = 0;
  module.answer = [&](E32Registers r) {
    r[1] = ++turn;
    return Bytes(r.begin(), r.end());
  };
  E32Dialogue dialogue;
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Garbled);
  EXPECT_FALSE(dialogue.parameters());
}

TEST(E32DialogueTest, writesReadsBackAndCompares) {
  Module module;
  const auto wanted = e32ParametersFor(24, 19200, 115200).value();
  auto dialogue = E32Dialogue::writing(wanted).value();
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Done);
  EXPECT_EQ(dialogue.parameters(), wanted);
  EXPECT_EQ(module.registers, (E32Registers{0xC0, 0x00, 0x00, 0x3D, 0x18, 0x44}));
}

TEST(E32DialogueTest, writesToAModuleThatSaysNothingToAWrite) {
  Module module;
  module.echoes = false;
  auto dialogue = E32Dialogue::writing(e32ParametersFor(24, 2400, 9600).value()).value();
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Done);
}

TEST(E32DialogueTest, saysThatTheModuleDidNotTakeIt) {
  Module module;
  module.keeps = false;
  const auto before = decodeE32(module.registers);
  auto dialogue = E32Dialogue::writing(e32ParametersFor(24, 19200, 115200).value()).value();
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::NotTaken);
  EXPECT_EQ(dialogue.parameters(), before) << "what it still holds";
}

TEST(E32DialogueTest, writesNothingBeforeTheModuleHasAnswered) {
  Module module;
  module.silent = true;  // in normal mode the registers would go on the air
  auto dialogue = E32Dialogue::writing(e32ParametersFor(24, 19200, 115200).value()).value();
  converse(dialogue, module);
  EXPECT_EQ(dialogue.outcome(), Outcome::Silent);
  for (const Bytes& words : module.said) EXPECT_EQ(words, (Bytes{0xC1, 0xC1, 0xC1}));
}

TEST(E32DialogueTest, refusesToWriteWhatNoModuleHas) {
  E32Parameters wanted;
  wanted.channel = 99;
  EXPECT_FALSE(E32Dialogue::writing(wanted));
}

// Whatever comes in, in whatever pieces and at whatever instants: it ends, within seconds, and what it believes was
// said at least twice.
TEST(E32DialogueTest, anyBytesDoNoHarm) {
  std::mt19937 random{7};
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  int believed = 0;
  for (int round = 0; round < 3000; ++round) {
    auto dialogue = below(2) == 0 ? E32Dialogue{} : E32Dialogue::writing(E32Parameters{}).value();
    Seconds now;
    const Bytes favourite{0xC0, 0x00, 0x00, static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(33)),
                          0x44};
    unsigned favourites = 0;
    unsigned steps = 0;
    for (; dialogue.outcome() == Outcome::Running && steps < 5000; ++steps) {
      (void)dialogue.poll(now);
      Bytes piece(below(70));
      for (auto& byte : piece) byte = static_cast<std::uint8_t>(below(4) == 0 ? 0xC0U + below(4) : below(256));
      if (below(3) == 0) {
        ++favourites;
        for (const std::uint8_t byte : favourite) piece.push_back(byte);
      }
      if (below(3) != 0) dialogue.ingest(piece, now);
      now += Seconds{below(100) / 1000.0};
    }
    ASSERT_NE(dialogue.outcome(), Outcome::Running) << "round " << round;
    ASSERT_LT(now, Seconds{40}) << "round " << round;
    if (dialogue.parameters() && *dialogue.parameters() == decodeE32(favourite)) {
      ++believed;
      ASSERT_GE(favourites, 2U);
    }
  }
  EXPECT_GT(believed, 10) << "the test must reach the end of the conversation now and then";
}

}  // namespace
}  // namespace tessera::link
