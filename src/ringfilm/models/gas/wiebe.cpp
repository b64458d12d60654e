#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/gas/gas_checks.hpp"
#include "ringfilm/models/gas/gas_exchange.hpp"

namespace ringfilm::models {
namespace {

constexpr double kExponent = 1.33;                 // p V^k constant without heat: gas and mean wall loss [-]
constexpr double kEfficiency = 6.907755278982137;  // ln 1000: 99.9 % burned after the burn duration [-]
constexpr double kForm = 2;                        // Wiebe's form exponent [-]
constexpr double kStep = 0.1;                      // [degree]

/// Congruent angle in [0, 720).
double in_one_cycle(double angle) { return angle - base::kCycleDeg * std::floor(angle / base::kCycleDeg); }

/// Compression, combustion and expansion of a closed charge: with V in units of the clearance volume,
/// d(p V^k) = (k - 1) V^(k-1) dQ, dQ = Q dx_b.
class ClosedCharge {
 public:
  explicit ClosedCharge(const WiebeCycle& cycle)
      : crank_(cycle.crank),
        swept_((cycle.compression_ratio - 1) / cycle.crank.stroke()),
        duration_(cycle.burn_duration_deg) {}

  double volume(double angle) const { return 1 + swept_ * crank_.position(radians(angle)); }

  /// dV per degree.
  double volume_slope(double angle) const { return -swept_ * crank_.velocity(radians(angle), radians(1)); }

  /// p V^k/p_0 grows by this much per degree and unit of (k - 1) Q, with combustion from `start` on.
  double heat_rate(double angle, double start) const {
    const double share = (angle - start) / duration_;
    if (share <= 0) return 0;
    const double power = std::pow(share, kForm);
    const double burn_rate = kEfficiency * (kForm + 1) / duration_ * power * std::exp(-kEfficiency * power * share);
    return std::pow(volume(angle), kExponent - 1) * burn_rate;
  }

  /// Integral of heat_rate from the start of combustion to `angle`.
  double heat(double angle, double start) const {
    return boost::math::quadrature::gauss<double, 30>::integrate([&](double a) { return heat_rate(a, start); }, start,
                                                                 angle);
  }

 private:
  static double radians(double angle) { return angle * boost::math::double_constants::degree; }

