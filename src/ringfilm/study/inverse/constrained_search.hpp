#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

/// Searches without derivatives between bounds and under constraints; docs/theory/fit.md.
namespace ringfilm::study {

/// What a design is worth.
struct Merit {
  /// To be minimised: one number, or several, of which the largest is.
  std::vector<double> objectives;
  std::vector<double> constraints;  ///< at most 0 where they are met
};

/// The merit at places of the variables between their bounds, each from 0 to 1; nothing where a case has no solution.
using MeritFunction = std::function<std::optional<Merit>(const std::vector<double>& places)>;

/// How a search is carried out.
struct SearchOptions {
  std::size_t max_evaluations = 200;  ///< in each of the three stages; assumed
  double first_step = 0.2;            ///< step of the places in the first stage, a tenth in each later one; assumed
  double place_tolerance = 1e-6;      ///< step of the places at which the last stage ends; assumed
};

/// Searches from places on: by quadratic models (BOBYQA @cite powell2009) where there is one objective without
/// constraints and more than one variable, else by linear models (COBYLA @cite powell1994), both of NLopt. Each stage
/// begins at the end of the one before with smaller steps. What the function throws ends the search.
/// @returns places where it ended; the function has seen better ones where it ended early
std::vector<double> search_from(const std::vector<double>& places, const MeritFunction& merit,
                                const SearchOptions& options = {});

/// Indices of the points that no other point dominates: none is as good in all objectives and better in one. In their
/// order; of equal points the first. @param points objectives to be minimised
std::vector<std::size_t> non_dominated(const std::vector<std::vector<double>>& points);

/// Weights of objectives, evenly spread over all that add up to 1 and are not 0. @param n_steps to divide 1 into
std::vector<std::vector<double>> spread_weights(std::size_t n_objectives, std::size_t n_steps);

}  // namespace ringfilm::study
