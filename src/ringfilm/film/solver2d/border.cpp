#include "ringfilm/film/solver2d/border.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace ringfilm::film {

Border::Border(const Film2dKernels& kernels, std::size_t n, int count, double* column, double* row)
    : kernels_(&kernels),
      n_(n),
      count_(count),
      column_{column},
      row_{row},
      solution_(count, std::vector<double>(n, 0.0)),
      corner_(static_cast<std::size_t>(count) * count, 0.0),
      lu_(corner_),
      left_(count),
      order_(count) {
  for (int k = 1; k < count; ++k) {
    for (std::vector<double*>* of : {&column_, &row_}) {
      memory_.emplace_back(n, 0.0);
      of->push_back(memory_.back().data());
    }
  }
}

void Border::solve_columns(const Solve& approximately) {
  for (int k = 0; k < count_; ++k) approximately(column_[k], solution_[k].data());
}

bool Border::factor(int first) {
  first_ = first;
  for (int k = first; k < count_; ++k) {
    for (int l = first; l < count_; ++l) lu(k, l) = slope(k, l) - kernels_->dot(row_[k], solution_[l].data(), n_);
    if (!(lu(k, k) < 0)) return false;
  }
  std::iota(order_.begin(), order_.end(), 0);
  for (int k = first; k < count_; ++k) {
    int pivot = k;
    for (int i = k + 1; i < count_; ++i) {
      if (std::abs(lu(i, k)) > std::abs(lu(pivot, k))) pivot = i;
    }
    if (!(std::abs(lu(pivot, k)) > 0)) return false;
    if (pivot != k) {
      for (int l = first; l < count_; ++l) std::swap(lu(k, l), lu(pivot, l));
      std::swap(order_[k], order_[pivot]);
    }
    for (int i = k + 1; i < count_; ++i) {
      lu(i, k) /= lu(k, k);
      for (int l = k + 1; l < count_; ++l) lu(i, l) -= lu(i, k) * lu(k, l);
    }
  }
  return true;
}

void Border::add_columns(const double* b, double* y) const {
  for (int k = 0; k < count_; ++k) kernels_->add(b[k], column_[k], y, n_);
}

void Border::multiply(const double* x, const double* b, double* to) const {
  for (int k = 0; k < count_; ++k) {
    to[k] = kernels_->dot(row_[k], x, n_);
    for (int l = 0; l < count_; ++l) to[k] += slope(k, l) * b[l];
  }
}

void Border::eliminate(const double* g, double* x, double* b) {
  for (int k = first_; k < count_; ++k) left_[k] = g[k] - kernels_->dot(row_[k], x, n_);
  for (int k = 0; k < first_; ++k) b[k] = 0;
  for (int k = first_; k < count_; ++k) {
    b[k] = left_[order_[k]];
    for (int l = first_; l < k; ++l) b[k] -= lu(k, l) * b[l];
  }
  for (int k = count_ - 1; k >= first_; --k) {
    for (int l = k + 1; l < count_; ++l) b[k] -= lu(k, l) * b[l];
    b[k] /= lu(k, k);
  }
  for (int k = first_; k < count_; ++k) kernels_->add(-b[k], solution_[k].data(), x, n_);
}

}  // namespace ringfilm::film
