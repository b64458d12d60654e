#pragma once
#include <map>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"

/// What a small change of an input makes of the values of a case (docs/theory/error-estimate.md, "Gradients").
namespace ringfilm::run {

/// A derivative with respect to an input.
struct Derivative {
  double value = 0;   ///< [SI of the quantity over SI of the input]
  double error = 0;   ///< estimate, from two widths of the difference; what is below it is not known
  double around = 0;  ///< the value between the inputs of the narrower width [SI]
};

/// The derivatives of all values with respect to one input.
struct Gradient {
  std::string key;
  double at = 0;                                  ///< value of the input [SI]
  std::map<std::string, Derivative> derivatives;  ///< by the names of value_quantities(), but for crank angles
  std::string reason;                             ///< why there are none
};

/// The numbers that the case states, by which its result may be differentiated.
std::vector<std::string> differentiable_keys(const cycle::Case& c);

/// Central differences of two widths, extrapolated after Richardson, eq-gradient, on fixed crank steps.
/// @param keys numbers of the case; empty: differentiable_keys()  @param threads 0: as many as the machine runs at once
/// Throws InputError for a key whose value is not a number.
std::vector<Gradient> gradients(const cycle::Case& c, std::vector<std::string> keys = {}, int threads = 0);

}  // namespace ringfilm::run
