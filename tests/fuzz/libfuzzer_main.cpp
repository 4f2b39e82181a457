// libFuzzer's entry; FUZZ_TARGET is the function to run.
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tessera::fuzz::FUZZ_TARGET({data, size});
  return 0;
}
