#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// Height statistics of all measured points about their mean, eq-surface-heights. For a profile they are Ra, Rq, ...
/// over its whole length, for a map Sa, Sq, ...
struct HeightStatistics {
  std::size_t points = 0;   ///< measured ones, which all the rest is of
  std::size_t missing = 0;  ///< not measured
  double mean_m = 0.0;      ///< removed before the rest [m]
  double Sa_m = 0.0;        ///< mean absolute deviation (Ra of a profile) [m]
  double Sq_m = 0.0;        ///< rms (Rq of a profile) [m]
  double Ssk = 0.0;         ///< skewness [-]
  double Sku = 0.0;         ///< kurtosis; 3 for a Gaussian [-]
  double Sp_m = 0.0;        ///< highest peak above the mean [m]
  double Sv_m = 0.0;        ///< deepest pit below the mean, positive [m]
  double Sz_m = 0.0;        ///< Sp + Sv [m]
};

/// @throws InputError for fewer than 4 points or a surface without any height differences
HeightStatistics height_statistics(const HeightMap& map);

/// Ra and Rq of the rows of a map, each about its own mean: the mean of Ra, the root of the mean square of Rq. Rows
/// with fewer than 8 measured points are omitted.
struct RowRoughness {
  double Ra_m = 0.0;     ///< mean of Ra over the rows [m]
  double Rq_m = 0.0;     ///< root of the mean square of Rq over the rows [m]
  std::size_t rows = 0;  ///< that were not omitted
};

/// @throws InputError where no row has 8 measured points
RowRoughness row_roughness(const HeightMap& map);

/// Heights of the measured points, falling: the material ratio (Abbott) curve. Point i of n is at a material ratio of
/// (i + 1/2)/n.
std::vector<double> material_ratio_curve(const HeightMap& map);

}  // namespace ringfilm::surface
