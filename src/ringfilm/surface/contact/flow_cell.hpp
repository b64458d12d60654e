#pragma once
#include <span>
#include <vector>

#include "ringfilm/surface/contact/half_space.hpp"

namespace ringfilm::surface {

/// Flow through a rough gap over that of a smooth one, of one cell of a map.
struct FlowFactorsOfGap {
  double conductance_x = 0.0;    ///< K_xx = <H^3 (1 + d chi/dx)>, eq-flow-cell [m3]
  double conductance_y = 0.0;    ///< K_yy, likewise across the rows [m3]
  double couette = 0.0;          ///< 2 Q/U of a wall that slides along x past this gap at rest, eq-shear-cell [m]
  double pressure_stress = 0.0;  ///< <H (1 + d chi/dx)>, eq-stress-cell [m]
  double residual = 0.0;         ///< largest of the three solutions, relative
};

/// Solves the cell problems of an average flow on the gap H >= 0, closed where it is 0. A periodic cell repeats; of a
/// mirrored one the pressure is fixed at the edges that the flow crosses and nothing flows through the others, as
/// through its images. Conductances between points are harmonic means, so that contacts shut. Conjugate gradients,
/// preconditioned by a cycle of multigrid on 2 x 2 aggregates.
FlowFactorsOfGap flow_factors(std::span<const double> gap_m, const ContactGrid& grid);

}  // namespace ringfilm::surface
