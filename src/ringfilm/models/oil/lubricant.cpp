#include "ringfilm/models/oil/lubricant.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"
#include "ringfilm/models/oil/roelands.hpp"
#include "ringfilm/models/oil/walther.hpp"

namespace ringfilm::models {
namespace {

constexpr double kHoupertPole = 138;  // [K]

double decadic_ordinate(double nu) { return std::log10(std::log10(nu / kMm2PerSecond + kWaltherOffset)); }

/// Is theta_0 the one temperature at which the kinematic viscosity is known?
bool stated_at(const OilLaws& laws, double theta_0) {
  constexpr double kRounding = 1e-6;  // [K], what converting units may add
  return laws.viscosity_temperature.size() == 1 && std::abs(laws.viscosity_temperature[0] - theta_0) <= kRounding;
}

class ClosedFormOil final : public OilAtTemperature {
 public:
  ClosedFormOil(std::unique_ptr<const ViscosityCurve> curve, double rho_T, DowsonHigginson law)
      : curve_(std::move(curve)), rho_T_(rho_T), law_(law) {}

  void properties(std::span<const double> p, OilProperties out) const override {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double over = p[i] - law_.reference_pressure;
      const double stiffening = 1 / (1 + law_.b * over);
      out.rho[i] = rho_T_ * (1 + law_.a * over * stiffening);
      out.drho_dp[i] = rho_T_ * law_.a * stiffening * stiffening;
    }
    curve_->viscosity(p, out.eta, out.deta_dp);
  }

 private:
  std::unique_ptr<const ViscosityCurve> curve_;
  double rho_T_;
  DowsonHigginson law_;
};

}  // namespace

double OilAtTemperature::density(double p) const {
  double rho, drho_dp, eta, deta_dp;
  properties({&p, 1}, {{&rho, 1}, {&drho_dp, 1}, {&eta, 1}, {&deta_dp, 1}});
  return rho;
}

double OilAtTemperature::viscosity(double p) const {
  double rho, drho_dp, eta, deta_dp;
  properties({&p, 1}, {{&rho, 1}, {&drho_dp, 1}, {&eta, 1}, {&deta_dp, 1}});
  return eta;
}

double DensityLaw::density(double T) const {
  if (law == DensityTemperatureLaw::kTable) return interpolate_linear(temperature, value, T);
  const double rho_0 = interpolate_linear(temperature, value, reference_temperature);
  return rho_0 * (1 - thermal_expansivity * (T - reference_temperature));
}

bool DensityLaw::extrapolates(double T) const {
  const double asked = law == DensityTemperatureLaw::kThermalExpansivity ? reference_temperature : T;
  return asked < temperature.front() || asked > temperature.back();
}

Walther Walther::fit(std::span<const double> temperature, std::span<const double> kinematic_viscosity) {
  const std::size_t n = temperature.size();
  if (kinematic_viscosity.size() != n) {
    throw InputError("there are " + std::to_string(n) + " temperatures and " +
                         std::to_string(kinematic_viscosity.size()) + " kinematic viscosities",
                     "give one viscosity for each temperature");
  }
  for (const double T : temperature) check_oil_temperature(T);
  double x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double nu = kinematic_viscosity[i];
    if (!(nu > (1 - kWaltherOffset) * kMm2PerSecond)) {
      throw InputError("lubricant.kinematic_viscosity = " + number_text(nu / kMm2PerSecond) + " mm2/s at " +
                           text_in(temperature[i], kCelsius) + " is not above 0.3 mm2/s, where Walther's law begins",
                       "give values such as \"60 mm2/s\" at 40 degC and \"9.6 mm2/s\" at 100 degC");
    }
    x_mean += std::log10(temperature[i]) / static_cast<double>(n);
    y_mean += decadic_ordinate(nu) / static_cast<double>(n);
  }
  double x_x = 0, x_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::log10(temperature[i]) - x_mean;
    x_x += x * x;
    x_y += x * (decadic_ordinate(kinematic_viscosity[i]) - y_mean);
  }
  if (n < 2 || !(x_x > 0)) {
    throw InputError("lubricant.kinematic_viscosity has values at fewer than two temperatures",
                     "give it at two temperatures, for example 40 degC and 100 degC");
  }
  if (!(x_y < 0)) {
    throw InputError("lubricant.kinematic_viscosity does not fall with temperature",
                     "check which value belongs to which temperature");
  }
  const double B = -x_y / x_x;
  return {y_mean + B * x_mean, B};
}

