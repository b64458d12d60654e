#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/shared.hpp"
#include "ringfilm/case/case_choices.hpp"
#include "ringfilm/models/oil/evaporation.hpp"
#include "ringfilm/models/oil/lubricant.hpp"

namespace ringfilm::cycle {

/// A value of an oil at one temperature.
struct TemperatureValue {
  double temperature = 0;  ///< [K]
  double value = 0;        ///< [SI unit of the quantity]
};

/// The keys under `lubricant`, with the oil of the file that they name.
struct Lubricant {
  std::optional<std::string> file;                    ///< where the keys of this table were read from
  std::optional<std::string> grade;                   ///< or the grade of the shipped oil that has them
  std::string name;                                   ///< for people; empty if the case states the values itself
  std::vector<TemperatureValue> kinematic_viscosity;  ///< [m2/s]
  std::optional<double> viscosity_index;              ///< index of ASTM D2270, with one viscosity at 40 or 100 degC [-]
  std::vector<TemperatureValue> density;              ///< [kg/m3] at atmospheric pressure
  std::optional<double> constant_density;             ///< instead of `density`: the same at all temperatures [kg/m3]
  std::optional<std::string> table_file;              ///< viscosity and density against T and p, instead of all laws
  base::Shared<models::OilTable> table;               ///< table in table_file; empty without one
  double temperature_viscosity_coefficient = 0.04;    ///< beta_0 [1/K], houpert
  double reference_temperature = 313.15;              ///< theta_0 [K], houpert and thermal-expansivity
  double thermal_expansivity = 7.5e-4;                ///< gamma [1/K]
  /// Law of viscosity against temperature: ASTM D341 through the points, or Houpert's term.
  ViscosityTemperature viscosity_temperature = ViscosityTemperature::kWalther;
  ViscosityPressure viscosity_pressure = ViscosityPressure::kRoelands;    ///< law of viscosity against pressure
  models::LawParameters law_parameters = models::usual_law_parameters();  ///< parameters of viscosity_pressure [SI]
  DensityTemperature density_temperature = DensityTemperature::kTable;    ///< linear through the points, or by gamma
  Compressibility compressibility = Compressibility::kDowsonHigginson;    ///< law of density against pressure
  double dh_a = models::DowsonHigginson{}.a;  ///< a of the density rho_0 [1 + a p/(1 + b p)] [1/Pa]
  double dh_b = models::DowsonHigginson{}.b;  ///< b of the same law [1/Pa]
  double thermal_conductivity = 0.14;         ///< thermal conductivity of a mineral oil, k [W/(m K)]
  double specific_heat = 2100;                ///< specific heat of a mineral oil, c_p [J/(kg K)]
  double surface_tension = 0.03;              ///< surface tension of a mineral oil against gas [N/m]
  double viscosity = 0;                       ///< viscosity of the oil of a pad, at the zero of its pressures [Pa s]
  ShearThinning shear_thinning = ShearThinning::kNone;    ///< law of viscosity against the shear rate
  double second_newtonian_ratio = 0.7;                    ///< R: viscosity at the highest shear rates over that at none
  std::optional<double> critical_shear_rate;              ///< g_c, at the temperature below [1/s]
  std::optional<double> critical_shear_rate_temperature;  ///< [K]
  std::optional<double> shear_exponent;                   ///< m or n; absent: models::usual_exponent [-]
  /// Viscosity at 150 degC and 1e6 1/s, which determines g_c where the case does not state it [Pa s].
  std::optional<double> hths_viscosity;
  // at most one of the two; nothing evaporates without them
  std::vector<models::OilFraction> distillation;  ///< fractions by boiling point, rising
  std::optional<double> noack;                    ///< loss of mass in the Noack test (ASTM D5800) [-]
  double fuel = 0;                                ///< fuel dissolved in the oil, share of the mass [-]
  double water = 0;                               ///< water dispersed in the oil, share of the mass [-]
  /// Kinematic viscosity of that fuel: diesel fuel, typical, assumed [m2/s]
  std::vector<TemperatureValue> fuel_viscosity = {{313.15, 2.7e-6}, {373.15, 1.1e-6}};

  bool is_diluted() const { return fuel > 0 || water > 0; }  ///< does it hold fuel or water?
  /// Is the oil any other than a Newtonian one?
  bool thins() const { return shear_thinning != ShearThinning::kNone && second_newtonian_ratio < 1; }
  /// Is there what its evaporation follows from?
  bool evaporates() const { return noack || !distillation.empty(); }
  /// The viscosities as stated, with that which the index adds at 100 or 40 degC where it can [m2/s].
  std::vector<TemperatureValue> viscosities() const;
  /// The fractions as stated, or those that belong to the Noack loss.
  std::vector<models::OilFraction> fractions() const {
    return distillation.empty() && noack ? models::distillation_of_noack(*noack) : distillation;
  }
};

}  // namespace ringfilm::cycle
