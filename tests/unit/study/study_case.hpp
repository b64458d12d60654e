#pragma once
#include "../cycle/styles_case.hpp"

/// A case that is solved in a moment.
namespace ringfilm::study::testing {

inline cycle::Case coarse_case() {
  cycle::Case c = cycle::testing::styles_new_ring();
  c.solver.cells = 100;
  c.solver.crank_step_deg = 4;
  return c;
}

}  // namespace ringfilm::study::testing
