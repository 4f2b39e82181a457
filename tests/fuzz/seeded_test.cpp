// A small fuzzer with a fixed seed, so that every test run fuzzes. Whatever it finds comes back on the next run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

#include "fuzz/targets.h"

namespace tessera::fuzz {
namespace {

constexpr std::array<std::string_view, 22> kWords{
    "{",     "}",      "[",       "]",  "\"",         ",",   ":",    "null", "true", "-0",   "1e308",
    "1e999", "-1e-40", "\\u0000", "\\", "9999999999", "0.1", "\xFF", "\n",   "\"\"", "[[]]", "{\"a\":{}}"};

class Mutator {
public:
  explicit Mutator(std::uint64_t seed) : random_{seed} {}

  Input changed(const std::vector<Input>& seeds) {
    Input input = seeds[below(seeds.size())];
    for (std::size_t n = 1 + below(6); n > 0; --n) change(input, seeds);
    return input;
  }

private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  void change(Input& input, const std::vector<Input>& seeds) {
    const std::size_t at = below(input.size() + 1);
    const auto here = input.begin() + static_cast<std::ptrdiff_t>(at);
    const std::size_t n = std::min(below(20), input.size() - at);
    switch (below(7)) {
      case 0:
        if (n > 0) *here ^= static_cast<std::uint8_t>(1U << below(8));
        break;
      case 1:
        if (n > 0) *here = static_cast<std::uint8_t>(random_());
        break;
      case 2:
        input.erase(here, here + static_cast<std::ptrdiff_t>(n));
        break;
      case 3: {
        const Input copy(here, here + static_cast<std::ptrdiff_t>(n));
        input.insert(input.begin() + static_cast<std::ptrdiff_t>(below(input.size() + 1)), copy.begin(), copy.end());
        break;
      }
      case 4: {
        const std::string_view word = kWords[below(kWords.size())];
        input.insert(here, word.begin(), word.end());
        break;
      }
      case 5:
        input.resize(at);
        break;
      default: {
        const Input& other = seeds[below(seeds.size())];
        const std::size_t from = below(other.size());
        const std::size_t length = std::min(below(200), other.size() - from);
        input.insert(here, other.begin() + static_cast<std::ptrdiff_t>(from),
                     other.begin() + static_cast<std::ptrdiff_t>(from + length));
      }
    }
  }

  std::mt19937_64 random_;
};

TEST(SeededFuzz, bytesFromTheRadioDoNoHarm) {
  const auto seeds = wireSeeds();
  for (const Input& seed : seeds) wire(seed);
  Mutator mutator{1};
  for (int i = 0; i < 50'000; ++i) wire(mutator.changed(seeds));
}

TEST(SeededFuzz, siteFilesDoNoHarm) {
  const auto seeds = siteSeeds(TESSERA_SITES);
  ASSERT_GE(seeds.size(), 3U);
  for (const Input& seed : seeds) site(seed);
  Mutator mutator{2};
  for (int i = 0; i < 4000; ++i) site(mutator.changed(seeds));
  // The small one alone: more of the changes hit something that matters.
  for (int i = 0; i < 20'000; ++i) site(mutator.changed({seeds.back()}));
}

TEST(SeededFuzz, tablesOfTagsDoNoHarm) {
  const auto seeds = csvSeeds();
  for (const Input& seed : seeds) csv(seed);
  Mutator mutator{3};
  for (int i = 0; i < 20'000; ++i) csv(mutator.changed(seeds));
}

TEST(SeededFuzz, layoutsDoNoHarm) {
  const auto seeds = lifSeeds();
  for (const Input& seed : seeds) lif(seed);
  Mutator mutator{4};
  for (int i = 0; i < 10'000; ++i) lif(mutator.changed(seeds));
}

TEST(SeededFuzz, bytesFromATagReaderDoNoHarm) {
  const auto seeds = readerSeeds();
  for (const Input& seed : seeds) reader(seed);
  Mutator mutator{5};
  for (int i = 0; i < 50'000; ++i) reader(mutator.changed(seeds));
}

}  // namespace
}  // namespace tessera::fuzz
