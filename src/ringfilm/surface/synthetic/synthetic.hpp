#pragma once
#include <cstdint>
#include <functional>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// Size and steps of a surface to be made. Sizes without prime factors above 5 give periodic surfaces, others are cut
/// out of the next larger one of these.
struct SurfaceGrid {
  std::size_t points_x = 512;  ///< along a row
  std::size_t points_y = 512;  ///< rows; 1: a profile
  double step_x_m = 1e-6;      ///< between points of a row [m]
  double step_y_m = 1e-6;      ///< between rows [m]
};

/// Power over frequency along x and y [1/m], in any unit: only its shape counts.
using PowerSpectrum = std::function<double(double frequency_x_per_m, double frequency_y_per_m)>;

/// A Gaussian autocorrelation exp(-x^2/length_x^2 - y^2/length_y^2), eq-synthetic-gaussian.
PowerSpectrum gaussian_correlation(double length_x_m, double length_y_m);

/// A self-affine surface that levels off for long waves and ends smoothly for short ones, eq-synthetic-self-affine.
/// @param hurst exponent, 0 to 1
/// @param roll_off_m wavelength beyond which the power is level
/// @param short_m wavelength below which the power falls off
PowerSpectrum self_affine(double hurst, double roll_off_m, double short_m);

/// How the rms of a synthetic surface is meant.
enum class RmsDefinition {
  expected,  ///< rms expected over many seeds
  exact      ///< rms of this surface, to round-off
};

/// A Gaussian surface of mean 0 with the given spectrum and rms; eq-synthetic. Sums of random waves: every seed gives
/// another surface of the same statistics.
/// @throws InputError for an invalid grid or spectrum: more than 2^28 points, no power
HeightMap gaussian_surface(const SurfaceGrid& grid, const PowerSpectrum& spectrum, double Sq_m, std::uint64_t seed,
                           RmsDefinition rms = RmsDefinition::expected);

/// A plateau-honed liner: a fine Gaussian plateau, into which two families of straight grooves of triangular section
/// cut.
struct HonedSurface {
  double plateau_Sq_m = 0.08e-6;    ///< rms of the plateau between the grooves [m]
  double plateau_length_m = 5e-6;   ///< correlation length of the plateau [m]
  double hatch_angle_rad = 0.8;     ///< between both families; the x axis halves it [rad]
  double groove_spacing_m = 60e-6;  ///< mean, from half to three halves of it [m]
  double groove_depth_m = 2e-6;     ///< mean, from half to three halves of it [m]
  double groove_width_m = 12e-6;    ///< at the top [m]
};

/// A honed liner; the same seed gives the same heights.
HeightMap honed_surface(const SurfaceGrid& grid, const HonedSurface& of, std::uint64_t seed);

/// A sprayed face with pores: a Gaussian surface with holes where a second, independent one is lowest. The share of the
/// area holds to one point.
struct PorousSurface {
  double fine_Sq_m = 0.3e-6;     ///< rms of the face between the pores [m]
  double fine_length_m = 3e-6;   ///< correlation length of the face between the pores [m]
  double pore_share = 0.15;      ///< share of the area that is pores, 0 to 0.9 [-]
  double pore_length_m = 15e-6;  ///< correlation length of the pores [m]
  double pore_depth_m = 4e-6;    ///< mean [m]
};

/// A made face, and where its pores are, which a test must find again.
struct PorousMap {
  HeightMap map;                   ///< with the pores in it, every point measured
  std::vector<std::uint8_t> pore;  ///< 1 where a pore is
};

/// A porous face; the same seed gives the same heights.
PorousMap porous_surface(const SurfaceGrid& grid, const PorousSurface& of, std::uint64_t seed);

}  // namespace ringfilm::surface
