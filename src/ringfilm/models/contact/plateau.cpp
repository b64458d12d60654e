#include "ringfilm/models/contact/plateau.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <utility>

namespace ringfilm::models {
namespace {

using std::numbers::sqrt2;

/// Core and reduced peaks of a Gaussian surface over its rms, by least squares over its middle 40 % [-].
constexpr double kCoreOfGaussian = 2.57396, kPeaksOfGaussian = 0.94503;

/// Standard normal variable that this share lies below.
double quantile(double share) { return -sqrt2 * boost::math::erfc_inv(2 * share); }

double share_below(double s) { return 0.5 * std::erfc(-s / sqrt2); }

/// F_1 of eq-gaussian-integral, for any s.
double mean_beyond(double s) { return std::exp(-0.5 * s * s) / std::sqrt(2 * std::numbers::pi) - s * share_below(-s); }

/// F_2 of eq-gaussian-integral, for any s.
double square_beyond(double s) { return share_below(-s) - s * mean_beyond(s); }

}  // namespace

PlateauPlanes plateau_planes(const PlateauCurve& curve) {
  const double s = quantile(curve.Rmq), steeper = curve.Rvq - curve.Rpq, mean = mean_beyond(s);
  const double square = curve.Rpq * curve.Rpq + 2 * curve.Rpq * steeper * (1 - curve.Rmq) +
                        steeper * steeper * (square_beyond(s) - mean * mean);
  return {steeper * mean, steeper * mean_beyond(-s), std::sqrt(square)};
}

PlateauCurve plateau_curve(const CoreValues& core) {
  const double s = quantile(core.Mr2);
  PlateauCurve curve{};
  curve.Rpq = (core.Rk + core.Rpk) / (kCoreOfGaussian + kPeaksOfGaussian);
  curve.Rvq = core.Rvk * (1 - core.Mr2) / (2 * mean_beyond(s));
  curve.Rmq = share_below((curve.Rvq * s - 0.5 * core.Rk) / (curve.Rvq - curve.Rpq));
  return curve;
}

ContactFunction plateau_contact(ContactFunction plateau, ContactFunction valleys, const PlateauPlanes& planes) {
  return [plateau = std::move(plateau), valleys = std::move(valleys), planes](double h) -> PressureAndArea {
    const PressureAndArea upper = plateau(h - planes.plateau), lower = valleys(h - planes.valleys);
    return {std::min(upper.pressure, lower.pressure), std::min(upper.area_share, lower.area_share)};
  };
}

}  // namespace ringfilm::models
