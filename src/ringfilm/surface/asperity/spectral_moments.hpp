#pragma once
#include <cstddef>
#include <string>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// How slopes and curvatures are formed from neighbouring heights, eq-surface-differences.
enum class DifferenceScheme {
  neighbours,  ///< slope of two neighbours (at their middle), curvature of three; second order
  seven_point  ///< slope and curvature of seven points; sixth order, passes more noise
};

/// Along which lines the moments of a map are taken.
enum class MomentDirection {
  x,         ///< along the rows
  y,         ///< along the columns; none of a profile
  mean,      ///< arithmetic mean of both: for an isotropic surface
  geometric  ///< root of the product of both: the equivalent isotropic surface of one with a lay
};

/// Spectral moments of profiles of a surface: variance of heights, slopes and curvatures, eq-surface-moments.
struct SpectralMoments {
  double m0_m2 = 0.0;      ///< [m^2]
  double m2 = 0.0;         ///< [-]
  double m4_per_m2 = 0.0;  ///< [1/m^2]
};

/// Sums from which the moments in every direction follow.
struct MomentTable {
  DifferenceScheme scheme = DifferenceScheme::neighbours;  ///< with which they were formed
  bool profile = false;         ///< is the map a profile, of one row? Moments with a y then stay 0
  double m0_m2 = 0.0;           ///< variance of the heights about the mean of all measured points [m^2]
  double m2_x = 0.0;            ///< mean square slope along x [-]
  double m2_y = 0.0;            ///< mean square slope along y [-]
  double m4_x_per_m2 = 0.0;     ///< mean square curvature along x [1/m^2]
  double m4_y_per_m2 = 0.0;     ///< mean square curvature along y [1/m^2]
  double m2_xy = 0.0;           ///< mean product of both slopes; it and the next four stay 0 with seven_point [-]
  double m4_xxyy_per_m2 = 0.0;  ///< mean of zxx zyy, the curvatures along x and y [1/m^2]
  double m4_xyxy_per_m2 = 0.0;  ///< mean square of the twist zxy [1/m^2]
  double m4_xxxy_per_m2 = 0.0;  ///< mean of zxx zxy [1/m^2]
  double m4_xyyy_per_m2 = 0.0;  ///< mean of zxy zyy [1/m^2]
  std::size_t stencils = 0;     ///< complete ones along x of the curvature
};

/// Means over all complete stencils: one that meets a missing point or the edge is omitted.
/// A curvature that is only the round-off of the heights counts as 0.
/// @throws InputError where there are fewer than 16 complete stencils in a direction, or no curvature in any
MomentTable moment_table(const HeightMap& map, DifferenceScheme scheme = DifferenceScheme::neighbours);

/// The table of what lies above a height alone, as the plateau of a surface made in two steps; eq-surface-plateau.
/// @throws as moment_table()
MomentTable moment_table_above(HeightMap map, double height_m, DifferenceScheme scheme = DifferenceScheme::neighbours);

/// Moments along x, y or both; a profile has those along x alone.
SpectralMoments moments(const MomentTable& table, MomentDirection direction);

/// Moments of profiles at an angle to the x axis [rad], for any angle; eq-surface-moments-at-angle. Scheme neighbours.
SpectralMoments moments_at_angle(const MomentTable& table, double angle_rad);

/// Moments less those of the instrument's noise, taken on a flat with the same steps and filters: what is not
/// correlated adds up.
/// @throws InputError where m0, m2 or m4 would not stay positive
SpectralMoments without_noise(const SpectralMoments& surface, const SpectralMoments& flat);

/// Rms slope of a map, the root of m2_x + m2_y, and of a profile (Sdq, Rdq) [-].
double rms_slope(const MomentTable& table);

/// One line for tables and files, for example "slopes of 2, curvatures of 3 neighbouring points".
std::string scheme_text(DifferenceScheme scheme);

}  // namespace ringfilm::surface
