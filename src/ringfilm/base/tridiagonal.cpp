#include "ringfilm/base/tridiagonal.hpp"

#include <cmath>

namespace ringfilm::base {

BorderedTridiagonal::BorderedTridiagonal(int n) : lower(n), diagonal(n), upper(n), column(n), row(n), rhs(n) {}

bool BorderedTridiagonal::eliminate() {
  const int n = size();
  for (int i = 0; i < n; ++i) {
    if (!(std::abs(diagonal[i]) > 0)) return false;
    const double inverse = 1 / diagonal[i];
    upper[i] *= inverse;
    column[i] *= inverse;
    rhs[i] *= inverse;
    if (i + 1 < n) {
      diagonal[i + 1] -= lower[i + 1] * upper[i];
      column[i + 1] -= lower[i + 1] * column[i];
      rhs[i + 1] -= lower[i + 1] * rhs[i];
      row[i + 1] -= row[i] * upper[i];
    }
    corner -= row[i] * column[i];
    corner_rhs -= row[i] * rhs[i];
  }
  return true;
}

void BorderedTridiagonal::back_substitute(double H) {
  const int n = size();
  rhs[n - 1] -= column[n - 1] * H;
  for (int i = n - 2; i >= 0; --i) rhs[i] -= column[i] * H + upper[i] * rhs[i + 1];
}

}  // namespace ringfilm::base
