#include "ringfilm/models/oil/oil_over_temperature.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace ringfilm::models {
namespace {

/// Nodes in temperature that are tried; the oils of data/lubricants are certified with the first over 100 K, with the
/// second over all temperatures at which they flow.
constexpr int kFewNodes = 12, kManyNodes = 24;

/// Applies `change` to all coefficients of K and of its slope.
template <class Change>
void for_fluidity(OilFit& fit, const Change& change) {
  for (double& c : fit.K) c = change(c);
  for (double& c : fit.dK_dp) c = change(c);
}

/// sum += weight * fit, coefficient by coefficient.
template <std::size_t n>
void add(std::array<double, n>& sum, double weight, const std::array<double, n>& one) {
  for (std::size_t i = 0; i < n; ++i) sum[i] += weight * one[i];
}

}  // namespace

OilOverTemperature::OilOverTemperature(Laws laws, double low, double high)
    : laws_(std::move(laws)), centre_(0.5 * (low + high)), half_width_(0.5 * (high - low)) {
  if (half_width_ == 0) only_ = laws_(low);
}

bool OilOverTemperature::fit(double highest_pressure) {
  if (only_) {
    only_ = fitted_oil(std::move(only_), 0, highest_pressure);
    return only_->fit() != nullptr;
  }
  return fit_at_nodes(kFewNodes, highest_pressure) || fit_at_nodes(kManyNodes, highest_pressure);
}

bool OilOverTemperature::fit_at_nodes(int n, double highest_pressure) {
  nodes_ = {};
  for (int k = 0; k < n; ++k) {
    const double angle = std::numbers::pi * (k + 0.5) / n;
    const double t = std::cos(angle);
    auto fit = fit_oil(*laws_(centre_ + half_width_ * t), 0, highest_pressure);
    if (!fit) return nodes_ = {}, false;
    nodes_.place.push_back(t);
    nodes_.weight.push_back((k % 2 == 0 ? 1 : -1) * std::sin(angle));
    nodes_.ln_fluidity.push_back(std::log(fit->K[0]));
    for_fluidity(*fit, [K_0 = fit->K[0]](double c) { return c / K_0; });
    nodes_.fit.push_back(*fit);
  }
  // Four times as many, both ends among them, as over pressure.
  const int n_checks = 4 * n;
  for (int i = 0; i < n_checks; ++i) {
    const double T = centre_ + half_width_ * std::cos(std::numbers::pi * i / (n_checks - 1));
    const FitErrors errors = fit_errors(interpolated(T), *laws_(T));
    if (!(errors.value <= kFitError && errors.slope <= kFitSlopeError)) return nodes_ = {}, false;
  }
  return true;
}

OilFit OilOverTemperature::interpolated(double T) const {
  const double t = (T - centre_) / half_width_;
  OilFit sum = nodes_.fit.front();
  for_fluidity(sum, [](double) { return 0.0; });
  sum.rho = {};
  sum.drho_dp = {};
  double total = 0, ln_fluidity = 0;
  for (std::size_t k = 0; k < nodes_.place.size(); ++k) {
    const double distance = t - nodes_.place[k];
    if (distance == 0) {
      sum = nodes_.fit[k];
      total = 1;
      ln_fluidity = nodes_.ln_fluidity[k];
      break;
    }
    const double weight = nodes_.weight[k] / distance;
    total += weight;
    ln_fluidity += weight * nodes_.ln_fluidity[k];
    add(sum.K, weight, nodes_.fit[k].K);
    add(sum.dK_dp, weight, nodes_.fit[k].dK_dp);
    add(sum.rho, weight, nodes_.fit[k].rho);
    add(sum.drho_dp, weight, nodes_.fit[k].drho_dp);
  }
  const double K_0 = std::exp(ln_fluidity / total);
  for_fluidity(sum, [&](double c) { return c * K_0 / total; });
  for (double& c : sum.rho) c /= total;
  for (double& c : sum.drho_dp) c /= total;
  return sum;
}

double OilOverTemperature::viscosity(double T) const {
  return (only_ ? only_ : laws_(T))->viscosity(base::kAtmosphere);
}

std::shared_ptr<const OilAtTemperature> OilOverTemperature::at(double T) const {
  if (only_) return only_;
  return nodes_.fit.empty() ? laws_(T) : with_fit(laws_(T), interpolated(T));
}

}  // namespace ringfilm::models
