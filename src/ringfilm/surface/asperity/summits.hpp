#pragma once
#include <cstddef>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// Summits counted one by one: points higher than all eight neighbours, all of them measured; eq-summits. What counts
/// as one depends on the step and the filter: state both beside it.
struct Summits {
  std::size_t count = 0;
  double density_per_m2 = 0.0;        ///< per area of the points that could have been one [1/m^2]
  double mean_curvature_per_m = 0.0;  ///< mean of -(zxx + zyy)/2 of the summits [1/m]
  double mean_radius_m = 0.0;         ///< 1/mean curvature [m]
  double mean_height_m = 0.0;         ///< above the mean of the map [m]
  double rms_height_m = 0.0;          ///< rms of the summit heights about their own mean [m]; 0 for a single summit
};

/// All zero where there is no summit, as on a map of long waves.
/// @throws InputError for a profile or a flat map
Summits count_summits(const HeightMap& map);

/// Summits of the sum of two maps with equal steps, over the points that both have: the composite surface of a pair.
/// @throws InputError where the steps differ
Summits count_summits_of_pair(const HeightMap& first, const HeightMap& second);

/// What Gaussian isotropic surfaces should show after @cite nayak1971, eq-nayak.
struct SummitTheory {
  double bandwidth = 0.0;  ///< m0 m4/m2^2, 1.5 or more
  double density_per_m2 = 0.0;
  double mean_curvature_per_m = 0.0;
  double mean_height_m = 0.0;
  double rms_height_m = 0.0;
};

SummitTheory summit_theory(double m0_m2, double m2, double m4_per_m2);

}  // namespace ringfilm::surface
