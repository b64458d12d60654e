#pragma once
#include <vector>

namespace ringfilm::base {

/// A tridiagonal system in z with one more unknown H: a border column, a border row and a corner.
///
///     lower[i] z[i-1] + diagonal[i] z[i] + upper[i] z[i+1] + column[i] H = rhs[i]
///     sum_i row[i] z[i] + corner H = corner_rhs
///
/// Solved in two sweeps without pivoting, so that a caller can look at the one equation that is left for H (and limit
/// H) before the back substitution. The matrix must not need pivoting; discrete balances of mass do not.
struct BorderedTridiagonal {
  std::vector<double> lower, diagonal, upper, column, row, rhs;
  double corner = 0;
  double corner_rhs = 0;

  explicit BorderedTridiagonal(int n);
  int size() const { return static_cast<int>(diagonal.size()); }

  /// Eliminates z from the border row. Afterwards `corner` H = `corner_rhs` holds for the reduced system; the arrays
  /// are overwritten.
  /// @returns false, with the arrays unusable, if a pivot is zero or no number
  [[nodiscard]] bool eliminate();

  /// z for a given H, after `eliminate`; written into `rhs`.
  void back_substitute(double H);
};

}  // namespace ringfilm::base
