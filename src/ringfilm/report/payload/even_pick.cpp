#include "ringfilm/report/payload/even_pick.hpp"

#include <algorithm>

#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::report {

std::vector<std::uint64_t> evenly_picked(std::uint64_t n, std::uint64_t most) {
  const std::uint64_t n_picked = std::min(n, most);
  std::vector<std::uint64_t> picked;
  for (std::uint64_t k = 0; k < n_picked; ++k) {
    const std::uint64_t begin = k * n / n_picked, end = (k + 1) * n / n_picked;
    picked.push_back(begin + study::below(end - begin, study::hash(n, k)));
  }
  return picked;
}

}  // namespace ringfilm::report