  CrankSlider crank_;
  double swept_;     // [clearance volumes per m]
  double duration_;  // [degree]
};

/// Start of combustion and heat with which the pressure is stationary at the stated angle and has the stated value
/// there.
struct Combustion {
  double start;  // [degree]
  double heat;   // (k - 1) Q over the clearance volume [Pa]
};

InputError unreachable(const WiebeCycle& cycle, const std::string& why, const std::string& remedy) {
  return InputError("gas.peak_pressure = " + text_in(cycle.peak_pressure, kBar) +
                        " at gas.peak_angle = " + in_degrees(cycle.peak_angle_deg) + " cannot be reached: " + why,
                    remedy);
}

Combustion fitted_combustion(const WiebeCycle& cycle, const ClosedCharge& charge, double closing) {
  const double peak = cycle.peak_angle_deg, V = charge.volume(peak);
  const double motored = cycle.intake_pressure * std::pow(charge.volume(closing) / V, kExponent);
  if (!(cycle.peak_pressure > motored)) {
    throw unreachable(cycle, "compression alone gives " + text_in(motored, kBar) + " there",
                      "ask for a higher peak or a smaller gas.compression_ratio");
  }
  // At the peak (k - 1) dQ = k p dV. What is left is how far burning must have come so that p V^k has risen enough.
  const double heat_rate_at_peak =
      kExponent * cycle.peak_pressure * charge.volume_slope(peak) * std::pow(V, kExponent - 1);
  const double rise_required = (cycle.peak_pressure - motored) * std::pow(V, kExponent);
  const auto missing = [&](double start) {
    return rise_required - heat_rate_at_peak * charge.heat(peak, start) / charge.heat_rate(peak, start);
  };
  constexpr double kOverburnt = 2.5;  // burn durations; the burn rate is down to 1e-45 there
  const double latest = peak - 1e-6 * cycle.burn_duration_deg;
  const double earliest = std::max(closing, peak - kOverburnt * cycle.burn_duration_deg);
  if (!(missing(latest) > 0) || !(missing(earliest) < 0)) {
    throw unreachable(cycle, "combustion would have to start before the intake valve closes at " + in_degrees(closing),
                      "ask for a later or lower peak or a shorter gas.burn_duration");
  }
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(missing, earliest, latest,
                                                             boost::math::tools::eps_tolerance<double>(), iterations);
  const double start = (low + high) / 2;
  return {start, rise_required / charge.heat(peak, start)};
}

struct Samples {
  std::vector<double> angle, pressure;
};

/// The closed part from the closing of the intake valve to the opening of the exhaust valve, with a sample on the peak.
Samples closed_part(const WiebeCycle& cycle, const ClosedCharge& charge, const Combustion& combustion, double closing,
                    double opening) {
  Samples s;
  const double peak = cycle.peak_angle_deg;
  const int first = static_cast<int>(std::floor((closing - peak) / kStep)) + 1;
  const int last = static_cast<int>(std::ceil((opening - peak) / kStep)) - 1;
  s.angle.push_back(closing);
  for (int k = first; k <= last; ++k) s.angle.push_back(peak + k * kStep);
  s.angle.push_back(opening);

  double invariant = cycle.intake_pressure * std::pow(charge.volume(closing), kExponent);  // p V^k
  double rate = 0;
  for (std::size_t k = 0; k < s.angle.size(); ++k) {
    const double at = s.angle[k];
    if (k > 0 && at > combustion.start) {  // Simpson; the rate starts with slope zero, so the start needs no node
      const double from = s.angle[k - 1], end_rate = charge.heat_rate(at, combustion.start);
      const double middle_rate = charge.heat_rate((from + at) / 2, combustion.start);
      invariant += combustion.heat * (at - from) / 6 * (rate + 4 * middle_rate + end_rate);
      rate = end_rate;
    }
    s.pressure.push_back(invariant / std::pow(charge.volume(at), kExponent));
  }
  return s;
}

/// Valve angles in the order of the cycle: exhaust opens, the overlap, intake closes; checked.
GasExchange gas_exchange(const WiebeCycle& cycle) {
  constexpr double kBottom = 180, kMinBlowDown = 40, kMinOverlap = 20;  // [degree]
  const double opening = in_one_cycle(cycle.exhaust_valve_opening_deg);
  const double one = in_one_cycle(cycle.exhaust_valve_closing_deg),
               other = in_one_cycle(cycle.intake_valve_opening_deg);
  const double middle = (one + other) / 2;
  const double half = std::max(std::abs(one - other), kMinOverlap) / 2;
  const GasExchange exchange{.exhaust_from = std::max(kBottom, opening + kMinBlowDown),
                             .overlap_begin = middle - half,
                             .overlap_end = middle + half,
                             .intake_until = in_one_cycle(cycle.intake_valve_closing_deg),
                             .exhaust_pressure = cycle.exhaust_pressure,
                             .intake_pressure = cycle.intake_pressure};
  if (!(opening > cycle.peak_angle_deg)) {
    throw InputError("gas.exhaust_valve_opening = " + in_degrees(opening) + " is not after the peak pressure at " +
                         in_degrees(cycle.peak_angle_deg),
                     "give the opening as degrees after firing TDC, for example \"130 degree\"");
  }
  if (!(exchange.exhaust_from <= exchange.overlap_begin && exchange.overlap_end <= exchange.intake_until)) {
    throw InputError("the valve angles leave no room for the gas exchange: exhaust opens at " + in_degrees(opening) +
                         " and closes at " + in_degrees(one) + ", intake opens at " + in_degrees(other) +
                         " and closes at " + in_degrees(exchange.intake_until),
                     "give them as degrees after firing TDC, for example 130, 375, 345 and 590 degree");
  }
  return exchange;
}

void check_cycle(const WiebeCycle& cycle) {
  check_gas_pressure("gas.intake_pressure", cycle.intake_pressure);
  check_gas_pressure("gas.exhaust_pressure", cycle.exhaust_pressure);
  check_gas_pressure("gas.peak_pressure", cycle.peak_pressure);
  if (!(cycle.compression_ratio > 1)) {
    throw InputError("gas.compression_ratio is not above 1", "give the geometric compression ratio, for example 10.5");
  }
  if (!(cycle.burn_duration_deg > 0)) {
    throw InputError("gas.burn_duration = " + in_degrees(cycle.burn_duration_deg) + " is not positive",
                     "give the crank angle of the whole combustion, for example \"60 degree\"");
  }
  if (!(cycle.peak_angle_deg > 0)) {
    throw InputError("gas.peak_angle = " + in_degrees(cycle.peak_angle_deg) +
                         " is not after firing TDC, where heat alone can make a peak",
                     "give an angle after TDC, for example \"15 degree\"");
  }
}

}  // namespace

CyclePressure wiebe_pressure(const WiebeCycle& cycle) {
  check_cycle(cycle);
  const auto exchange = gas_exchange(cycle);
  const double closing = exchange.intake_until - base::kCycleDeg,
               opening = in_one_cycle(cycle.exhaust_valve_opening_deg);
  const ClosedCharge charge(cycle);
  const auto combustion = fitted_combustion(cycle, charge, closing);
  auto [angle, pressure] = closed_part(cycle, charge, combustion, closing, opening);

  CyclePressure whole = closed_cycle(std::move(angle), std::move(pressure), exchange);
  if (whole.peak() > cycle.peak_pressure * (1 + 1e-6)) {
    throw unreachable(
        cycle, "the pressure is higher, " + text_in(whole.peak(), kBar) + ", at " + in_degrees(whole.peak_angle_deg()),
        "ask for a higher peak, or change gas.compression_ratio, gas.burn_duration or "
        "gas.exhaust_pressure");
  }
  return whole;
}

}  // namespace ringfilm::models
