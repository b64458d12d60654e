#include "ringfilm/film/solver2d/border.hpp"

#include <algorithm>
#include <utility>

namespace ringfilm::film {

void RigidBorder::solve_columns(const Solve& approximately) { approximately(block_->column, solution_.data()); }

bool RigidBorder::factor() {
  slope_ = corner_ - kernels_->dot(block_->load_row, solution_.data(), n_);
  return slope_ < 0;
}

void RigidBorder::add_columns(const double* b, double* y) { kernels_->add(b[0], block_->column, y, n_); }

void RigidBorder::multiply(const double* x, const double* b, double* to) {
  to[0] = kernels_->dot(block_->load_row, x, n_);
  to[0] += corner_ * b[0];
}

void RigidBorder::eliminate(const double* g, double* x, double* b) {
  b[0] = (g[0] - kernels_->dot(block_->load_row, x, n_)) / slope_;
  kernels_->add(-b[0], solution_.data(), x, n_);
}

BeamBorder::BeamBorder(const Film2dKernels& kernels, const Film2dBlock& block, const Film2dProblem& problem, int first)
    : kernels_(&kernels),
      block_(&block),
      ring_(problem.ring),
      n_strips_(problem.around.n_strips()),
      first_(first),
      ends_(problem.around.ends),
      length_(problem.around.length),
      contact_slope_(n_strips_, 0.0),
      stiffened_(ring_.n_unknowns(), 1.0),
      share_(n_strips_, 0.0),
      closing_(ring_.n_unknowns(), 1.0),
      solution_(block.system.shape.size(), 0.0),
      own_(block.system.shape.strip_size(), 0.0),
      low_(own_),
      high_(own_),
      sums_(own_),
      factor_(ring_.band.size(), 0.0),
      left_(ring_.n_unknowns(), 0.0),
      bent_(left_) {
  for (int j = 0; j < n_strips_; ++j) share_[j] = problem.around.share[j] / length_;
}

void BeamBorder::set(double scale, int lowest, std::vector<double> contact_slope, const std::vector<double>& closing) {
  scale_ = scale;
  lowest_ = lowest;
  contact_slope_ = std::move(contact_slope);
  for (int j = 0; j < n_strips_; ++j) closing_[ring_.of_strip(j)] = closing[j];
}

void BeamBorder::solve_columns(const Solve& approximately) { approximately(block_->column, solution_.data()); }

bool BeamBorder::factor() {
  constexpr int kWidth = ElasticRing::kWidth;
  const ZebraShape& shape = block_->system.shape;
  const double scale = scale_ / length_;
  for (std::size_t e = 0; e < factor_.size(); ++e) factor_[e] = ring_.band[e] * scale;
  kernels_->strip_sums(shape, block_->load_row, solution_.data(), sums_.data());
  for (int j = 0; j < n_strips_; ++j) {
    const int s = j - first_;
    const double of_film = s >= 0 && s < shape.n_strips ? sums_[shape.strip(s)] : 0;
    // A film that carries more the thinner its oil: Newton's method then sees a stiffness of the other sign, but what
    // precedes GMRES must be definite.
    const int i = ring_.of_strip(j);
    const double stiff = std::max(of_film - contact_slope_[j], 0.0);
    stiffened_[i] = closing_[i] + ring_.flattening * stiff / (share_[j] * scale_);
    factor_[static_cast<std::size_t>(i) * kWidth] += stiff / stiffened_[i];
  }
  return factor_band(factor_);
}

void BeamBorder::spread(const double* b) {
  const ZebraShape& shape = block_->system.shape;
  const auto at = [&](int j) { return b[ring_.of_strip(j)]; };
  const bool joined = ends_ == Ends::kJoined;
  for (int s = 0; s < shape.n_strips; ++s) {
    const int j = s + first_;
    const int low = j > 0 ? j - 1 : (joined ? n_strips_ - 1 : j);
    const int high = j + 1 < n_strips_ ? j + 1 : (joined ? 0 : j);
    const std::size_t strip = shape.strip(s);
    own_[strip] = at(j);
    low_[strip] = 0.5 * (at(low) + at(j));
    high_[strip] = 0.5 * (at(j) + at(high));
  }
}

void BeamBorder::add_columns(const double* b, double* y) {
  spread(b);
  kernels_->add_columns(*block_, own_.data(), low_.data(), high_.data(), y);
}

void BeamBorder::multiply(const double* x, const double* b, double* to) {
  constexpr int kWidth = ElasticRing::kWidth;
  const ZebraShape& shape = block_->system.shape;
  const int n = ring_.n_unknowns();
  const double scale = scale_ / length_;
  std::fill_n(to, n, 0.0);
  for (int i = 0; i < n; ++i) bent_[i] = closing_[i] * b[i];
  if (ring_.flattening > 0) kernels_->strip_sums(shape, block_->load_row, x, sums_.data());
  for (int j = 0; ring_.flattening > 0 && j < n_strips_; ++j) {
    const int i = ring_.of_strip(j), s = j - first_;
    const double more = contact_slope_[j] * b[i] + (s >= 0 && s < shape.n_strips ? sums_[shape.strip(s)] : 0.0);
    bent_[i] -= ring_.flattening / scale_ * more / share_[j];
  }
  const double of_lowest = b[ring_.of_strip(lowest_)];  // displacements count from its film
  for (int i = 0; i < n; i += 2) bent_[i] -= of_lowest;
  for (int i = 0; i < n; ++i) {
    const double* row = ring_.band.data() + static_cast<std::size_t>(i) * kWidth;
    to[i] -= scale * row[0] * bent_[i];
    for (int k = 1; k < kWidth && i + k < n; ++k) {
      to[i] -= scale * row[k] * bent_[i + k];
      to[i + k] -= scale * row[k] * bent_[i];
    }
  }
  kernels_->strip_sums(shape, block_->load_row, x, sums_.data());
  for (int j = 0; j < n_strips_; ++j) {
    const int i = ring_.of_strip(j), s = j - first_;
    to[i] += contact_slope_[j] * b[i];
    if (s >= 0 && s < shape.n_strips) to[i] += sums_[shape.strip(s)];
  }
}

void BeamBorder::eliminate(const double* g, double* x, double* b) {
  const ZebraShape& shape = block_->system.shape;
  const int n = ring_.n_unknowns();
  for (int i = 0; i < n; ++i) left_[i] = -g[i];
  kernels_->strip_sums(shape, block_->load_row, x, sums_.data());
  for (int s = 0; s < shape.n_strips; ++s) left_[ring_.of_strip(s + first_)] += sums_[shape.strip(s)];
  solve_band(factor_, left_.data());
  for (int i = 0; i < n; ++i) b[i] = left_[i] / stiffened_[i];
  for (int s = 0; s < shape.n_strips; ++s) own_[shape.strip(s)] = b[ring_.of_strip(s + first_)];
  kernels_->take_columns(shape, solution_.data(), own_.data(), x);
}

}  // namespace ringfilm::film
