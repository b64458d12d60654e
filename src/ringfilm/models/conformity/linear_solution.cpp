#include "ringfilm/models/conformity/linear_solution.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace ringfilm::models {

std::vector<double> linear_solution(std::vector<std::vector<double>> A, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i + 1; j < n; ++j) {
      if (std::abs(A[j][i]) > std::abs(A[pivot][i])) pivot = j;
    }
    std::swap(A[i], A[pivot]);
    std::swap(b[i], b[pivot]);
    if (A[i][i] == 0) continue;
    for (std::size_t j = i + 1; j < n; ++j) {
      const double factor = A[j][i] / A[i][i];
      if (factor == 0) continue;
      for (std::size_t k = i; k < n; ++k) A[j][k] -= factor * A[i][k];
      b[j] -= factor * b[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= A[i][k] * b[k];
    b[i] = A[i][i] == 0 ? 0 : b[i] / A[i][i];
  }
  return b;
}

}  // namespace ringfilm::models
