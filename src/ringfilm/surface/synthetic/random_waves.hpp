#pragma once
#include <complex>
#include <vector>

#include "ringfilm/surface/synthetic/synthetic.hpp"

namespace ringfilm::surface {

/// White noise, as waves: with a spectrum it becomes a Gaussian surface. The same waves serve many spectra, so that a
/// surface changes smoothly with the parameters of its spectrum.
class RandomWaves {
 public:
  /// @throws InputError for a grid with one column, no positive steps or more than 2^28 points
  RandomWaves(const SurfaceGrid& grid, std::uint64_t seed);

  /// Surface with mean power 1 (expected rms 1).
  /// @throws InputError for a spectrum that is negative, not a number or zero on the waves of the grid
  HeightMap surface(const PowerSpectrum& spectrum) const;

 private:
  SurfaceGrid grid_;
  std::size_t whole_x_, whole_y_;  // points of the periodic grid
  std::vector<std::complex<double>> waves_;
};

}  // namespace ringfilm::surface
