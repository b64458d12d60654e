#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/study/design/study.hpp"

/// What a fit or an optimisation changes in a case.
namespace ringfilm::study {

/// A number of the case between two bounds.
struct Variable {
  std::string key;                     ///< "ring.face.crown_height"; in a pack "ring.2.end_gap"
  FactorMode how = FactorMode::kSet;   ///< the number itself, times or plus that of the case
  std::optional<std::size_t> item;     ///< number of a list that is set, from 1
  double lower = 0, upper = 0;         ///< bounds [unit]
  Spacing spacing = Spacing::kLinear;  ///< spacing of the search between the bounds
  std::string unit;                    ///< SI; "1" for a dimensionless number and for factors
  std::string display_unit;            ///< unit in which people read it
  SourceMark mark = {};                ///< place in the file that states it

  /// The key as outputs have it: with the number of its item, "pad.face.coefficients.1".
  std::string name() const { return item ? key + "." + std::to_string(*item) : key; }
};

/// The value at a place between the bounds, from 0 to 1.
double value_at(const Variable& variable, double place);
/// The place of a value between the bounds; below 0 or above 1 outside them.
double place_of(const Variable& variable, double value);
/// Derivative of value_at() with respect to the place.
double slope_at(const Variable& variable, double place);

/// Values of all variables at their places.
std::vector<double> values_at(const std::vector<Variable>& variables, const std::vector<double>& places);

/// Cases with the same variables: one for each operating point or combination of choices.
class VariedCases {
 public:
  /// Each keeps the cells and steps that `ringfilm run` gives it.
  VariedCases(std::vector<cycle::Case> bases, std::vector<Variable> variables, Compute compute);

  const std::vector<Variable>& variables() const { return variables_; }
  std::size_t n_bases() const { return study_.bases.size(); }
  const cycle::Case& base(std::size_t i) const { return study_.bases.at(i).input; }
  Compute compute() const { return study_.compute; }

  /// What is wrong with the variables: keys that do not exist, are not numbers or not in use, bounds reversed or out
  /// of the range of their key, two variables of one key.
  std::vector<Fault> faults() const;

  /// The value that a base has of a variable; nothing where it has none, 1 or 0 of one that scales or adds.
  std::optional<double> value_of_base(std::size_t base, std::size_t variable) const;

  /// The places of the values of the first base; the middle where it has none between the bounds.
  std::vector<double> own_places() const;

  /// The case of a base with these values [SI]. Throws InputError with every rule that it breaks.
  cycle::Case at(std::size_t base, const std::vector<double>& values) const;

 private:
  std::vector<Variable> variables_;
  Study study_;                       ///< the variables that studies have, too, as factors
  std::vector<std::size_t> factors_;  ///< indices of these variables
};

}  // namespace ringfilm::study
