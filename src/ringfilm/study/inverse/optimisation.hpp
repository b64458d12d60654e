#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/inverse/variable.hpp"

/// An optimisation of a case as one plain value in SI, and what comes of it; docs/theory/fit.md.
namespace ringfilm::study {

enum class Goal { kMinimise, kMaximise };

/// What becomes of a quantity over the operating points.
enum class OverPoints { kMean, kMin, kMax };

struct Objective {
  cycle::Quantity quantity;
  Goal goal = Goal::kMinimise;
  OverPoints over = OverPoints::kMean;
};

struct Constraint {
  cycle::Quantity quantity;
  bool is_lower = true;  ///< at_least: the quantity is the limit or more; else at_most
  double limit = 0;      ///< [SI]
  OverPoints over = OverPoints::kMin;
};

/// A key that takes one of several texts: an oil, a coating, a file.
struct ChoiceVariable {
  std::string key;
  std::vector<std::string> texts;  ///< as one would write them in TOML, without quotes
  SourceMark mark = {};
};

/// What an optimisation is to do.
struct Optimisation {
  std::string title;
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
  std::vector<Variable> variables;
  std::vector<ChoiceVariable> choices;
  std::vector<WeightedPoint> points;  ///< one without a name: the case as it is
  std::size_t starts = 4;             ///< places from which the search of each combination of choices starts; assumed
  std::uint64_t seed = 1;             ///< seed of the places after the first
  std::size_t front_points = 11;      ///< points of a front of two objectives; assumed
  std::size_t max_evaluations = 200;  ///< in each stage of a search; assumed

  std::size_t n_combinations() const;
  /// Index of the choice of each ChoiceVariable in a combination.
  std::vector<std::size_t> combination(std::size_t i) const;
};

/// A design that was computed.
struct Design {
  std::size_t combination = 0;
  std::vector<double> places;       ///< places of the variables, 0 to 1
  std::vector<double> values;       ///< values of the variables [SI]
  std::vector<double> objectives;   ///< [SI]; empty: it has no solution
  std::vector<double> constraints;  ///< values of their quantities [SI]
  std::string reason;               ///< why it has no solution

  bool is_solved() const { return reason.empty(); }
};

/// By how much a design breaks a constraint; at most 0 where it meets it [SI].
double excess(const Constraint& constraint, double value);

/// By how much, over the limit itself, or over `size` where that is 0 [-].
double relative_excess(const Constraint& constraint, double value, double size);

/// Does it meet all constraints?
bool is_feasible(const Optimisation& problem, const Design& design);

/// The value of a quantity over the operating points.
double over_points(OverPoints over, const std::vector<WeightedPoint>& points, const std::vector<double>& values);

/// What an optimisation found.
struct OptimisationResult {
  std::vector<Design> designs;         ///< all that were computed, in the order of the searches
  std::optional<Design> best;          ///< nothing: no design meets all constraints
  std::optional<Design> nearest;       ///< the design that breaks its constraints the least, where none meets them
  std::vector<Design> front;           ///< designs of several objectives, by the first of them
  std::vector<std::size_t> binding;    ///< constraints at their limit in the best design
  std::vector<std::string> at_bounds;  ///< variables at a bound in the best design: "KEY at its upper bound"
};

/// Computes a design: a combination of choices and places of the variables. May be called from several threads.
using DesignFunction = std::function<Design(std::size_t combination, const std::vector<double>& places)>;

/// Searches the best design or the front. @param first_places of the case itself  @param threads 0: as many as the
/// machine runs at once. Throws ConvergenceError where no design has a solution.
OptimisationResult optimise(const Optimisation& problem, const std::vector<double>& first_places,
                            const DesignFunction& design, int threads);

}  // namespace ringfilm::study
