#pragma once
#include "styles_case.hpp"

namespace ringfilm::cycle::testing {

/// The paper's new ring with the ends of a gap.
inline Case unrolled_ring() {
  Case c = styles_new_ring();
  c.film.dimension = FilmDimension::kUnrolled;
  c.ring.end_gap = 0.3e-3;
  return c;
}

}  // namespace ringfilm::cycle::testing
