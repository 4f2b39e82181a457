// How errors are spread over bins of one width, from zero on.
#pragma once

#include <vector>

namespace tessera::ui {

/// Share of the errors in each bin, percent of all; those at or beyond the end of the last bin are in none. errors: at
/// least one, not negative. width: above 0, in the unit of the errors. bins: at least 1.
[[nodiscard]] std::vector<double> sharesInBins(const std::vector<double>& errors, double width, int bins);

}  // namespace tessera::ui
