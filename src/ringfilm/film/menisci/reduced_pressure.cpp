#include "ringfilm/film/menisci/reduced_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"

namespace ringfilm::film {
namespace {

/// Share of K that is left at the highest pressure where its viscosity has risen by much [-].
constexpr double kMuch = 0.6;

/// K = rho/eta, its slope in pressure and the density.
struct OilAtPressure {
  double K, dK_dp, rho;
};

template <std::size_t n>
std::array<OilAtPressure, n> oil_at(const models::OilAtTemperature& oil, const std::array<double, n>& p) {
  std::array<OilAtPressure, n> values;
  if (const models::OilFit* fit = oil.fit(); fit != nullptr && p.back() <= fit->high) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto at = fit->at(p[k]);
      values[k] = {at.K, at.dK_dp, at.rho};
    }
    return values;
  }
  std::array<double, n> rho, drho, eta, deta;
  oil.properties(p, {rho, drho, eta, deta});
  for (std::size_t k = 0; k < n; ++k) {
    const double K = rho[k] / eta[k];
    values[k] = {K, K * (drho[k] / rho[k] - deta[k] / eta[k]), rho[k]};
  }
  return values;
}

/// Coefficients of the polynomial through (t, value), lowest power first, by divided differences.
template <std::size_t n>
std::array<double, n> through(const std::array<double, n>& t, std::array<double, n> value) {
  for (std::size_t order = 1; order < n; ++order) {
    for (std::size_t k = n - 1; k >= order; --k) value[k] = (value[k] - value[k - 1]) / (t[k] - t[k - order]);
  }
  std::array<double, n> c{};
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t i = n - 1; i > 0; --i) c[i] = c[i - 1] - t[k] * c[i];
    c[0] = value[k] - t[k] * c[0];
  }
  return c;
}

}  // namespace

ReducedPressure::ReducedPressure(const models::OilAtTemperature& oil, double high) : high_(high) {
  std::array<double, kNodes> p;
  for (std::size_t k = 0; k < kNodes; ++k) {
    p[k] = 0.5 * high * (1 - std::cos(std::numbers::pi * static_cast<double>(k) / (kNodes - 1)));
  }
  const std::array<OilAtPressure, kNodes> at = oil_at(oil, p);
  std::array<double, kNodes> reduced{};
  for (std::size_t k = 1; k < kNodes; ++k) {
    const double dp = p[k] - p[k - 1];
    reduced[k] = reduced[k - 1] + 0.5 * dp * (at[k].K + at[k - 1].K) - dp * dp / 12 * (at[k].dK_dp - at[k - 1].dK_dp);
  }
  if (!(reduced.back() > 0) || !std::isfinite(reduced.back())) {
    throw ConvergenceError("the oil has no viscosity up to " + text_in(high, kBar, 3));
  }
  reduced_high_ = reduced.back();
  const double rest = at.back().K / at.front().K;
  if (rest < kMuch) curvature_ = (1 - rest) / reduced_high_;
  const auto variable = [this](double phi) {
    return curvature_ > 0 ? -std::log(1 - curvature_ * phi) / curvature_ : phi;
  };
  centre_ = 0.5 * variable(reduced_high_);
  inverse_half_width_ = 1 / centre_;
  std::array<double, kNodes> t;
  std::array<double, kDensityNodes> t_of_density, rho;
  for (std::size_t k = 0; k < kNodes; ++k) t[k] = (variable(reduced[k]) - centre_) * inverse_half_width_;
  for (std::size_t k = 0; k < kDensityNodes; ++k) {
    constexpr std::size_t kEvery = (kNodes - 1) / (kDensityNodes - 1);
    t_of_density[k] = t[kEvery * k];
    rho[k] = at[kEvery * k].rho;
  }
  pressure_ = through(t, p);
  density_ = through(t_of_density, rho);
}

void ReducedPressure::at(std::span<const double> reduced, std::vector<double>& pressure, std::vector<double>& slope,
                         std::vector<double>& density) const {
  const std::size_t n = reduced.size();
  double *p = pressure.data(), *s = slope.data(), *rho = density.data();
  if (curvature_ > 0) {
    for (std::size_t j = 0; j < n; ++j) {
      const Oil oil = at(reduced[j]);
      p[j] = oil.pressure;
      s[j] = oil.slope;
      rho[j] = oil.density;
    }
    return;
  }
  for (std::size_t j = 0; j < n; ++j) {
    const double served = std::min(std::max(reduced[j], 0.0), reduced_high_),
                 t = (served - centre_) * inverse_half_width_;
    const auto oil = models::polynomial_and_slope(pressure_, t);
    s[j] = oil.slope * inverse_half_width_;
    p[j] = oil.value + s[j] * (reduced[j] - served);
    rho[j] = models::polynomial(density_, t);
  }
}

double ReducedPressure::of(double pressure) const {
  constexpr int kMaxIterations = 50;
  constexpr double kRounding = 1e-14;
  double reduced = reduced_high_ * pressure / high_;
  for (int k = 0; k < kMaxIterations; ++k) {
    const Oil oil = at(reduced);
    const double change = (pressure - oil.pressure) / oil.slope;
    reduced += change;
    if (std::abs(change) <= kRounding * reduced_high_) break;
  }
  return reduced;
}

}  // namespace ringfilm::film
