#pragma once
#include "ringfilm/models/section/polygon.hpp"

namespace ringfilm::models {

/// Torsion constant of a section, between bounds that hold whatever the mesh.
struct TorsionConstant {
  double value = 0;  ///< J, midway between the bounds [m4]
  double lower = 0;  ///< by the stress function, eq-section-torsion-lower [m4]
  double upper = 0;  ///< by the warping function, eq-section-torsion-upper [m4]
};

/// St Venant's torsion constant of a simple polygon: finite elements of the second order, refined until the bounds
/// differ by less than `kTorsionTolerance` of the value, or the mesh has 20 000 triangles.
TorsionConstant torsion_constant(const SectionPolygon& section);

/// Largest distance of the bounds over the torsion constant that is aimed at [-].
inline constexpr double kTorsionTolerance = 1e-5;

}  // namespace ringfilm::models
