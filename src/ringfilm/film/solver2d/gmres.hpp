#pragma once
#include <functional>
#include <vector>

#include "ringfilm/film/kernels/film2d_kernels.hpp"

namespace ringfilm::film {

/// Restarted GMRES @cite saad1986 from x = 0.
class Gmres {
 public:
  Gmres(const Film2dKernels& kernels, std::size_t n);

  struct Report {
    int iterations = 0;
    double reduction = 1;  ///< reduction of the residual's norm [-]
  };
  /// @param map y = A x, of vectors of n; @param b right-hand side; @param x the solution
  /// @param reduction of the residual at which to stop [-]
  Report solve(const std::function<void(const double* x, double* y)>& map, const double* b, double reduction,
               double* x);

 private:
  static constexpr int kRestart = 40, kMaxIterations = 400;
  double* basis(int k) { return basis_[k].data(); }
  void combine(int count, double* x);

  const Film2dKernels* kernels_;
  std::size_t n_;
  std::vector<std::vector<double>> basis_;
  std::vector<double> residual_, image_;
  std::vector<std::vector<double>> column_;  ///< columns of the triangular factor
  std::vector<double> cosine_, sine_, rotated_;
};

}  // namespace ringfilm::film
