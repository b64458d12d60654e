#include "ringfilm/surface/asperity/asperities.hpp"

#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::surface {
namespace {

const double kSummitCurvature = 8 / (3 * std::sqrt(std::numbers::pi));  // mean of the summits, in roots of m4
const double kSummitDensity = 1 / (6 * std::numbers::pi * std::sqrt(3.0));

double roughness_of(const SurfaceMeasures& surface, SigmaRule rule) {
  return rule == SigmaRule::ra ? surface.Sa_m : surface.Sq_m;
}

}  // namespace

SurfaceMeasures surface_measures(const HeightMap& map, MomentDirection direction, DifferenceScheme scheme) {
  const HeightStatistics heights = height_statistics(map);
  return {heights.Sa_m, heights.Sq_m, moments(moment_table(map, scheme), direction)};
}

AsperityParameters asperity_parameters(const SpectralMoments& moments, double sigma_m) {
  const auto is_positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (!is_positive(moments.m2) || !is_positive(moments.m4_per_m2)) {
    throw InputError(
        "the spectral moments m2 and m4 are not both positive: the surface is flat, the radius of its "
        "asperities infinite",
        "choose another channel, region or filter");
  }
  if (!is_positive(sigma_m)) throw InputError("a roughness of " + length_text(sigma_m) + " is not a positive length");
  return {kSummitDensity * moments.m4_per_m2 / moments.m2, 1 / (kSummitCurvature * std::sqrt(moments.m4_per_m2)),
          sigma_m};
}

AsperityParameters pair_parameters(const SurfaceMeasures& first, const SurfaceMeasures& second, SigmaRule rule) {
  const SpectralMoments &a = first.moments, &b = second.moments;
  return asperity_parameters({a.m0_m2 + b.m0_m2, a.m2 + b.m2, a.m4_per_m2 + b.m4_per_m2},
                             std::hypot(roughness_of(first, rule), roughness_of(second, rule)));
}

AsperityParameters single_parameters(const SurfaceMeasures& surface, SigmaRule rule) {
  return asperity_parameters(surface.moments, roughness_of(surface, rule));
}

std::string sigma_text(SigmaRule rule) {
  return rule == SigmaRule::ra ? "root of the sum of squares of Ra (Sa of a map)"
                               : "root of the sum of squares of Rq (Sq of a map)";
}

SpectralMoments moments_of(double density_per_m2, double beta_m) {
  const auto is_positive = [](double value) { return std::isfinite(value) && value > 0; };
  if (!is_positive(density_per_m2) || !is_positive(beta_m)) {
    throw InputError("a density and a radius of asperities that are not both positive have no spectral moments");
  }
  const double m4 = std::pow(1 / (kSummitCurvature * beta_m), 2);
  return {0, kSummitDensity * m4 / density_per_m2, m4};
}

}  // namespace ringfilm::surface
