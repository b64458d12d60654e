#pragma once
#include <vector>

#include "ringfilm/surface/asperity/asperities.hpp"

namespace ringfilm::surface {

/// What a surface measures after an S-filter of one short cut-off.
struct ScaleRow {
  double short_cutoff_m = 0.0;  ///< 0: as measured, the step alone decides
  double Sq_m = 0.0;
  double Sdq = 0.0;
  SpectralMoments moments;
  double density_per_m2 = 0.0;         ///< N of this surface against a smooth one [1/m^2]
  double beta_m = 0.0;                 ///< [m]
  double summit_density_per_m2 = 0.0;  ///< counted; 0 for a profile or where no summit is left
};

/// Short cut-offs at which to look: 2.5, 5, 10, ... larger steps of the map, up to a tenth of its smaller side (a
/// profile: of its length).
std::vector<double> short_cutoffs(const HeightMap& map);

/// One row as measured, then one for each cut-off; m4, N and beta depend on it, and a case records which was used.
/// @param map levelled, without short-wave filter
std::vector<ScaleRow> scale_table(const HeightMap& map, const std::vector<double>& cutoffs_m,
                                  MomentDirection direction = MomentDirection::mean,
                                  DifferenceScheme scheme = DifferenceScheme::neighbours);

}  // namespace ringfilm::surface
