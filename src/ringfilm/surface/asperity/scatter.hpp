#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "ringfilm/surface/asperity/asperities.hpp"

namespace ringfilm::surface {

/// Mean and scatter of N, beta and sigma, in this order, over regions or maps of one surface or pair; eq-scatter.
struct ParameterScatter {
  using Matrix = std::array<std::array<double, 3>, 3>;  ///< rows and columns: N, beta, sigma

  std::size_t count = 0;             ///< regions or maps
  std::array<double, 3> mean{};      ///< arithmetic means [1/m^2, m, m]
  std::array<double, 3> mean_log{};  ///< of the natural logarithms, in SI
  Matrix covariance{};               ///< of one region, n - 1 below [products of the units of the means]
  Matrix covariance_log{};           ///< of the logarithms: relative, and what a study draws from (all stay positive)
  Matrix mean_covariance_log{};      ///< of the mean of the logarithms: it contains the squares of standard errors

  /// Standard error of a mean, relative.
  double relative_standard_error(std::size_t parameter) const;
  /// Correlation of the logarithms of two parameters; 0 where one does not vary.
  double correlation(std::size_t first, std::size_t second) const;
};

/// Correlation of two parameters; 0 where one does not vary.
double correlation(const ParameterScatter::Matrix& covariance, std::size_t first, std::size_t second);

/// Of parameters that were each taken from a region of its own. Regions that overlap or lie within a correlation length
/// are not independent samples: the standard error then is too small.
/// @throws InputError for fewer than two
ParameterScatter scatter_of(std::span<const AsperityParameters> samples);

/// Of a pair whose surfaces were measured on different places: the parameters of the mean moments of both, and the
/// covariances of the logarithms as each surface varies against the mean of the other, added up (both are independent).
/// One surface may have a single measurement: it adds no scatter, and `without_scatter` is set.
struct PairScatter {
  AsperityParameters central;                      ///< of the mean m2, m4 and roughness of both
  ParameterScatter::Matrix covariance_log{};       ///< of one region of each
  ParameterScatter::Matrix mean_covariance_log{};  ///< of the mean over the regions
  std::size_t first_count = 0;                     ///< regions of the first surface
  std::size_t second_count = 0;                    ///< regions of the second
  std::string without_scatter;                     ///< empty, "first", "second" or "both"
};

/// Contact parameters of a pair from the regions of both, with their scatter.
PairScatter scatter_of_pair(std::span<const SurfaceMeasures> first, std::span<const SurfaceMeasures> second,
                            SigmaRule rule);

}  // namespace ringfilm::surface
