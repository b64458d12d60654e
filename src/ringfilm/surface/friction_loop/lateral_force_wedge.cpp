#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/friction_loop/lateral_force_calibration.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kSteepestFacet = 1.4;  // [rad]
constexpr double kMinFriction = 1e-6, kMaxFriction = 1.0 - 1e-9;

/// Input of the wedge equations: slopes over load of the half width on the steep facet and of the difference of the
/// offsets, and both angles. The steep facet climbs.
enum Input { kWidth, kOffsets, kSteep, kOther, kInputs };
using Inputs = std::array<double, kInputs>;

struct Solution {
  double alpha;  ///< lateral force over lateral signal
  double mu;     ///< coefficient of friction
};

/// cos^2 - mu^2 sin^2
double common_divisor(double angle, double mu) {
  return std::cos(angle) * std::cos(angle) - mu * mu * std::sin(angle) * std::sin(angle);
}

/// alpha dW/dL of one facet, eq-wedge-width.
double width_slope(double angle, double mu) { return mu / common_divisor(angle, mu); }

/// alpha dDelta/dL, eq-wedge-offset.
double offset_slope(double angle, double mu) {
  return (1 + mu * mu) * std::sin(angle) * std::cos(angle) / common_divisor(angle, mu);
}

/// Offsets over width, eq-wedge-ratio: falls with mu from infinity on.
double ratio(const Inputs& in, double mu) {
  return (offset_slope(in[kSteep], mu) - offset_slope(in[kOther], mu)) / width_slope(in[kSteep], mu);
}

std::optional<Solution> solution(const Inputs& in) {
  if (in[kWidth] <= 0) return std::nullopt;
  const double measured = in[kOffsets] / in[kWidth];
  const auto difference = [&](double mu) { return ratio(in, mu) - measured; };
  // Beyond 1/tan(angle) a tip locks; the equations have no meaning there.
  const double highest = std::min(kMaxFriction, (1.0 - 1e-9) / std::tan(in[kSteep]));
  if (!(difference(kMinFriction) > 0) || !(difference(highest) < 0)) return std::nullopt;
  std::uintmax_t steps = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(difference, kMinFriction, highest,
                                                             boost::math::tools::eps_tolerance<double>(48), steps);
  const double mu = (low + high) / 2;
  return Solution{width_slope(in[kSteep], mu) / in[kWidth], mu};
}

}  // namespace

WedgeCalibration calibrate_on_wedge(const WedgeFacet& first, const WedgeFacet& second, LoadUnit load_unit) {
  // The steeper one comes first, and its slope counts as rising: turned about, all angles and offsets change sign.
  if (std::abs(first.angle_rad.value) < std::abs(second.angle_rad.value)) {
    return calibrate_on_wedge(second, first, load_unit);
  }
  const double turn = first.angle_rad.value < 0 ? -1 : 1;
  const double steep = turn * first.angle_rad.value, other = turn * second.angle_rad.value;
  if (!(steep > other) || !(steep < kSteepestFacet)) {
    throw InputError("the two facets of the grating require unequal angles below 80 degrees",
                     "give the angle of each to the base, with its sign: for example 54.7 and -54.7, or 54.7 and 0");
  }
  const Inputs in{first.half_width.slope, turn * (first.offset.slope - second.offset.slope), steep, other};
  const Inputs deviations{first.half_width.slope_deviation,
                          std::hypot(first.offset.slope_deviation, second.offset.slope_deviation),
                          first.angle_rad.deviation, second.angle_rad.deviation};
  const auto solved = solution(in);
  if (!solved) {
    throw InputError("no coefficient of friction below 1 explains the loops on the two facets",
                     "check the sign of the angles and which facet is which, and that the loads rise");
  }
  double measured = 0, taken_over = 0, friction = 0;
  for (int i = 0; i < kInputs; ++i) {
    if (deviations[i] == 0) continue;
    // A tenth of the deviation is small enough for a slope, and far above rounding.
    const double step = 0.1 * deviations[i];
    Inputs up = in, down = in;
    up[i] += step;
    down[i] -= step;
    const auto above = solution(up), below = solution(down);
    if (!above || !below) {
      throw InputError("the loops on the two facets scatter too much to fix a calibration",
                       "measure more loops, over a wider range of loads");
    }
    const double alpha_share = (above->alpha - below->alpha) / (2 * step) * deviations[i];
    const double mu_share = (above->mu - below->mu) / (2 * step) * deviations[i];
    (i < kSteep ? measured : taken_over) += alpha_share * alpha_share;
    friction += mu_share * mu_share;
  }
  const double freedom = std::min(
      {first.half_width.degrees_of_freedom(), first.offset.degrees_of_freedom(), second.offset.degrees_of_freedom()});
  const double width_ratio = width_slope(steep, solved->mu) / width_slope(other, solved->mu);
  return {{CalibrationMethod::kWedge,
           load_unit,
           solved->alpha,
           std::sqrt(measured),
           std::sqrt(taken_over),
           freedom,
           {first.half_width, second.half_width}},
          {solved->mu, std::sqrt(friction)},
          first.half_width.slope / second.half_width.slope / width_ratio - 1};
}

}  // namespace ringfilm::surface
