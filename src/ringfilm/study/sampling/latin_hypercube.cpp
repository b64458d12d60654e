#include "ringfilm/study/sampling/latin_hypercube.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::study {

std::uint64_t shuffled(std::uint64_t i, std::uint64_t n, std::uint64_t seed) {
  if (i >= n) throw std::out_of_range("no such place in an order");
  if (n == 1) return 0;
  constexpr int kRounds = 8;
  const auto half = static_cast<int>(std::bit_width(n - 1) + 1) /
                    2;  // digits of each half; at most four times n numbers to walk among
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  std::uint64_t walked = i;
  do {
    std::uint64_t left = walked >> half, right = walked & mask;
    for (int round = 0; round < kRounds; ++round) {
      const std::uint64_t next = left ^ (hash(seed, round, right) >> (64 - half));
      left = right;
      right = next;
    }
    walked = left << half | right;
  } while (walked >= n);
  return walked;
}

double LatinHypercube::share(std::uint64_t point, std::size_t dimension) const {
  const std::uint64_t seed = hash(seed_, dimension);
  const auto part = static_cast<double>(shuffled(point, n_points_, seed));
  const double within = share_of(hash(seed, n_points_, point));
  // With very many points the sum may round to the upper end of the last part.
  return std::min((part + within) / static_cast<double>(n_points_), 1 - 0x1.0p-53);
}

}  // namespace ringfilm::study
