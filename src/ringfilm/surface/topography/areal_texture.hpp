#pragma once
#include <optional>

#include "ringfilm/surface/topography/topography.hpp"

/// Hybrid and spatial parameters of maps after @cite iso25178_2, and the lays of a honed surface.
namespace ringfilm::surface {

/// Developed interfacial area ratio Sdr: area of the surface above its nominal area, over the nominal one [-];
/// eq-surface-developed-area. Cells with a missing corner are omitted.
/// @throws InputError for a profile and for a map without a complete cell
double developed_area_ratio(const HeightMap& map);

/// Lengths of the autocorrelation, eq-surface-autocorrelation.
struct AutocorrelationLengths {
  double Sal_m = 0.0;         ///< shortest distance at which it first falls to 0.2 [m]
  std::optional<double> Str;  ///< Sal over the longest one, 0 to 1; nothing: the longest is over half of the map
};

/// @throws InputError for a profile, fewer than 16 points in a direction, less than half of the points measured, a map
/// without height differences, and where it falls to 0.2 nowhere within half of the map
AutocorrelationLengths autocorrelation_lengths(const HeightMap& map);

/// The two lays of a cross-hatch, eq-surface-honing-angle. Angles are those of the grooves to the x axis, towards y.
struct HoningAngle {
  double first_rad = 0.0;    ///< lay of the stronger grooves, 0 to pi [rad]
  double second_rad = 0.0;   ///< lay of the others, 0 to pi [rad]
  double angle_rad = 0.0;    ///< between both, 0 to pi/2 [rad]
  double scatter_rad = 0.0;  ///< standard deviation of the directions of a lay, rms of both [rad]
};

/// Nothing where the spectrum has not two lays that stand out: a surface with one lay, or without any.
/// @throws InputError as autocorrelation_lengths() for its map
std::optional<HoningAngle> honing_angle(const HeightMap& map);

}  // namespace ringfilm::surface
