#include "ringfilm/models/lubricant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/base/table.hpp"

namespace ringfilm::models {
namespace {

constexpr double kRoelandsPressure = 1.98e8;  // [Pa]
constexpr double kRoelandsOffset = 9.67;      // -ln of the viscosity, 6.3e-5 Pa s, at which Roelands' law starts
constexpr double kHoupertPole = 138;          // [K]
constexpr double kMm2PerSecond = 1e-6;        // [m2/s]
constexpr double kWaltherOffset = 0.7;        // [mm2/s]

std::string in_degC(double T) { return number_text(T - 273.15) + " degC"; }

double walther_ordinate(double nu) { return std::log10(std::log10(nu / kMm2PerSecond + kWaltherOffset)); }

/// ln eta + 9.67, by which Roelands' and Houpert's laws divide.
double roelands_logarithm(double eta) {
  const double logarithm = std::log(eta) + kRoelandsOffset;
  if (!(logarithm > 0)) {
    throw InputError(
        "an oil viscosity of " + number_text(eta * 1e3) + " mPa.s is below the 0.0632 mPa.s of Roelands' law",
        "check lubricant.kinematic_viscosity and the oil temperature, or choose "
        "lubricant.viscosity_pressure = \"none\"");
  }
  return logarithm;
}

/// Is theta_0 the one temperature at which the kinematic viscosity is known?
bool stated_at(const OilLaws& laws, double theta_0) {
  constexpr double kRounding = 1e-6;  // [K], what converting units may add
  return laws.viscosity_temperature.size() == 1 && std::abs(laws.viscosity_temperature[0] - theta_0) <= kRounding;
}

/// Roelands' viscosity at one temperature: eta = eta_T exp(L (q - 1)) with q = (1 + p/1.98e8)^Z and L = ln eta_T
/// + 9.67.
class RoelandsCurve {
 public:
  RoelandsCurve(double eta_T, double Z) : eta_T_(eta_T), Z_(Z), logarithm_(roelands_logarithm(eta_T)) {
    // Power series in x = (p - kCentre)/kScale, in which 1 + p/1.98e8 grows like 1 + x: first of L q by the binomial
    // series, then of its exponential, n e_n = sum over k of k a_k e_(n-k).
    std::array<double, kTerms> a{};
    a[0] = logarithm_ * std::pow(kScale / kRoelandsPressure, Z);
    for (int k = 1; k < kTerms; ++k) a[k] = a[k - 1] * (Z - (k - 1)) / k;
    series_[0] = eta_T * std::exp(a[0] - logarithm_);
    for (int n = 1; n < kTerms; ++n) {
      for (int k = 1; k <= n; ++k) series_[n] += k * a[k] * series_[n - k] / n;
    }
    // Where the last term is a few roundings of the sum, what is left out is less.
    constexpr double kLastTerm = 1e-15;
    const double converged =
        std::pow(kLastTerm * series_[0] / std::abs(series_[kTerms - 1]), 1.0 / (kTerms - 1)) * kScale;
    half_width_ = std::min(kCentre, converged);
  }

  void viscosity(std::span<const double> p, std::span<double> eta, std::span<double> deta_dp) const {
    for (std::size_t i = 0; i < p.size(); ++i) {  // without branches, so that it runs in vector registers
      const double x = (p[i] - kCentre) * kPerScale;
      double value = series_[kTerms - 1], slope = 0;
      for (int k = kTerms - 2; k >= 0; --k) {
        slope = slope * x + value;
        value = value * x + series_[k];
      }
      eta[i] = value;
      deta_dp[i] = slope * kPerScale;
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (std::abs(p[i] - kCentre) <= half_width_) continue;
      const double q = std::pow(1 + p[i] / kRoelandsPressure, Z_);
      eta[i] = eta_T_ * std::exp(logarithm_ * (q - 1));
      deta_dp[i] = eta[i] * logarithm_ * Z_ * q / (kRoelandsPressure + p[i]);
    }
  }

 private:
  // 0 to 30 MPa hold nearly every film under a ring; there |x| <= 0.07, and 13 terms leave rounding for an engine oil.
  // Other pressures take the law itself, and so do the ends of that range for a much stiffer oil.
  static constexpr double kCentre = 1.5e7;                       // [Pa]
  static constexpr double kScale = kRoelandsPressure + kCentre;  // [Pa]
  static constexpr double kPerScale = 1 / kScale;
  static constexpr int kTerms = 13;

  double eta_T_, Z_, logarithm_;
  std::array<double, kTerms> series_{};  // [Pa s]
  double half_width_;                    // of the range of pressures around kCentre that the series serves [Pa]
};

class ClosedFormOil final : public OilAtTemperature {
 public:
  ClosedFormOil(double eta_T, double rho_T, double Z, DowsonHigginson law) : eta_T_(eta_T), rho_T_(rho_T), law_(law) {
    if (Z != 0) roelands_.emplace(eta_T, Z);
  }
  ClosedFormOil(double eta_T, double rho_T, Barus barus, DowsonHigginson law)
      : eta_T_(eta_T), rho_T_(rho_T), law_(law), barus_(barus) {}

