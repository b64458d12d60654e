#pragma once
#include <complex>
#include <span>
#include <vector>

namespace ringfilm::surface {

/// Fourier transform of a real grid: points_x/2 + 1 waves along x, points_y along y, row after row, not scaled.
std::vector<std::complex<double>> waves_of(std::span<const double> values, std::size_t points_x, std::size_t points_y);

/// The grid of such waves, divided by the number of points: the way back.
std::vector<double> values_of(std::vector<std::complex<double>> waves, std::size_t points_x, std::size_t points_y);

/// Frequency of wave k of n, in waves over the whole length: 0, 1, ..., n/2, ..., -1.
double wave_number(std::size_t k, std::size_t n);

}  // namespace ringfilm::surface
