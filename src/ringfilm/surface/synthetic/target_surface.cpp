#include "ringfilm/surface/synthetic/target_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/random_waves.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kHurst = 0.8;
constexpr double kSmallChange = 1e-5;  // change of a logarithm for the slopes of Newton's method
constexpr double kMaxStep = 0.5;
constexpr double kClose = 1e-12;
constexpr int kMaxSearchSteps = 60;

/// Logarithms of roll-off and short wavelength, and of what they give: m2 and m4 over the squared roughness.
using Pair = Eigen::Vector2d;

[[noreturn]] void not_found() {
  throw InputError(
      "no surface with the target roughness, m2 and m4 is found on this grid",
      "the short waves, about 2 pi times the root of m2/m4, require 8 steps or more; the map some roll-off "
      "lengths; roughness^2 m4/m2^2 must be clearly above 3");
}

PowerSpectrum spectrum_of(const Pair& lengths) {
  return self_affine(kHurst, std::exp(lengths[0]), std::exp(lengths[1]));
}

Pair ratios(double roughness_m, double m2, double m4) {
  if (!(roughness_m > 0 && m2 > 0 && m4 > 0)) not_found();
  const double square = roughness_m * roughness_m;
  return {std::log(m2 / square), std::log(m4 / square)};
}

/// Logarithms of m2 and m4 over the squared roughness, by the spectrum itself on an unbounded surface.
Pair expected_ratios(const Pair& lengths, double roughness_per_rms) {
  const PowerSpectrum spectrum = spectrum_of(lengths);
  double m0 = 0, m2 = 0, m4 = 0;
  // Even steps of the logarithm of frequency, from 1e-3 of the roll-off to where the exponential has ended.
  const double first = -std::max(lengths[0], lengths[1]) - std::log(1e3), last = -lengths[1] + std::log(7.0);
  const int steps = 600;
  for (int k = 0; k <= steps; ++k) {
    const double f = std::exp(first + (last - first) * k / steps), q = 2 * std::numbers::pi * f;
    const double power = spectrum(f, 0) * f * f;
    m0 += power;
    m2 += power * q * q / 2;
    m4 += power * q * q * q * q * 3 / 8;
  }
  return ratios(std::sqrt(m0) * roughness_per_rms, m2, m4);
}

/// Newton's method with slopes by differences and steps of limited length; stops when close or when nothing improves.
Pair solve(Pair at, const std::function<Pair(const Pair&)>& difference, double close) {
  Pair rest = difference(at);
  for (int step = 0; step < kMaxSearchSteps && rest.cwiseAbs().maxCoeff() > close; ++step) {
    Eigen::Matrix2d slopes;
    for (int k = 0; k < 2; ++k) slopes.col(k) = (difference(at + kSmallChange * Pair::Unit(k)) - rest) / kSmallChange;
    if (!(std::abs(slopes.determinant()) > 1e-12)) not_found();
    Pair change = -slopes.inverse() * rest;
    const double longest = change.cwiseAbs().maxCoeff();
    if (longest > kMaxStep) change *= kMaxStep / longest;
    bool better = false;
    for (int halving = 0; halving < 6 && !better; ++halving, change *= 0.5) {
      const Pair trial = at + change, left = difference(trial);
      better = left.norm() < rest.norm();
      if (!better) continue;
      at = trial;
      rest = left;
    }
    if (!better) break;
  }
  return at;
}

}  // namespace

TargetSurface counterpart(const AsperityParameters& pair, const TargetSurface& first) {
  const SpectralMoments sum = moments_of(pair.density_per_m2, pair.beta_m);
  const double square = pair.sigma_m * pair.sigma_m - first.roughness_m * first.roughness_m;
  TargetSurface second{first.rule, 0, sum.m2 - first.m2, sum.m4_per_m2 - first.m4_per_m2};
  if (!(square > 0 && second.m2 > 0 && second.m4_per_m2 > 0)) {
    throw InputError("one surface of the pair alone is rougher than the pair should be",
                     "give it less roughness, m2 and m4");
  }
  second.roughness_m = std::sqrt(square);
  return second;
}

HeightMap surface_with(const TargetSurface& target, const SurfaceGrid& grid, std::uint64_t seed,
                       const SurfaceMeasuring& measuring) {
  const Pair goal = ratios(target.roughness_m, target.m2, target.m4_per_m2);
  const auto measures = [&](const HeightMap& map) { return measuring ? measuring(map) : surface_measures(map); };
  const auto roughness = [&](const SurfaceMeasures& of) { return target.rule == SigmaRule::ra ? of.Sa_m : of.Sq_m; };
  const RandomWaves waves(grid, seed);
  const double per_rms = target.rule == SigmaRule::ra ? std::sqrt(2 / std::numbers::pi) : 1.0;
  // Heights of about the target size, within the range of what measures them.
  const auto made = [&](const Pair& lengths) {
    HeightMap map = waves.surface(spectrum_of(lengths));
    for (double& height : map.height_m) height *= target.roughness_m / per_rms;
    return map;
  };
  const double short_wave = 2 * std::numbers::pi * std::sqrt(target.m2 / target.m4_per_m2);
  Pair lengths(std::log(10 * short_wave), std::log(0.5 * short_wave));
  lengths = solve(
      lengths, [&](const Pair& at) -> Pair { return expected_ratios(at, per_rms) - goal; }, 1e-6);
  if ((expected_ratios(lengths, per_rms) - goal).cwiseAbs().maxCoeff() > 1e-3) not_found();
  lengths = solve(
      lengths,
      [&](const Pair& at) -> Pair {
        const SurfaceMeasures of = measures(made(at));
        return ratios(roughness(of), of.moments.m2, of.moments.m4_per_m2) - goal;
      },
      kClose);
  HeightMap map = made(lengths);
  const double factor = target.roughness_m / roughness(measures(map));
  for (double& height : map.height_m) height *= factor;
  const SurfaceMeasures found = measures(map);
  const Pair rest = ratios(roughness(found), found.moments.m2, found.moments.m4_per_m2) - goal;
  if (rest.cwiseAbs().maxCoeff() > 100 * kClose || std::abs(roughness(found) / target.roughness_m - 1) > 100 * kClose) {
    not_found();
  }
  return map;
}

}  // namespace ringfilm::surface
