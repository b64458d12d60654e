#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ringfilm::base {

/// Numbers in a line of memory, which is as long as the widest pack: a pack that lies across two lines is slow.
inline constexpr std::size_t kNumbersPerLine = 8;

/// Memory for `n` zeros in `memory`, from the beginning of a line on.
inline double* aligned_zeros(std::vector<double>& memory, std::size_t n) {
  memory.assign(n + kNumbersPerLine, 0.0);
  double* first = memory.data();
  while (reinterpret_cast<std::uintptr_t>(first) % (kNumbersPerLine * sizeof(double)) != 0) ++first;
  return first;
}

}  // namespace ringfilm::base
