#include "ringfilm/study/inverse/constrained_search.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>

namespace ringfilm::study {
namespace {

constexpr int kStages = 3;
constexpr double kStageStep = 0.1;  // part of the step of the stage before
constexpr double kStageEnd = 0.05;  // part of its first step at which a stage before the last ends; assumed
constexpr double kConstraintTolerance = 1e-9;
constexpr double kUnsolvedConstraint = 1;  // relative excess of a design without a solution

/// A stage of a search, with the callbacks that NLopt takes. Unknowns are the places and, of several objectives, their
/// largest.
class Stage {
 public:
  Stage(const MeritFunction& merit, const Merit& first, std::size_t n_places)
      : merit_(merit),
        n_places_(n_places),
        n_objectives_(first.objectives.size()),
        n_constraints_(first.constraints.size()),
        worst_(first.objectives) {}

  /// @returns where it ended
  std::vector<double> run(std::vector<double> places, const std::vector<double>& objectives,
                          const SearchOptions& options) {
    const bool has_largest = n_objectives_ > 1;
    const bool is_free = !has_largest && n_constraints_ == 0 && n_places_ > 1;
    const auto n = static_cast<unsigned>(n_places_ + (has_largest ? 1 : 0));
    const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt_s*)> search(
        nlopt_create(is_free ? NLOPT_LN_BOBYQA : NLOPT_LN_COBYLA, n), nlopt_destroy);
    if (!search) throw std::bad_alloc();
    search_ = search.get();
    std::vector<double> x = std::move(places), lower(n, 0.), upper(n, 1.), step(n, options.first_step);
    if (has_largest) {
      const double largest = *std::max_element(objectives.begin(), objectives.end());
      x.push_back(largest);
      lower.back() = -HUGE_VAL;
      upper.back() = HUGE_VAL;
      step.back() = std::max(std::abs(largest), 1e-3) * options.first_step;
    }
    const std::vector<double> tolerance(n_constraints_ + (has_largest ? n_objectives_ : 0), kConstraintTolerance);
    nlopt_set_lower_bounds(search_, lower.data());
    nlopt_set_upper_bounds(search_, upper.data());
    nlopt_set_initial_step(search_, step.data());
    nlopt_set_xtol_abs1(search_, options.place_tolerance);
    nlopt_set_maxeval(search_, static_cast<int>(options.max_evaluations));
    nlopt_set_min_objective(search_, &Stage::objective, this);
    if (!tolerance.empty()) {
      nlopt_add_inequality_mconstraint(search_, static_cast<unsigned>(tolerance.size()), &Stage::constraints, this,
                                       tolerance.data());
    }
    double end = 0;
    nlopt_optimize(search_, x.data(), &end);  // where it fails by rounding, x is the best so far
    if (failure_) std::rethrow_exception(failure_);
    x.resize(n_places_);
    return x;
  }

 private:
  /// The merit at the places of NLopt's point; that of an unsolved design is worse than all that were seen.
  const Merit& at(const double* x) {
    std::vector<double> places(x, x + n_places_);
    if (places == places_) return now_;
    places_ = std::move(places);
    try {
      if (std::optional<Merit> found = merit_(places_)) {
        now_ = std::move(*found);
        for (std::size_t k = 0; k < n_objectives_; ++k) worst_[k] = std::max(worst_[k], now_.objectives[k]);
      } else {
        now_.objectives.clear();
        for (const double worst : worst_) now_.objectives.push_back(worst + std::max(std::abs(worst), 1e-3));
        now_.constraints.assign(n_constraints_, kUnsolvedConstraint);
      }
    } catch (...) {
      failure_ = std::current_exception();
      nlopt_force_stop(search_);
      now_.objectives = worst_;
      now_.constraints.assign(n_constraints_, kUnsolvedConstraint);
    }
    return now_;
  }

  static double objective(unsigned n, const double* x, double*, void* data) {
    auto& stage = *static_cast<Stage*>(data);
    return n > stage.n_places_ ? x[n - 1] : stage.at(x).objectives.front();
  }

  static void constraints(unsigned, double* result, unsigned n, const double* x, double*, void* data) {
    auto& stage = *static_cast<Stage*>(data);
    const Merit& merit = stage.at(x);
    double* to = std::copy(merit.constraints.begin(), merit.constraints.end(), result);
    if (n <= stage.n_places_) return;
    for (const double objective : merit.objectives) *to++ = objective - x[n - 1];
  }

  const MeritFunction& merit_;
  std::size_t n_places_, n_objectives_, n_constraints_;
  std::vector<double> worst_, places_;
  Merit now_;
  nlopt_opt search_ = nullptr;
  std::exception_ptr failure_;
};

}  // namespace

std::vector<double> search_from(const std::vector<double>& places, const MeritFunction& merit,
                                const SearchOptions& options) {
  std::vector<double> x = places;
  SearchOptions stage = options;
  for (int i = 0; i < kStages; ++i) {
    const std::optional<Merit> first = merit(x);
    if (!first) return x;
    stage.place_tolerance = i + 1 < kStages ? kStageEnd * stage.first_step : options.place_tolerance;
    x = Stage(merit, *first, x.size()).run(x, first->objectives, stage);
    stage.first_step *= kStageStep;
  }
  return x;
}

std::vector<std::size_t> non_dominated(const std::vector<std::vector<double>>& points) {
  const auto is_dominated = [&](std::size_t i, std::size_t by) {
    if (points[i] == points[by]) return by < i;
    for (std::size_t k = 0; k < points[i].size(); ++k) {
      if (points[by][k] > points[i][k]) return false;
    }
    return true;
  };
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool is_kept = true;
    for (std::size_t by = 0; by < points.size() && is_kept; ++by) is_kept = by == i || !is_dominated(i, by);
    if (is_kept) kept.push_back(i);
  }
  return kept;
}

std::vector<std::vector<double>> spread_weights(std::size_t n_objectives, std::size_t n_steps) {
  std::vector<std::vector<double>> all;
  std::vector<std::size_t> parts;
  const std::function<void(std::size_t)> divide = [&](std::size_t left) {
    if (parts.size() + 1 == n_objectives) {
      std::vector<double> weights;
      for (const std::size_t part : parts) weights.push_back(static_cast<double>(part) / static_cast<double>(n_steps));
      weights.push_back(static_cast<double>(left) / static_cast<double>(n_steps));
      all.push_back(std::move(weights));
      return;
    }
    for (std::size_t part = 1; part + (n_objectives - parts.size() - 1) <= left; ++part) {
      parts.push_back(part);
      divide(left - part);
      parts.pop_back();
    }
  };
  divide(n_steps);
  return all;
}

}  // namespace ringfilm::study
