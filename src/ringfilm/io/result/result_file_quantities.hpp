#pragma once
#include <string>
#include <utility>

#include "ringfilm/cycle/result.hpp"

/// How the variables of a result file are described that stand in no table of cycle/result.hpp.
namespace ringfilm::io {

/// Plain description of a variable that is no quantity of the tables in cycle/result.hpp.
inline cycle::Quantity described(std::string name, std::string unit, std::string long_name, std::string symbol = "",
                                 std::string equation = "") {
  return {std::move(name), std::move(unit), "", std::move(long_name), std::move(symbol), std::move(equation)};
}
inline cycle::Quantity count(std::string name, std::string long_name) {
  return described(std::move(name), "1", std::move(long_name));
}
inline cycle::Quantity text(std::string name, std::string long_name) {
  return described(std::move(name), "", std::move(long_name));
}
/// The value of the cycle as a whole beside the curve of the same name.
inline cycle::Quantity cycle_variable(cycle::Quantity quantity) {
  quantity.name = "cycle_" + quantity.name;
  return quantity;
}

/// The discretisation error beside a quantity.
inline cycle::Quantity error_variable(cycle::Quantity quantity) {
  quantity.name += "_error";
  quantity.long_name = "discretisation error of " + quantity.long_name;
  quantity.equation = "eq-grid-error";
  return quantity;
}
/// The order of convergence seen in a quantity, `in` cells or step.
inline cycle::Quantity order_variable(const cycle::Quantity& quantity, const std::string& in) {
  return described(quantity.name + "_order_in_" + in, "1",
                   "order of convergence in " + in + " of " + quantity.long_name + ", NaN where it is not monotone",
                   "p", "eq-observed-order");
}

}  // namespace ringfilm::io
