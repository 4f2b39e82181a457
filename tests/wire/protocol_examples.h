// The worked examples of docs/protocol.md, made by the program itself: the document is held to them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tessera::wire {

struct Example {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// In the order of the document. Whole frames, but for `crc` and the keys.
[[nodiscard]] std::vector<Example> protocolExamples();

}  // namespace tessera::wire
