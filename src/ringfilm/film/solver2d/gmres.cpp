#include "ringfilm/film/solver2d/gmres.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {

Gmres::Gmres(const Film2dKernels& kernels, std::size_t n) : kernels_(&kernels), n_(n), residual_(n), image_(n) {}

void Gmres::combine(int count, double* x) {
  std::vector<double> share(count);
  for (int k = count - 1; k >= 0; --k) {
    double rest = rotated_[k];
    for (int j = k + 1; j < count; ++j) rest -= column_[j][k] * share[j];
    share[k] = rest / column_[k][k];
  }
  for (int k = 0; k < count; ++k) kernels_->add(share[k], basis(k), x, n_);
}

Gmres::Report Gmres::solve(const std::function<void(const double*, double*)>& map, const double* b, double reduction,
                           double* x) {
  Report report;
  std::fill_n(x, n_, 0.0);
  const double norm_b = std::sqrt(kernels_->dot(b, b, n_));
  if (norm_b == 0) report.reduction = 0;
  if (!(norm_b > 0)) return report;
  double norm = norm_b;
  std::copy_n(b, n_, residual_.begin());
  while (true) {
    const auto room = [&](std::size_t k) {
      if (basis_.size() <= k) basis_.emplace_back(n_);
      return basis_[k].data();
    };
    std::fill_n(room(0), n_, 0.0);
    kernels_->add(1 / norm, residual_.data(), room(0), n_);
    column_.clear();
    cosine_.clear();
    sine_.clear();
    rotated_.assign(1, norm);
    int k = 0;
    while (k < kRestart && report.iterations < kMaxIterations) {
      double* next = room(static_cast<std::size_t>(k) + 1);
      map(basis(k), next);
      ++report.iterations;
      std::vector<double> column;
      for (int j = 0; j <= k; ++j) {
        column.push_back(kernels_->dot(basis(j), next, n_));
        kernels_->add(-column[j], basis(j), next, n_);
      }
      const double length = std::sqrt(kernels_->dot(next, next, n_));
      for (int j = 0; j < k; ++j) {
        const double above = column[j];
        column[j] = cosine_[j] * above + sine_[j] * column[j + 1];
        column[j + 1] = cosine_[j] * column[j + 1] - sine_[j] * above;
      }
      const double radius = std::hypot(column[k], length);
      if (!std::isfinite(radius)) {
        report.reduction = 1;
        return report;
      }
      if (radius == 0) {  // the map has no more to give; what the vectors so far hold is the best there is
        combine(k, x);
        return report;
      }
      cosine_.push_back(column[k] / radius);
      sine_.push_back(length / radius);
      column[k] = radius;
      column_.push_back(std::move(column));
      rotated_.push_back(-sine_[k] * rotated_[k]);
      rotated_[k] *= cosine_[k];
      ++k;
      report.reduction = std::abs(rotated_[k]) / norm_b;
      if (report.reduction <= reduction || length == 0) break;
      for (std::size_t e = 0; e < n_; ++e) next[e] /= length;
    }
    combine(k, x);
    if (report.reduction <= reduction || report.iterations >= kMaxIterations) return report;
    map(x, image_.data());
    for (std::size_t e = 0; e < n_; ++e) residual_[e] = b[e] - image_[e];
    norm = std::sqrt(kernels_->dot(residual_.data(), residual_.data(), n_));
    if (!(norm > reduction * norm_b)) return report;
  }
}

}  // namespace ringfilm::film
