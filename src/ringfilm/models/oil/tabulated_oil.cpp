#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"
#include "ringfilm/models/oil/walther.hpp"

namespace ringfilm::models {
namespace {

std::vector<double> logarithms(std::vector<double> values) {
  for (double& value : values) value = std::log(value);
  return values;
}

class TabulatedOil final : public OilAtTemperature {
 public:
  TabulatedOil(std::vector<double> pressure, std::vector<double> viscosity, std::vector<double> density)
      : ln_eta_(pressure, logarithms(std::move(viscosity))), rho_(std::move(pressure), std::move(density)) {}

  void properties(std::span<const double> p, OilProperties out) const override {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto rho = rho_.at(p[i]);
      const auto ln_eta = ln_eta_.at(p[i]);
      out.rho[i] = rho.value;
      out.drho_dp[i] = rho.slope;
      out.eta[i] = std::exp(ln_eta.value);
      out.deta_dp[i] = out.eta[i] * ln_eta.slope;
    }
  }

 private:
  MonotoneCubic ln_eta_, rho_;
};

/// Walther's ordinate, straight in ln T, of a kinematic viscosity.
double walther_ordinate(double nu) {
  const double argument = nu / kMm2PerSecond + kWaltherOffset;
  if (!(argument > 1)) {
    throw InputError(
        "the oil table has a viscosity over density that is not above 0.3 mm2/s, where Walther's law begins",
        "check the units of viscosity and density in the file of lubricant.table");
  }
  return std::log(std::log(argument));
}

double kinematic_viscosity(double ordinate) { return kMm2PerSecond * (std::exp(std::exp(ordinate)) - kWaltherOffset); }

/// Linear between two numbers; exact at both ends.
double between(double low, double high, double share) { return share == 1 ? high : low + share * (high - low); }

}  // namespace

std::shared_ptr<const OilAtTemperature> tabulated_oil(std::vector<double> pressure, std::vector<double> viscosity,
                                                      std::vector<double> density) {
  const auto wrong = [](double value) { return !(value > 0) || !std::isfinite(value); };
  if (pressure.size() < 2 || viscosity.size() != pressure.size() || density.size() != pressure.size() ||
      std::any_of(viscosity.begin(), viscosity.end(), wrong) || std::any_of(density.begin(), density.end(), wrong) ||
      std::adjacent_find(pressure.begin(), pressure.end(), std::greater_equal<>()) != pressure.end()) {
    throw InputError("the oil table needs two increasing pressures or more, each with a positive viscosity and density",
                     "check the file of lubricant.table");
  }
  return std::make_shared<TabulatedOil>(std::move(pressure), std::move(viscosity), std::move(density));
}

std::shared_ptr<const OilAtTemperature> tabulated_oil(const OilTable& table, double T) {
  const auto& temperature = table.temperature;
  constexpr double kRounding = 1e-6;  // [K], what converting units may add
  const std::size_t n = table.pressure.size(), n_values = temperature.size() * n;
  if (temperature.empty() || table.viscosity.size() != n_values || table.density.size() != n_values ||
      std::adjacent_find(temperature.begin(), temperature.end(), std::greater_equal<>()) != temperature.end()) {
    throw InputError("the oil table is not a full grid of increasing temperatures and pressures",
                     "check the file of lubricant.table");
  }
  if (!(T >= temperature.front() - kRounding && T <= temperature.back() + kRounding)) {
    throw InputError("operating.oil_temperature = " + text_in(T, kCelsius) + " lies outside the oil table, " +
                         text_in(temperature.front(), kCelsius) + " to " + text_in(temperature.back(), kCelsius),
                     "choose a temperature inside, or add measurements to the file of lubricant.table");
  }
  T = std::clamp(T, temperature.front(), temperature.back());
  const std::size_t high = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lower_bound(temperature.begin(), temperature.end(), T) - temperature.begin()));
  const std::size_t low = high - 1;
  std::vector<double> viscosity(table.viscosity.begin() + low * n, table.viscosity.begin() + (low + 1) * n);
  std::vector<double> density(table.density.begin() + low * n, table.density.begin() + (low + 1) * n);
  if (T > temperature[low]) {
    const double share = (T - temperature[low]) / (temperature[high] - temperature[low]);
    const double share_of_ln = std::log(T / temperature[low]) / std::log(temperature[high] / temperature[low]);
    for (std::size_t i = 0; i < n; ++i) {
      const double rho_high = table.density[high * n + i], nu_high = table.viscosity[high * n + i] / rho_high;
      const double ordinate =
          between(walther_ordinate(viscosity[i] / density[i]), walther_ordinate(nu_high), share_of_ln);
      density[i] = between(density[i], rho_high, share);
      viscosity[i] = kinematic_viscosity(ordinate) * density[i];
    }
  }
  return tabulated_oil(table.pressure, std::move(viscosity), std::move(density));
}

}  // namespace ringfilm::models
