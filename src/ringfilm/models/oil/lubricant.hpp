#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/models/oil/viscosity_laws.hpp"

/// Viscosity and density of oils (docs/theory/oil.md).
namespace ringfilm::models {

struct OilFit;

/// Density and viscosity with their slopes in pressure, one value per point; all spans of one length.
struct OilProperties {
  std::span<double> rho;      ///< [kg/m3]
  std::span<double> drho_dp;  ///< [kg/(m3 Pa)]
  std::span<double> eta;      ///< [Pa s]
  std::span<double> deta_dp;  ///< [Pa s/Pa]
};

/// A law of density and viscosity of pressure, at one temperature: what the film solver asks for.
/// Immutable; may be used from several threads.
class OilAtTemperature {
 public:
  virtual ~OilAtTemperature() = default;

  /// Properties at absolute pressures p [Pa].
  virtual void properties(std::span<const double> p, OilProperties out) const = 0;

  /// Polynomials that may replace the laws within their range of pressure; nullptr where there are none.
  virtual const OilFit* fit() const { return nullptr; }

  double density(double p) const;    ///< [kg/m3]
  double viscosity(double p) const;  ///< [Pa s]
};

/// Law of density against temperature.
enum class DensityTemperatureLaw {
  kTable,              ///< linear through the points and beyond
  kThermalExpansivity  ///< by the expansivity gamma
};

/// Density at atmospheric pressure against temperature.
struct DensityLaw {
  std::vector<double> temperature;                            ///< [K], increasing, one or more
  std::vector<double> value;                                  ///< [kg/m3]
  DensityTemperatureLaw law = DensityTemperatureLaw::kTable;  ///< linear through the points, or by the expansivity
  double thermal_expansivity = 0;                             ///< gamma [1/K]
  double reference_temperature = 0;                           ///< theta_0 [K]

  /// Linear between and beyond the points, or rho(theta_0) [1 - gamma (T - theta_0)]; eq-density-temperature [kg/m3].
  double density(double T) const;
  bool extrapolates(double T) const;  ///< does T [K] lie outside the points?
};

/// Kinematic viscosity against temperature after ASTM D341 (Walther) through two points (least squares through more):
/// log10 log10(nu + 0.7) = A - B log10 T, nu in mm2/s, T in K; eq-walther.
struct Walther {
  double A;  ///< [-]
  double B;  ///< fall with temperature, above zero [-]

  /// Fits temperature [K] and as many kinematic viscosities [m2/s]. Throws InputError for fewer than two temperatures,
  /// one where no oil flows, a viscosity not above 0.3 mm2/s, where the law ends, and a fit that does not fall.
  static Walther fit(std::span<const double> temperature, std::span<const double> kinematic_viscosity);

  double kinematic_viscosity(double T) const;  ///< [m2/s]
};

/// Pressure rise of density, eq-density-pressure: 1 + a (p - p_r)/(1 + b (p - p_r)); a = b = 0 is incompressible.
struct DowsonHigginson {
  double a = 6.0e-10;                             ///< [1/Pa]
  double b = 1.7e-9;                              ///< [1/Pa]
  double reference_pressure = base::kAtmosphere;  ///< p_r, at which the density is known [Pa]
};

/// Houpert's temperature term, eq-houpert: viscosity at T and p = 0 from eta_0 at theta_0 [Pa s].
double houpert_viscosity(double eta_0, double theta_0, double beta_0, double T);

/// Law of viscosity against temperature.
enum class ViscosityTemperatureLaw {
  kWalther,  ///< ASTM D341 through the points
  kHoupert   ///< Houpert's term
};

/// An oil as its laws describe it, at all temperatures.
struct OilLaws {
  std::vector<double> viscosity_temperature;  ///< [K]
  std::vector<double> kinematic_viscosity;    ///< [m2/s], as many
  DensityLaw density;                         ///< at atmospheric pressure
  /// Walther through the values above, or Houpert's term from theta_0 on.
  ViscosityTemperatureLaw viscosity_temperature_law = ViscosityTemperatureLaw::kWalther;
  ViscosityPressureLaw viscosity_pressure_law = ViscosityPressureLaw::kRoelands;  ///< takes `parameters`
  LawParameters parameters = usual_law_parameters();  ///< parameters of the laws of viscosity against pressure [SI]
  double beta_0 = 0;                                  ///< temperature-viscosity coefficient, Houpert [1/K]
  double theta_0 = 0;                                 ///< reference temperature, Houpert [K]
  std::optional<DowsonHigginson> compression;         ///< absent: density does not depend on pressure
};

/// What the laws give at one temperature and atmospheric pressure.
struct OilState {
  double eta_T;  ///< viscosity [Pa s]
  double rho_T;  ///< density [kg/m3]
  double eta_0;  ///< to which the coefficients of the laws of pressure belong [Pa s]
};

/// Walther: eta_T = eta_0 = nu(T) rho(T). Houpert: eta_0 = nu(theta_0) rho(theta_0) with nu after Walther or the one
/// value stated there, and eta_T after Houpert. Throws InputError where a law has no value at T [K].
OilState oil_state(const OilLaws& laws, double T);

/// Closed-form oil at one temperature.
/// @param eta_T [Pa s] and rho_T [kg/m3] at atmospheric pressure
/// @param Z Roelands' index [-]; 0 switches the pressure dependence of eta off
std::shared_ptr<const OilAtTemperature> closed_form_oil(double eta_T, double rho_T, double Z, DowsonHigginson law);

/// Closed-form oil at one temperature with any law of viscosity. Throws InputError where the law has no value for the
/// oil.
std::shared_ptr<const OilAtTemperature> closed_form_oil(const ViscosityLaw& law, const LawInputs& oil, double rho_T,
                                                        DowsonHigginson compression);

/// Closed-form oil at the temperature T [K] from its laws.
std::shared_ptr<const OilAtTemperature> closed_form_oil(const OilLaws& laws, double T);

/// Oil from a measured table, already interpolated to one temperature: monotone cubic in pressure (ln eta, rho),
/// held constant in slope beyond its ends.
/// @param pressure [Pa] absolute, increasing, at least two
std::shared_ptr<const OilAtTemperature> tabulated_oil(std::vector<double> pressure, std::vector<double> viscosity,
                                                      std::vector<double> density);

/// Measured viscosity and density on a grid; index [i_temperature * n_pressure + i_pressure].
struct OilTable {
  std::vector<double> temperature;  ///< [K], increasing
  std::vector<double> pressure;     ///< [Pa] absolute, increasing, at least two
  std::vector<double> viscosity;    ///< [Pa s]
  std::vector<double> density;      ///< [kg/m3]
};

/// Oil of a table at T [K]. Between the temperatures, at each pressure, nu = eta/rho follows Walther's law and density
/// is linear in T. Throws InputError for a T outside the table, and between temperatures for nu of 0.3 mm2/s or less.
std::shared_ptr<const OilAtTemperature> tabulated_oil(const OilTable& table, double T);

}  // namespace ringfilm::models
