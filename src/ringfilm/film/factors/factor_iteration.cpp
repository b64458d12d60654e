#include "ringfilm/film/factors/factor_iteration.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {
namespace {

/// Passes at the most; some four are usual.
constexpr int kMaxPasses = 60;
/// Change of the factors that is let through, in units of the tolerance, and the least [-].
constexpr double kFactorTolerance = 10, kRounding = 1e-12;

/// The separation at which factors are taken: where a straight line through the last two answers of the film meets it.
class SeparationOfFactors {
 public:
  explicit SeparationOfFactors(double h_m) : at_(std::log(h_m)), at_before_(at_) {}
  double value() const { return std::exp(at_); }

  /// @param h_m of the film with the factors at value() [m]
  void take(double h_m) {
    constexpr double kFlattest = -0.1, kMaxStep = 0.5;
    const double residual = std::log(h_m) - at_;
    double step = residual;
    if (at_ != at_before_) {
      const double slope = (residual - residual_before_) / (at_ - at_before_);
      if (slope < kFlattest) step = -residual / slope;
    }
    at_before_ = at_;
    residual_before_ = residual;
    at_ += std::clamp(step, -kMaxStep, kMaxStep);
  }

 private:
  double at_, at_before_;  ///< ln h_m
  double residual_before_ = 0;
};

}  // namespace

double enough_of_factors(const FilmProblem& problem) {
  return std::max(kFactorTolerance * problem.tolerance, kRounding);
}

FilmReport iterate_factors(const FilmOfFactors& film, double enough, FilmState& state) {
  FilmReport total;
  SeparationOfFactors at(state.h_m);
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const auto held = film.factors(state, at.value());
    total.add(film.solve(held, state));
    if (!total.converged) return total;
    if (film.difference(held, film.factors(state, state.h_m), state) <= enough) return total;
    at.take(state.h_m);
  }
  total.converged = false;
  total.failure = Failure::kNotConverged;
  return total;
}

FilmReport FactorIteration::solve(const FilmInputs& inputs, FilmState& state, const Solve& solve) const {
  if (laws_.are_of_plain_film()) return solve(inputs, state);
  using Factors = FilmOfFactors::Factors;
  FilmInputs held = inputs;
  return iterate_factors(
      {[&](const FilmState& of, double h_m) { return flow_factors(laws_, problem_, inputs, of, h_m); },
       [&](const Factors& one, const Factors& other, const FilmState& of) {
         return difference(*one, *other, film_heights(problem_.grid, of.h_m));
       },
       [&](const Factors& factors, FilmState& of) {
         held.factors = factors;
         return solve(held, of);
       }},
      enough_of_factors(problem_), state);
}

}  // namespace ringfilm::film
