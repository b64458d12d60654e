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
  std::array<double, 3> mean_log{};  ///< means of the natural logarithms of the values in SI
  Matrix covariance{};               ///< covariance of one region, n - 1 below [products of the units of the means]
  /// Covariance of the logarithms of one region: relative; a study draws from it, since all values stay positive.
  Matrix covariance_log{};
  /// Covariance of the mean of the logarithms: it contains the squares of standard errors.
  Matrix mean_covariance_log{};

  /// Standard error of a mean, relative.
  double relative_standard_error(std::size_t parameter) const;
  /// Correlation of the logarithms of two parameters; 0 where one does not vary.
  double correlation(std::size_t first, std::size_t second) const;
};

/// Correlation of two parameters; 0 where one does not vary.
double correlation(const ParameterScatter::Matrix& covariance, std::size_t first, std::size_t second);

/// Scatter of parameters that were each taken from a region of its own. Regions that overlap or lie within a
/// correlation length are not independent samples: the standard error then is too small.
/// @throws InputError for fewer than two
ParameterScatter scatter_of(std::span<const AsperityParameters> samples);

/// Contact parameters of a pair whose surfaces were measured on different places: the parameters of the mean moments of
/// both, and the covariances of the logarithms as each surface varies against the mean of the other, added up (both are
/// independent). One surface may have a single measurement: it adds no scatter, and `without_scatter` is set.
struct PairScatter {
  AsperityParameters central;                      ///< parameters by the mean m2, m4 and roughness of both surfaces
  ParameterScatter::Matrix covariance_log{};       ///< covariance of the logarithms for one region of each surface
  ParameterScatter::Matrix mean_covariance_log{};  ///< covariance of the logarithms for the mean over the regions
  std::size_t first_count = 0;                     ///< regions of the first surface
  std::size_t second_count = 0;                    ///< regions of the second
  std::string without_scatter;                     ///< empty, "first", "second" or "both"
};

/// Contact parameters of a pair from the regions of both, with their scatter.
PairScatter scatter_of_pair(std::span<const SurfaceMeasures> first, std::span<const SurfaceMeasures> second,
                            SigmaRule rule);

}  // namespace ringfilm::surface
