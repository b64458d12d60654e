#pragma once
#include <cstdint>
#include <functional>

#include "ringfilm/surface/asperity/asperities.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"

namespace ringfilm::surface {

/// What a synthetic surface should measure.
struct TargetSurface {
  SigmaRule rule = SigmaRule::ra;
  double roughness_m = 0.0;  ///< Sa or Sq, by the rule [m]
  double m2 = 0.0;
  double m4_per_m2 = 0.0;
};

/// What the second of a pair must measure so that the pair has the target parameters, the first being as given.
/// @throws InputError where the first alone exceeds the pair
TargetSurface counterpart(const AsperityParameters& pair, const TargetSurface& first);

/// How a synthetic surface will be measured later: form, filters, moments; by default as it is.
using SurfaceMeasuring = std::function<SurfaceMeasures(const HeightMap&)>;

/// A Gaussian surface with a self-affine spectrum whose roll-off and short wavelength are searched, by Newton's method,
/// until the measures agree with the target to 1e-12.
/// @throws InputError where no such spectrum has them on this grid: roughness^2 m4/m2^2 is too small (a narrow band of
///         waves), or the waves are too long or too short for the map
HeightMap surface_with(const TargetSurface& target, const SurfaceGrid& grid, std::uint64_t seed,
                       const SurfaceMeasuring& measuring = nullptr);

}  // namespace ringfilm::surface