  void properties(std::span<const double> p, OilProperties out) const override {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double over = p[i] - law_.reference_pressure;
      const double stiffening = 1 / (1 + law_.b * over);
      out.rho[i] = rho_T_ * (1 + law_.a * over * stiffening);
      out.drho_dp[i] = rho_T_ * law_.a * stiffening * stiffening;
    }
    if (roelands_) {
      roelands_->viscosity(p, out.eta, out.deta_dp);
    } else if (barus_) {
      for (std::size_t i = 0; i < p.size(); ++i) {
        out.eta[i] = eta_T_ * std::exp(barus_->alpha * p[i]);
        out.deta_dp[i] = barus_->alpha * out.eta[i];
      }
    } else {
      std::fill(out.eta.begin(), out.eta.end(), eta_T_);
      std::fill(out.deta_dp.begin(), out.deta_dp.end(), 0.0);
    }
  }

 private:
  double eta_T_, rho_T_;
  DowsonHigginson law_;
  std::optional<RoelandsCurve> roelands_;
  std::optional<Barus> barus_;
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
  double x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double nu = kinematic_viscosity[i];
    if (!(nu > (1 - kWaltherOffset) * kMm2PerSecond)) {
      throw InputError("lubricant.kinematic_viscosity = " + number_text(nu / kMm2PerSecond) + " mm2/s at " +
                           in_degC(temperature[i]) + " is not above 0.3 mm2/s, where Walther's law begins",
                       "give values such as \"60 mm2/s\" at 40 degC and \"9.6 mm2/s\" at 100 degC");
    }
    x_mean += std::log10(temperature[i]) / static_cast<double>(n);
    y_mean += walther_ordinate(nu) / static_cast<double>(n);
  }
  double x_x = 0, x_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::log10(temperature[i]) - x_mean;
    x_x += x * x;
    x_y += x * (walther_ordinate(kinematic_viscosity[i]) - y_mean);
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

Roelands Roelands::from_coefficient(double alpha_0, double eta_0) {
  return {alpha_0 / (5.1e-9 * roelands_logarithm(eta_0))};
}

double houpert_viscosity(double eta_0, double theta_0, double beta_0, double T) {
  if (!(T > kHoupertPole && theta_0 > kHoupertPole)) {
    throw InputError(
        "a temperature of " + in_degC(std::min(T, theta_0)) + " is not above the -135.15 degC of Houpert's law",
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
    throw InputError("the oil's density at " + in_degC(at) + " comes out as " + number_text(rho) + " kg/m3",
                     "check lubricant.density, lubricant.thermal_expansivity and the oil temperature");
  };
  const auto after_walther = [&](double at) {
    const auto walther = Walther::fit(laws.viscosity_temperature, laws.kinematic_viscosity);
    return walther.kinematic_viscosity(at) * density(at);
  };

  OilState state{.eta_T = 0, .rho_T = density(T), .Z = 0};
  double eta_0 = 0;
  switch (laws.viscosity_temperature_law) {
    case ViscosityTemperatureLaw::kWalther:
      eta_0 = state.eta_T = after_walther(T);
      break;
    case ViscosityTemperatureLaw::kHoupert:
      eta_0 = stated_at(laws, laws.theta_0) ? laws.kinematic_viscosity.front() * density(laws.theta_0)
                                            : after_walther(laws.theta_0);
      state.eta_T = houpert_viscosity(eta_0, laws.theta_0, laws.beta_0, T);
      break;
  }
  if (!(state.eta_T > 0)) {
    throw InputError("the oil's viscosity at " + in_degC(T) + " comes out as " + number_text(state.eta_T) + " Pa.s",
                     "check operating.oil_temperature against the temperatures of lubricant.kinematic_viscosity");
  }
  if (laws.viscosity_pressure_law == ViscosityPressureLaw::kRoelands) {
    state.Z = Roelands::from_coefficient(laws.alpha_0, eta_0).Z;
  }
  return state;
}

std::shared_ptr<const OilAtTemperature> closed_form_oil(double eta_T, double rho_T, double Z, DowsonHigginson law) {
  return std::make_shared<ClosedFormOil>(eta_T, rho_T, Z, law);
}

std::shared_ptr<const OilAtTemperature> closed_form_oil(double eta_T, double rho_T, Barus barus, DowsonHigginson law) {
  return std::make_shared<ClosedFormOil>(eta_T, rho_T, barus, law);
}

std::shared_ptr<const OilAtTemperature> closed_form_oil(const OilLaws& laws, double T) {
  const auto [eta_T, rho_T, Z] = oil_state(laws, T);
  const DowsonHigginson compression = laws.compression.value_or(DowsonHigginson{.a = 0, .b = 0});
  if (laws.viscosity_pressure_law == ViscosityPressureLaw::kBarus) {
    return closed_form_oil(eta_T, rho_T, Barus{laws.alpha_0}, compression);
  }
  return closed_form_oil(eta_T, rho_T, Z, compression);
}

}  // namespace ringfilm::models
