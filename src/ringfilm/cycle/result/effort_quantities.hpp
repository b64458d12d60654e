#pragma once
#include <variant>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::cycle {

/// A number of the effort of an integration and the member of `Effort` that holds it.
struct EffortQuantity : Quantity {
  std::variant<double Effort::*, long Effort::*> value;  ///< the member that holds it
};

/// In the order in which JSON, result files, pages and Python have them.
inline const std::vector<EffortQuantity>& effort_quantities() {
  static const std::vector<EffortQuantity> table = {
      {{"cycles_integrated", "1", "1", "cycles integrated until periodic", "", ""}, &Effort::cycles_integrated},
      {{"periodicity_error", "1", "1", "distance from the state that repeats itself, estimated, relative", "", ""},
       &Effort::periodicity_error},
      {{"crank_steps", "1", "1", "crank steps", "", ""}, &Effort::crank_steps},
      {{"newton_iterations", "1", "1", "Newton iterations", "", ""}, &Effort::newton_iterations},
      {{"relaxation_sweeps", "1", "1", "sweeps of point relaxation", "", ""}, &Effort::relaxation_sweeps},
      {{"sub_steps", "1", "1", "crank steps shorter than solver.crank_step", "", ""}, &Effort::sub_steps},
      {{"fallback_secant", "1", "1", "fallbacks to the bracketed search", "", ""}, &Effort::fallback_secant},
      {{"fallback_sub_step", "1", "1", "fallbacks to shorter steps", "", ""}, &Effort::fallback_sub_step},
      {{"max_load_residual", "1", "1", "largest imbalance of the load, relative", "", ""}, &Effort::max_load_residual},
      {{"max_newton_step", "1", "1", "largest Newton step accepted as the last one, relative", "", ""},
       &Effort::max_newton_step},
      {{"max_mass_residual", "1", "1", "largest mass left over in a step, relative", "", ""},
       &Effort::max_mass_residual}};
  return table;
}

}  // namespace ringfilm::cycle
