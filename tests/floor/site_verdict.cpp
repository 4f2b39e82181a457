// Prints one line for each site file named: "taken", or the sentence of its refusal.
#include <iostream>

#include "floor/site_json.h"

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const auto site = tessera::floor::loadSite(argv[i]);
    std::cout << (site ? "taken" : site.error().sentence) << "\n";
  }
}
