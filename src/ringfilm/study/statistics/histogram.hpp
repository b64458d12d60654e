#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace ringfilm::study {

/// How often several samples fall into equal bins that they share.
struct Histogram {
  std::vector<double> edges;                       ///< one more than bins, rising; empty without a finite value
  std::vector<std::vector<std::uint64_t>> counts;  ///< [sample][bin]
  /// Values beyond the edges, which omit the outermost 0.5 % on each side where they would thin out the rest.
  std::vector<std::uint64_t> below, above;
};

/// @param sorted samples in order, finite
Histogram histogram(const std::vector<std::vector<double>>& sorted);

}  // namespace ringfilm::study
