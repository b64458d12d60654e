#include "ringfilm/surface/asperity/scatter.hpp"

#include <cmath>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

using Vector = std::array<double, 3>;
using Matrix = ParameterScatter::Matrix;

Vector values_of_parameters(const AsperityParameters& of) { return {of.density_per_m2, of.beta_m, of.sigma_m}; }

Vector logarithms(const AsperityParameters& of) {
  Vector logs = values_of_parameters(of);
  for (double& value : logs) {
    if (!(std::isfinite(value) && value > 0)) {
      throw InputError("N, beta and sigma of a region are not all positive: they have no scatter");
    }
    value = std::log(value);
  }
  return logs;
}

Vector mean_of(const std::vector<Vector>& samples) {
  Vector mean{};
  for (const Vector& sample : samples) {
    for (std::size_t i = 0; i < 3; ++i) mean[i] += sample[i] / static_cast<double>(samples.size());
  }
  return mean;
}

/// n - 1 below; zero for a single sample.
Matrix covariance_of(const std::vector<Vector>& samples) {
  Matrix covariance{};
  if (samples.size() < 2) return covariance;
  const Vector mean = mean_of(samples);
  for (const Vector& sample : samples) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        covariance[i][j] += (sample[i] - mean[i]) * (sample[j] - mean[j]) / static_cast<double>(samples.size() - 1);
      }
    }
  }
  return covariance;
}

void add(Matrix& sum, const Matrix& other, double factor) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum[i][j] += factor * other[i][j];
  }
}

SurfaceMeasures mean_measures(std::span<const SurfaceMeasures> samples) {
  if (samples.empty()) throw InputError("a surface of the pair has no measurement");
  SurfaceMeasures mean;
  const double share = 1 / static_cast<double>(samples.size());
  for (const SurfaceMeasures& of : samples) {
    mean.Sa_m += share * of.Sa_m;
    mean.Sq_m += share * of.Sq_m;
    mean.moments.m0_m2 += share * of.moments.m0_m2;
    mean.moments.m2 += share * of.moments.m2;
    mean.moments.m4_per_m2 += share * of.moments.m4_per_m2;
  }
  return mean;
}

/// Adds what one surface's regions do to the parameters of the pair.
void add_surface(PairScatter& of, std::span<const SurfaceMeasures> samples, const SurfaceMeasures& other,
                 SigmaRule rule) {
  std::vector<Vector> logs;
  for (const SurfaceMeasures& sample : samples) logs.push_back(logarithms(pair_parameters(sample, other, rule)));
  const Matrix covariance = covariance_of(logs);
  add(of.covariance_log, covariance, 1);
  add(of.mean_covariance_log, covariance, 1 / static_cast<double>(samples.size()));
}

}  // namespace

double ParameterScatter::relative_standard_error(std::size_t parameter) const {
  return std::sqrt(mean_covariance_log.at(parameter)[parameter]);
}

double correlation(const Matrix& covariance, std::size_t first, std::size_t second) {
  const double spread = std::sqrt(covariance.at(first)[first] * covariance.at(second)[second]);
  return spread > 0 ? covariance[first][second] / spread : 0.0;
}

double ParameterScatter::correlation(std::size_t first, std::size_t second) const {
  return surface::correlation(covariance_log, first, second);
}

ParameterScatter scatter_of(std::span<const AsperityParameters> samples) {
  if (samples.size() < 2) {
    throw InputError("the scatter of one region is not known",
                     "measure two regions or more; ten give a better estimate than two");
  }
  std::vector<Vector> values, logs;
  for (const AsperityParameters& sample : samples) {
    logs.push_back(logarithms(sample));
    values.push_back(values_of_parameters(sample));
  }
  ParameterScatter of;
  of.count = samples.size();
  of.mean = mean_of(values);
  of.mean_log = mean_of(logs);
  of.covariance = covariance_of(values);
  of.covariance_log = covariance_of(logs);
  add(of.mean_covariance_log, of.covariance_log, 1 / static_cast<double>(of.count));
  return of;
}

PairScatter scatter_of_pair(std::span<const SurfaceMeasures> first, std::span<const SurfaceMeasures> second,
                            SigmaRule rule) {
  const SurfaceMeasures mean_first = mean_measures(first), mean_second = mean_measures(second);
  PairScatter of;
  of.central = pair_parameters(mean_first, mean_second, rule);
  of.first_count = first.size();
  of.second_count = second.size();
  add_surface(of, first, mean_second, rule);
  add_surface(of, second, mean_first, rule);
  const bool first_alone = first.size() < 2, second_alone = second.size() < 2;
  of.without_scatter = first_alone && second_alone ? "both" : first_alone ? "first" : second_alone ? "second" : "";
  return of;
}

}  // namespace ringfilm::surface
