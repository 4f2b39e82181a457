#include "sim/qemu/trace_reader.h"

#include <gtest/gtest.h>

namespace tessera::sim {
namespace {

TEST(TraceReader, readsAWriteToThePwmBlock) {
  const TraceEvent event = parseTraceLine("PWM: unimplemented device write (size 4, offset 0x098, value 0x000004e1)");
  EXPECT_EQ(event, TraceEvent(PwmWrite{0x098, 0x4e1}));
}

TEST(TraceReader, readsTheLevelOfAnOutput) {
  const TraceEvent event = parseTraceLine("pl061_set_output /machine/unattached/device[12] setting output 1 to 1");
  EXPECT_EQ(event, TraceEvent(PinLevel{"/machine/unattached/device[12]", 1, true}));
}

TEST(TraceReader, readsThatAPortWasReset) {
  EXPECT_EQ(parseTraceLine("pl061_reset /machine/unattached/device[8] reset"),
            TraceEvent(PortReset{"/machine/unattached/device[8]"}));
}

TEST(TraceReader, takesEverythingElseForARemark) {
  for (const char* line :
       {"", "qemu-system-arm: could not load kernel", "PWM: unimplemented device read (size 4)",
        "PWM: unimplemented device write (size 4, offset 0xZZ, value 0x1)", "pl061_set_output /x setting output 9 to 1",
        "pl061_set_output /x setting output 1 to 2", "pl061_set_output", "pl061_reset",
        "PWM: unimplemented device write (size 4, offset 0x098"}) {
    EXPECT_EQ(parseTraceLine(line), TraceEvent(Remark{line})) << line;
  }
}

TEST(LineCutter, putsTogetherALineThatComesInPieces) {
  LineCutter cutter;
  std::vector<std::string> lines;
  const auto sink = [&lines](std::string_view line) { lines.emplace_back(line); };
  cutter.feed("on", sink);
  cutter.feed("e\r\ntwo\n\nthr", sink);
  EXPECT_EQ(lines, (std::vector<std::string>{"one", "two", ""}));
  EXPECT_EQ(cutter.pending(), "thr");
}

}  // namespace
}  // namespace tessera::sim
