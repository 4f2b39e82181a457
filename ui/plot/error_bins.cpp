#include "ui/plot/error_bins.h"

#include <algorithm>

namespace tessera::ui {

std::vector<double> sharesInBins(const std::vector<double>& errors, double width, int bins) {
  std::vector<double> shares(static_cast<std::size_t>(bins), 0.0);
  for (const double error : errors) {
    if (!(error < width * bins)) continue;
    // The quotient of an error just below the end may be rounded up to the number of bins.
    const int bin = std::min(bins - 1, static_cast<int>(error / width));
    shares[static_cast<std::size_t>(bin)] += 100.0 / static_cast<double>(errors.size());
  }
  return shares;
}

}  // namespace tessera::ui
