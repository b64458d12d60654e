#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// Power spectrum of lines of a map, mean of all of them, one-sided: its sum times the frequency step is their mean
/// square height; eq-spectrum-line.
struct LineSpectrum {
  std::vector<double> frequency_per_m;  ///< waves per metre, from one step up [1/m]
  std::vector<double> density_m3;       ///< mean square height per frequency [m^3]
  std::size_t lines = 0;                ///< that had points enough
};

/// Power spectrum over both directions, mean over all directions of one wavelength, two-sided: its integral over the
/// plane of frequencies is the mean square height; eq-spectrum-radial.
struct RadialSpectrum {
  std::vector<double> frequency_per_m;  ///< mean of the waves in each ring [1/m]
  std::vector<double> density_m4;       ///< mean square height per area of frequencies [m^4]
  std::vector<std::size_t> waves;       ///< in each ring
};

enum class LineDirection { x, y };

/// The window of all spectra.
inline constexpr const char* kSpectrumWindow = "Hann";

/// Each line about its mean, under a Hann window. Missing points have no weight in it: a line with many of them shows
/// its window too. Lines with fewer than half of their points, or fewer than 16, are omitted.
/// @throws InputError where no line is left
LineSpectrum line_spectrum(const HeightMap& map, LineDirection direction);

/// The map about its mean, under a Hann window along x and y; missing points have no weight in it.
/// @throws InputError for a profile, fewer than 16 points in a direction, or less than half of the points measured
RadialSpectrum radial_spectrum(const HeightMap& map);

}  // namespace ringfilm::surface
