// Writes the seeds of the radio's fuzzer into the folder named, one file each.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "fuzz/targets.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_write_seeds FOLDER\n";
    return 2;
  }
  std::filesystem::create_directories(argv[1]);
  int n = 0;
  for (const auto& seed : tessera::fuzz::wireSeeds()) {
    std::ofstream out{std::filesystem::path{argv[1]} / ("seed-" + std::to_string(n++)), std::ios::binary};
    out.write(reinterpret_cast<const char*>(seed.data()), static_cast<std::streamsize>(seed.size()));
  }
}
