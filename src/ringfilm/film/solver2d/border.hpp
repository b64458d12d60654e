#pragma once
#include <functional>
#include <vector>

#include "ringfilm/film/kernels/film2d_kernels.hpp"

namespace ringfilm::film {

/// The border of a linear system: a few unknowns b of the whole two-dimensional film next to those of its nodes x,
///
///     A x + C b = f,   R x + D b = g.
///
/// It is eliminated with Y, what an approximate solve makes of A Y = C: (D - R Y) b = g - R x, then x - Y b.
class Border {
 public:
  using Solve = std::function<void(const double* rhs, double* x)>;

  /// @param n numbers of a vector x; @param column, row of the first unknown, which the caller keeps and fills
  Border(const Film2dKernels& kernels, std::size_t n, int count, double* column, double* row);

  int count() const { return count_; }
  double* column(int k) { return column_[k]; }                                                ///< of C
  double* row(int k) { return row_[k]; }                                                      ///< of R
  double& corner(int k, int l) { return corner_[static_cast<std::size_t>(k) * count_ + l]; }  ///< of D

  /// Columns of Y.
  void solve_columns(const Solve& approximately);

  /// D - R Y, of the unknowns from `first` on. @returns false where it does not fall with each of them
  bool factor(int first);

  /// y += C b.
  void add_columns(const double* b, double* y) const;
  /// `to` = R x + D b.
  void multiply(const double* x, const double* b, double* to) const;
  /// Brings f's approximate solution x and g to those of the whole system. Unknowns before that of factor() are 0.
  void eliminate(const double* g, double* x, double* b);

 private:
  double slope(int k, int l) const { return corner_[static_cast<std::size_t>(k) * count_ + l]; }
  double& lu(int k, int l) { return lu_[static_cast<std::size_t>(k) * count_ + l]; }
  double lu(int k, int l) const { return lu_[static_cast<std::size_t>(k) * count_ + l]; }

  const Film2dKernels* kernels_;
  std::size_t n_;
  int count_, first_ = 0;
  std::vector<std::vector<double>> memory_;  ///< of the columns and rows but the first
  std::vector<double*> column_, row_;
  std::vector<std::vector<double>> solution_;  ///< Y
  std::vector<double> corner_, lu_;
  std::vector<double> left_;  ///< of g, while it is eliminated
  std::vector<int> order_;    ///< of the rows after the exchanges of pivots
};

}  // namespace ringfilm::film
