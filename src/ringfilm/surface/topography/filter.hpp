#pragma once
#include <string>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// How waves are parted: the linear Gaussian filter (ISO 16610-21 for profiles, -61 for maps) or the robust Gaussian
/// regression filter of order 0 (after ISO 16610-31 and -71), which pores and grooves do not pull down, or the two-step
/// filter of @cite iso13565_1 for profiles of old drawings: the mean line of the first step cuts the valleys off, that
/// of the second, of what is left, is the reference line. Its S-filter is the linear one.
enum class FilterKind { gaussian, robust_gaussian, valley_suppression };

/// Which waves stay: the S-filter keeps those longer than its nesting index (short cut-off), the L-filter those shorter
/// (long cut-off).
enum class FilterSide { short_cutoff, long_cutoff };

struct FilterChoice {
  FilterKind kind = FilterKind::gaussian;
  FilterSide side = FilterSide::long_cutoff;
  double cutoff_m = 0.0;  ///< wavelength of which half passes, also called the nesting index [m]
};

/// What a filter did.
struct FilterApplied {
  FilterChoice choice;
  double cutoff_steps = 0.0;               ///< cut-off in steps, the smaller of both directions
  int iterations = 0;                      ///< iterations of the robust filter
  std::size_t points_without_support = 0;  ///< robust: all near points were outliers, the linear filter is used there
  std::string text;                        ///< one line: side, kind, standard, cut-off
};

/// Filters the measured points in place; missing ones weigh nothing and stay missing. Near the ends and near missing
/// points the weights are divided by their own sum; eq-surface-gaussian, eq-surface-robust.
/// @throws InputError for a cut-off below two steps or beyond the map
FilterApplied apply_filter(HeightMap& map, const FilterChoice& choice);

/// Share of the amplitude of a wave that a Gaussian S-filter lets pass; 1/2 at the cut-off.
/// Throws InputError where one is not above zero.
double gaussian_transmission(double wavelength_m, double cutoff_m);

}  // namespace ringfilm::surface
