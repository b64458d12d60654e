#pragma once
#include <map>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/run/run.hpp"

/// The result of a case as numbers by name, whatever was computed: what fits, optimisations and `ringfilm serve` ask
/// for.
namespace ringfilm::run {

/// A result as numbers [SI].
struct CaseNumbers {
  std::map<std::string, double> values;               ///< values by the names of value_quantities()
  std::vector<double> crank_angle_deg;                ///< -360 to below 360, rising; empty without curves [degree]
  std::map<std::string, std::vector<double>> curves;  ///< curves that were asked for, by name
};

/// The values that a case gives: of a ring those of its cycle, of an unrolled film and its oil consumption; of a pack
/// the sums, "ring_2_fmep", what is lowest or highest of all rings ("min_film_thickness"), gas and oil consumption; of
/// a pad those of the last instant; of the gas alone its sums, regions and rings.
std::vector<cycle::Quantity> value_quantities(const cycle::Case& c);

/// The curves over crank angle that a case gives.
std::vector<cycle::Quantity> curve_quantities(const cycle::Case& c);

/// Makes a case give the curves of these names, and nothing that is not asked for. The values stay the same, except
/// within a stated solver.accuracy.
void ask_for_curves(cycle::Case& c, const std::vector<std::string>& curves);

/// Computes a case. Throws InputError, ConvergenceError where its result is not complete.
CaseNumbers case_numbers(const cycle::Case& c, const std::vector<std::string>& curves, Observer* observer = nullptr);

}  // namespace ringfilm::run
