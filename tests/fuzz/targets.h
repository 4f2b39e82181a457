// What the fuzzers run: each takes any bytes at all and ends the process when a promise is broken. The same functions
// serve libFuzzer (TESSERA_FUZZ) and the seeded loop that every test run makes.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

namespace tessera::fuzz {

using Input = std::vector<std::uint8_t>;

/// Bytes from the radio: decoder, message decoders, commands, replay guard.
void wire(std::span<const std::uint8_t> input);
/// A site file's text: parser, writer, map, check.
void site(std::span<const std::uint8_t> input);
/// A table of tags.
void csv(std::span<const std::uint8_t> input);
/// A LIF layout.
void lif(std::span<const std::uint8_t> input);
/// Bytes from a tag reader, taken for each kind of reader.
void reader(std::span<const std::uint8_t> input);

/// Inputs to begin with: good ones of every kind.
[[nodiscard]] std::vector<Input> wireSeeds();
[[nodiscard]] std::vector<Input> siteSeeds(const std::string& folderOfSites);
[[nodiscard]] std::vector<Input> csvSeeds();
[[nodiscard]] std::vector<Input> lifSeeds();
[[nodiscard]] std::vector<Input> readerSeeds();

/// Not assert(): it must hold in optimised builds as well.
inline void require(bool promise, const char* what) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

}  // namespace tessera::fuzz
