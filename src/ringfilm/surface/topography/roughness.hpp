#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// Height statistics of all measured points about their mean, eq-surface-heights: Sa, Sq, ... of a map. Those of a
/// profile are over its whole length: Ra, Rq, Rsk, Rku, and Rpt, Rvt, Rt in place of Sp, Sv, Sz.
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

/// Heights of a profile over its sampling lengths, eq-surface-sampling-length.
struct SampledHeights {
  double Rp_m = 0.0;               ///< mean of the highest peaks above the mean of the whole profile [m]
  double Rv_m = 0.0;               ///< mean of the deepest pits below it, positive [m]
  double Rz_m = 0.0;               ///< mean of the heights from pit to peak, Rp + Rv [m]
  double sampling_length_m = 0.0;  ///< sampling length [m]
  std::size_t count = 0;           ///< number of sampling lengths, side by side in the middle of the profile
};

/// @param sampling_length_m the long cut-off of the profile; nothing: a fifth of its length [m]
/// @throws InputError for a map of several rows, and where a sampling length is longer than the profile or has fewer
/// than 2 measured points
SampledHeights sampled_heights(const HeightMap& profile, std::optional<double> sampling_length_m = std::nullopt);

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
