#pragma once
#include <string>

#include "ringfilm/surface/asperity/spectral_moments.hpp"
#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// Which height statistic is used as sigma.
enum class SigmaRule {
  ra,  ///< Ra (Sa of a map), as in styles2014
  rq   ///< Rq (Sq of a map)
};

/// What one surface brings into a pair, all after the same form and filters.
struct SurfaceMeasures {
  double Sa_m = 0.0;        ///< mean absolute deviation of the heights (Ra of a profile) [m]
  double Sq_m = 0.0;        ///< rms of the heights about their mean (Rq of a profile) [m]
  SpectralMoments moments;  ///< spectral moments of profiles in the direction that was asked for
};

/// Density of asperity peaks, mean radius of their summits, roughness: what a contact model takes.
struct AsperityParameters {
  double density_per_m2 = 0.0;  ///< N [1/m^2]
  double beta_m = 0.0;          ///< mean summit radius [m]
  double sigma_m = 0.0;         ///< composite roughness [m]

  double roughness_parameter() const { return density_per_m2 * beta_m * sigma_m; }  ///< N beta sigma [-]
  double slope() const { return sigma_m / beta_m; }                                 ///< sigma/beta [-]
};

/// Measures of a map that was levelled and filtered.
/// @throws InputError for flat surfaces, too few points, heights that are not numbers
SurfaceMeasures surface_measures(const HeightMap& map, MomentDirection direction = MomentDirection::mean,
                                 DifferenceScheme scheme = DifferenceScheme::neighbours);

/// N and beta of moments, eq-asperity-density and eq-asperity-radius.
/// @param sigma_m taken over as it is
/// @throws InputError where m2 or m4 is not positive: the radius would be infinite
AsperityParameters asperity_parameters(const SpectralMoments& moments, double sigma_m);

/// N, beta, sigma of two surfaces in contact after @cite styles2014, eqs (1) to (4), as corrected in
/// docs/theory/surface.md: m2 and m4 add up, sigma is the root of the sum of squares, eq-asperity-pair.
AsperityParameters pair_parameters(const SurfaceMeasures& first, const SurfaceMeasures& second, SigmaRule rule);

/// N, beta, sigma of one surface against a smooth flat.
AsperityParameters single_parameters(const SurfaceMeasures& surface, SigmaRule rule);

/// One line for tables and files, for example "root of the sum of squares of Ra (Sa)".
std::string sigma_text(SigmaRule rule);

/// Moments that give N and beta, the inverse of asperity_parameters; m0 stays 0.
SpectralMoments moments_of(double density_per_m2, double beta_m);

}  // namespace ringfilm::surface
