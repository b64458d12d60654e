#include "ringfilm/film/factors/factor_iteration.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {
namespace {

/// Passes at the most; some four are usual.
constexpr int kMostPasses = 60;
/// Change of the factors that is let through, in units of the tolerance, and the least [-].
constexpr double kFactorTolerance = 10, kRounding = 1e-12;

/// The separation at which factors are taken: where a straight line through the last two answers of the film meets it.
class SeparationOfFactors {
 public:
  explicit SeparationOfFactors(double h_m) : at_(std::log(h_m)), at_before_(at_) {}
  double value() const { return std::exp(at_); }

  /// @param h_m of the film with the factors at value() [m]
  void take(double h_m) {
    constexpr double kFlattest = -0.1, kLargestStep = 0.5;
    const double residual = std::log(h_m) - at_;
    double step = residual;
    if (at_ != at_before_) {
      const double slope = (residual - residual_before_) / (at_ - at_before_);
      if (slope < kFlattest) step = -residual / slope;
    }
    at_before_ = at_;
    residual_before_ = residual;
    at_ += std::clamp(step, -kLargestStep, kLargestStep);
  }

 private:
  double at_, at_before_;  ///< ln h_m
  double residual_before_ = 0;
};

}  // namespace

FilmReport FactorIteration::solve(const FilmInputs& inputs, FilmState& state, const Solve& solve) const {
  FilmReport total;
  if (laws_.are_of_plain_film()) return solve(inputs, state);
  const double enough = std::max(kFactorTolerance * problem_.tolerance, kRounding);
  FilmInputs held = inputs;
  SeparationOfFactors at(state.h_m);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    held.factors = flow_factors(laws_, problem_, inputs, state, at.value());
    total.add(solve(held, state));
    if (!total.converged) return total;
    const auto found = flow_factors(laws_, problem_, inputs, state, state.h_m);
    if (difference(*held.factors, *found, problem_.grid, state.h_m) <= enough) return total;
    at.take(state.h_m);
  }
  total.converged = false;
  total.failure = Failure::kNotConverged;
  return total;
}

}  // namespace ringfilm::film