double Walther::kinematic_viscosity(double T) const {
  return (std::pow(10, std::pow(10, A - B * std::log10(T))) - kWaltherOffset) * kMm2PerSecond;
}

double houpert_viscosity(double eta_0, double theta_0, double beta_0, double T) {
  if (!(T > kHoupertPole && theta_0 > kHoupertPole)) {
    throw InputError("a temperature of " + text_in(std::min(T, theta_0), kCelsius) +
                         " is not above the -135.15 degC of Houpert's law",
                     "check operating.oil_temperature and lubricant.reference_temperature");
  }
  const double logarithm = roelands_logarithm(eta_0);
  const double S_0 = beta_0 * (theta_0 - kHoupertPole) / logarithm;
  const double fall = std::pow((T - kHoupertPole) / (theta_0 - kHoupertPole), -S_0);
  return eta_0 * std::exp(logarithm * (fall - 1));
}

OilState oil_state(const OilLaws& laws, double T) {
  const auto density = [&](double at) {
    const double rho = laws.density.density(at);
    if (rho > 0) return rho;
    throw InputError("the oil's density at " + text_in(at, kCelsius) + " comes out as " + number_text(rho) + " kg/m3",
                     "check lubricant.density, lubricant.thermal_expansivity and the oil temperature");
  };
  const auto after_walther = [&](double at) {
    const auto walther = Walther::fit(laws.viscosity_temperature, laws.kinematic_viscosity);
    return walther.kinematic_viscosity(at) * density(at);
  };

  OilState state{.eta_T = 0, .rho_T = density(T), .eta_0 = 0};
  switch (laws.viscosity_temperature_law) {
    case ViscosityTemperatureLaw::kWalther:
      state.eta_0 = state.eta_T = after_walther(T);
      break;
    case ViscosityTemperatureLaw::kHoupert:
      state.eta_0 = stated_at(laws, laws.theta_0) ? laws.kinematic_viscosity.front() * density(laws.theta_0)
                                                  : after_walther(laws.theta_0);
      state.eta_T = houpert_viscosity(state.eta_0, laws.theta_0, laws.beta_0, T);
      break;
  }
  if (!(state.eta_T > 0)) {
    throw InputError(
        "the oil's viscosity at " + text_in(T, kCelsius) + " comes out as " + number_text(state.eta_T) + " Pa.s",
        "check operating.oil_temperature against the temperatures of lubricant.kinematic_viscosity");
  }
  return state;
}

std::shared_ptr<const OilAtTemperature> closed_form_oil(const ViscosityLaw& law, const LawInputs& oil, double rho_T,
                                                        DowsonHigginson compression) {
  return std::make_shared<ClosedFormOil>(law.curve(oil), rho_T, compression);
}

std::shared_ptr<const OilAtTemperature> closed_form_oil(double eta_T, double rho_T, double Z, DowsonHigginson law) {
  if (Z != 0) return std::make_shared<ClosedFormOil>(roelands_curve(eta_T, Z), rho_T, law);
  const LawParameters no_parameters;
  return closed_form_oil(viscosity_law(ViscosityPressureLaw::kNone), {eta_T, eta_T, no_parameters}, rho_T, law);
}

std::shared_ptr<const OilAtTemperature> closed_form_oil(const OilLaws& laws, double T) {
  const auto [eta_T, rho_T, eta_0] = oil_state(laws, T);
  return closed_form_oil(viscosity_law(laws.viscosity_pressure_law), {eta_T, eta_0, laws.parameters}, rho_T,
                         laws.compression.value_or(DowsonHigginson{.a = 0, .b = 0}));
}

}  // namespace ringfilm::models
