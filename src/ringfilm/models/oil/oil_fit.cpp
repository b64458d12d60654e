#include "ringfilm/models/oil/oil_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace ringfilm::models {
namespace {

constexpr int kNodes = OilFit::kFluidityDegree + 1;
// Four times as many, both ends included; no common divisor of the intervals and 2 kNodes, so that no node is checked.
constexpr int kChecks = 48;
constexpr int kPoints = kNodes + kChecks;

/// A law at the nodes and, behind them, at the check points.
using Curve = std::array<double, kPoints>;

struct Curves {
  Curve K, dK_dp, rho, drho_dp;
};

/// Nodes of Chebyshev's interpolation, then the check points; t between -1 and 1.
Curve places() {
  Curve t;
  for (int k = 0; k < kNodes; ++k) t[k] = std::cos(std::numbers::pi * (k + 0.5) / kNodes);
  for (int k = 0; k < kChecks; ++k) t[kNodes + k] = std::cos(std::numbers::pi * k / (kChecks - 1));
  return t;
}

std::optional<Curves> curves(const OilAtTemperature& oil, const Curve& p) {
  constexpr double kTooStiff = 1e100;  // [Pa s]; a viscosity to be squared, or already infinite
  Curves c;
  Curve eta, deta_dp;
  oil.properties(p, {c.rho, c.drho_dp, eta, deta_dp});
  for (int i = 0; i < kPoints; ++i) {
    if (!(c.rho[i] > 0 && std::isfinite(c.rho[i]) && eta[i] > 0 && eta[i] < kTooStiff)) return std::nullopt;
    c.K[i] = c.rho[i] / eta[i];
    c.dK_dp[i] = (c.drho_dp[i] - c.K[i] * deta_dp[i]) / eta[i];
  }
  return c;
}

/// The Chebyshev interpolant of all nodes, cut after `degree` and sorted by powers of t. The coefficients of an oil's
/// laws fall so fast that powers lose nothing against Chebyshev's polynomials.
template <std::size_t n>
void interpolate(const Curve& t, const Curve& f, std::array<double, n>& powers) {
  static_assert(n <= kNodes);
  Curve previous, value;  // T_(j-1) and T_j at the nodes
  std::fill_n(previous.begin(), kNodes, 0.0);
  std::fill_n(value.begin(), kNodes, 1.0);
  std::array<double, n> T_previous{}, T{1.0};  // and their coefficients
  powers = {};
  for (std::size_t j = 0; j < n; ++j) {
    double sum = 0;
    for (int k = 0; k < kNodes; ++k) sum += f[k] * value[k];
    const double share = (j == 0 ? 1.0 : 2.0) / kNodes * sum;
    for (std::size_t i = 0; i <= j; ++i) powers[i] += share * T[i];
    const double twice = j == 0 ? 1.0 : 2.0;  // T_1 = t T_0, then T_(j+1) = 2 t T_j - T_(j-1)
    for (int k = 0; k < kNodes; ++k) previous[k] = std::exchange(value[k], twice * t[k] * value[k] - previous[k]);
    for (std::size_t i = n; i-- > 0;) {
      T_previous[i] = std::exchange(T[i], (i > 0 ? twice * T[i - 1] : 0.0) - T_previous[i]);
    }
  }
}

/// A NaN is larger than anything.
double larger(double a, double b) { return std::isnan(b) || b > a ? b : a; }

template <std::size_t n>
double largest_relative_error(const Curve& t, const Curve& f, const std::array<double, n>& powers) {
  double largest = 0;
  for (int i = kNodes; i < kPoints; ++i) largest = larger(largest, std::abs(polynomial(powers, t[i]) / f[i] - 1));
  return largest;
}

template <std::size_t n>
double largest_slope_error(const Curve& t, const Curve& f, const std::array<double, n>& powers) {
  double difference = 0, slope = 0;
  for (int i = kNodes; i < kPoints; ++i) {
    difference = larger(difference, std::abs(polynomial(powers, t[i]) - f[i]));
    slope = larger(slope, std::abs(f[i]));
  }
  return difference == 0 ? 0.0 : difference / slope;
}

FitErrors errors_of(const OilFit& fit, const Curve& t, const Curves& law) {
  return {larger(largest_relative_error(t, law.K, fit.K), largest_relative_error(t, law.rho, fit.rho)),
          larger(largest_slope_error(t, law.dK_dp, fit.dK_dp), largest_slope_error(t, law.drho_dp, fit.drho_dp))};
}

/// Pressures of the places.
Curve pressures(const OilFit& fit, const Curve& t) {
  Curve p;
  for (int i = 0; i < kPoints; ++i) p[i] = fit.centre + fit.half_width * t[i];
  return p;
}

class FittedOil final : public OilAtTemperature {
 public:
  FittedOil(std::shared_ptr<const OilAtTemperature> exact, const OilFit& fit) : exact_(std::move(exact)), fit_(fit) {}

  void properties(std::span<const double> p, OilProperties out) const override { exact_->properties(p, out); }
  const OilFit* fit() const override { return &fit_; }

 private:
  std::shared_ptr<const OilAtTemperature> exact_;
  OilFit fit_;
};

}  // namespace

std::optional<OilFit> fit_oil(const OilAtTemperature& exact, double low, double high) {
  OilFit fit{};
  fit.low = low;
  fit.high = high;
  fit.centre = (low + high) / 2;
  fit.half_width = (high - low) / 2;
  const Curve t = places();
  const auto law = curves(exact, pressures(fit, t));
  if (!law) return std::nullopt;
  interpolate(t, law->K, fit.K);
  interpolate(t, law->dK_dp, fit.dK_dp);
  interpolate(t, law->rho, fit.rho);
  interpolate(t, law->drho_dp, fit.drho_dp);
  const FitErrors errors = errors_of(fit, t, *law);
  fit.error = errors.value;
  fit.slope_error = errors.slope;
  const bool certified = fit.error <= kFitError && fit.slope_error <= kFitSlopeError;
  if (!certified) return std::nullopt;
  return fit;
}

std::shared_ptr<const OilAtTemperature> fitted_oil(std::shared_ptr<const OilAtTemperature> exact, double low,
                                                   double high) {
  const auto fit = fit_oil(*exact, low, high);
  return fit ? with_fit(std::move(exact), *fit) : exact;
}

std::shared_ptr<const OilAtTemperature> with_fit(std::shared_ptr<const OilAtTemperature> exact, const OilFit& fit) {
  return std::make_shared<FittedOil>(std::move(exact), fit);
}

FitErrors fit_errors(const OilFit& fit, const OilAtTemperature& exact) {
  const Curve t = places();
  const auto law = curves(exact, pressures(fit, t));
  if (law) return errors_of(fit, t, *law);
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {none, none};
}

}  // namespace ringfilm::models
