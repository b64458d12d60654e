#include "ringfilm/cycle/setup/oil_setup.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/models/oil/dilution.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"
#include "ringfilm/models/oil/oil_of_functions.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"

namespace ringfilm::cycle {
namespace {

std::vector<double> temperatures(const std::vector<TemperatureValue>& points) {
  std::vector<double> out;
  for (const auto& point : points) out.push_back(point.temperature);
  return out;
}

std::vector<double> values(const std::vector<TemperatureValue>& points) {
  std::vector<double> out;
  for (const auto& point : points) out.push_back(point.value);
  return out;
}

/// Viscosity of the fuel, where it is stated the number itself [m2/s].
double fuel_viscosity(const Lubricant& oil, const models::Walther& law, double T) {
  for (const TemperatureValue& point : oil.fuel_viscosity) {
    if (point.temperature == T) return point.value;
  }
  return law.kinematic_viscosity(T);
}

/// Water in a film at ambient pressure boils from here on [K].
constexpr double kWaterBoils = 373.15;

/// Mixes fuel and water into the oil at the temperatures of its viscosities. Its density remains that of the oil.
void dilute(const Lubricant& oil, models::OilLaws& laws) {
  const auto fuel =
      oil.fuel > 0 ? std::optional(models::Walther::fit(temperatures(oil.fuel_viscosity), values(oil.fuel_viscosity)))
                   : std::nullopt;
  for (std::size_t i = 0; i < laws.kinematic_viscosity.size(); ++i) {
    const double T = laws.viscosity_temperature[i], density = laws.density.density(T);
    double& nu = laws.kinematic_viscosity[i];
    if (fuel) nu = models::blended_viscosity(nu, fuel_viscosity(oil, *fuel, T), oil.fuel);
    if (oil.water > 0) {
      nu *= models::emulsion_ratio(models::water_volume_share(oil.water, density), models::water_viscosity(T),
                                   nu * density);
    }
  }
}

models::OilLaws oil_laws(const Lubricant& oil) {
  if (!oil.constant_density && oil.density.empty()) {
    throw InputError("lubricant.density has no value", "state one, or values at temperatures");
  }
  models::OilLaws laws;
  const std::vector<TemperatureValue> viscosities = oil.viscosities();
  laws.viscosity_temperature = temperatures(viscosities);
  laws.kinematic_viscosity = values(viscosities);
  laws.density = {temperatures(oil.density), values(oil.density),
                  oil.density_temperature == DensityTemperature::kTable
                      ? models::DensityTemperatureLaw::kTable
                      : models::DensityTemperatureLaw::kThermalExpansivity,
                  oil.thermal_expansivity, oil.reference_temperature};
  if (oil.constant_density)
    laws.density = {{oil.reference_temperature}, {*oil.constant_density}};  // at any temperature
  laws.viscosity_temperature_law = oil.viscosity_temperature == ViscosityTemperature::kWalther
                                       ? models::ViscosityTemperatureLaw::kWalther
                                       : models::ViscosityTemperatureLaw::kHoupert;
  laws.viscosity_pressure_law = oil.viscosity_pressure;
  laws.parameters = oil.law_parameters;
  laws.beta_0 = oil.temperature_viscosity_coefficient;
  laws.theta_0 = oil.reference_temperature;
  if (oil.compressibility == Compressibility::kDowsonHigginson)
    laws.compression = models::DowsonHigginson{oil.dh_a, oil.dh_b};
  if (oil.is_diluted()) dilute(oil, laws);
  return laws;
}

/// The oil as it was filled in.
Lubricant fresh(Lubricant oil) {
  oil.fuel = oil.water = 0;
  return oil;
}

/// Viscosity of the oil that was filled in, at a temperature and atmospheric pressure [Pa s].
double fresh_viscosity(const Lubricant& oil, double T) { return models::oil_state(oil_laws(fresh(oil)), T).eta_T; }

/// A note on fuel and water in the oil and what they make of its viscosity. @param eta_T of the diluted oil [Pa s]
void add_dilution_note(const Lubricant& oil, double T, double eta_T, std::vector<Note>& notes) {
  if (!oil.is_diluted()) return;
  std::string message = "the oil holds ";
  if (oil.fuel > 0) message += formatted("%.3g %% of fuel", 100 * oil.fuel);
  if (oil.water > 0) message += (oil.fuel > 0 ? " and " : "") + formatted("%.3g %% of water", 100 * oil.water);
  message += formatted(" by mass: at %.4g", number_in(T, kCelsius)) +
             formatted(" degC its viscosity is %.3g times that of the fresh oil", eta_T / fresh_viscosity(oil, T));
  constexpr double kUsualFuel = 0.15;
  if (oil.fuel > kUsualFuel) message += "; engine oils rarely hold more than 15 % of fuel";
  if (oil.water > 0 && T > kWaterBoils) message += "; water boils at the temperature of this film";
  notes.push_back({"oil-diluted", message, 1});
}

/// Three or more viscosities that do not lie on one line of ASTM D341.
void add_off_line_note(const models::OilLaws& laws, std::vector<Note>& notes) {
  constexpr double kUsualScatter =
      0.03;  // share of the viscosity; chosen: a few times the reproducibility of ASTM D445
  const auto& T = laws.viscosity_temperature;
  if (T.size() < 3) return;
  const models::Walther line = models::Walther::fit(T, laws.kinematic_viscosity);
  double worst = 0, worst_T = 0;
  for (std::size_t i = 0; i < T.size(); ++i) {
    const double off = line.kinematic_viscosity(T[i]) / laws.kinematic_viscosity[i] - 1;
    if (std::abs(off) > std::abs(worst)) {
      worst = off;
      worst_T = T[i];
    }
  }
  if (std::abs(worst) <= kUsualScatter) return;
  notes.push_back({"viscosity-off-line",
                   "the line of ASTM D341 through the " + std::to_string(T.size()) +
                       " viscosities of lubricant.kinematic_viscosity misses that at " + celsius(worst_T) +
                       formatted(" by %+.1f %%: is one of them wrong?", 100 * worst),
                   1});
}

std::vector<Note> extrapolation_notes(const Lubricant& oil, const models::OilLaws& laws,
                                      const models::WallTemperatures::Range& range) {
  std::vector<Note> notes;
  const bool of_density = laws.density.extrapolates(range.low) || laws.density.extrapolates(range.high);
  if (!oil.constant_density && oil.density_temperature == DensityTemperature::kTable && of_density) {
    const double temperature = laws.density.extrapolates(range.low) ? range.low : range.high;
    const auto [low, high] = std::minmax_element(laws.density.temperature.begin(), laws.density.temperature.end());
    notes.push_back({"density-extrapolated",
                     "oil density is asked for at " + celsius(temperature) + ", outside its measured points (" +
                         celsius(*low) + " to " + celsius(*high) + "): the straight line through them is continued",
                     1});
  }
  const auto& measured = laws.viscosity_temperature;
  const auto [low, high] = std::minmax_element(measured.begin(), measured.end());
  if (range.low < *low || range.high > *high) {
    const double temperature = range.low < *low ? range.low : range.high;
    notes.push_back({"viscosity-extrapolated",
                     "oil viscosity is asked for at " + celsius(temperature) + ", outside its measured points (" +
                         celsius(*low) + " to " + celsius(*high) +
                         "): the temperature law is continued; a viscosity measured near it as a further point of "
                         "lubricant.kinematic_viscosity makes it certain",
                     1});
  }
  if (oil.viscosity_temperature == ViscosityTemperature::kWalther) add_off_line_note(laws, notes);
  return notes;
}

/// The oil without shear at a temperature, at atmospheric pressure [Pa s].
using ViscosityAt = std::function<double(double T)>;

/// Adds the thinning of an oil by shear. @param T_low,T_high range of temperatures in which the viscosity is known [K]
void add_thinning(const Lubricant& lubricant, const ViscosityAt& viscosity, double T_low, double T_high,
                  OilSetup& setup) {
  const auto fresh_at = [&](double at) {
    return lubricant.is_diluted() ? fresh_viscosity(lubricant, at) : viscosity(at);
  };
  const auto law = shear_thinning(lubricant);
  if (!law) return;
  const double T_hths = models::kHthsTemperature;
  const auto& stated = lubricant.critical_shear_rate;
  const double T = stated ? lubricant.critical_shear_rate_temperature.value() : T_hths;
  const auto rate_from_hths = [&] {
    return models::kHthsShearRate / law->rate(lubricant.hths_viscosity.value() / fresh_at(T));
  };
  // Thinning begins at the shear stress of the fresh oil.
  const double rate = stated ? *stated : rate_from_hths();
  constexpr double kMin = 1, kMax = 1e15;  // [1/s]
  if (!(rate >= kMin && rate <= kMax)) {
    throw InputError("lubricant.hths_viscosity and lubricant.shear_exponent give no critical shear rate of an oil: " +
                         std::to_string(rate) + " s-1",
                     "check both, or state lubricant.critical_shear_rate");
  }
  setup.thinning = film::ThinningOil{*law, rate * fresh_at(T), base::kAtmosphere};
  if (T_hths < T_low || T_hths > T_high) return;
  const double eta = viscosity(T_hths);
  setup.hths_viscosity = eta * law->ratio(models::kHthsShearRate * eta / setup.thinning->critical_stress);
}

/// The highest temperature at which the oil of a case serves a film that is warmer than its walls [K].
double hottest(const Lubricant& lubricant, double of_walls, double rise) {
  if (rise == 0) return of_walls;
  const double end = lubricant.table_file ? lubricant.table->temperature.back()
                                          : 0.5 * (of_walls + models::kHottestOil);  // a temperature below the highest
  return std::min(of_walls + rise, end);
}

/// Up to where the polynomials should serve [Pa].
double range_of_fits(double largest_mean_pressure) {
  constexpr double kMinRange = 20e6;  // [Pa]
  return std::max(4 * largest_mean_pressure, kMinRange);
}

}  // namespace

std::string celsius(double temperature) { return formatted("%.1f degC", number_in(temperature, kCelsius)); }

PreparedOil prepared_oil(const Lubricant& lubricant, std::optional<models::WallTemperatures> walls,
                         const OilConditions& conditions) {
  const double T = walls ? walls->film(0.5 * conditions.stroke) : conditions.temperature;
  const auto range = walls ? walls->film_range() : models::WallTemperatures::Range{T, T};
  if (lubricant.table_file) {
    const auto of_table = [table = lubricant.table](double at) { return models::tabulated_oil(*table, at); };
    of_table(range.low);  // refused where the table does not reach
    of_table(range.high);
    const double high = hottest(lubricant, range.high, conditions.rise);
    auto oil = std::make_shared<models::OilOverTemperature>(of_table, range.low, high);
    const auto at = oil->at(T);
    PreparedOil prepared{
        {std::move(walls), oil, T, at->viscosity(base::kAtmosphere), at->density(base::kAtmosphere), high, {}, {}},
        oil,
        {}};
    const auto viscosity = [&](double at_T) { return of_table(at_T)->viscosity(base::kAtmosphere); };
    const std::vector<double>& known = lubricant.table->temperature;
    add_thinning(lubricant, viscosity, known.front(), known.back(), prepared.setup);
    return prepared;
  }
  const models::OilLaws laws = oil_laws(lubricant);
  const double high = hottest(lubricant, range.high, conditions.rise);
  auto oil = std::make_shared<models::OilOverTemperature>(
      [laws](double at) { return models::closed_form_oil(laws, at); }, range.low, high);
  const models::OilState at = models::oil_state(laws, T);
  PreparedOil prepared{
      {std::move(walls), oil, T, at.eta_T, at.rho_T, high, {}, {}}, oil, extrapolation_notes(lubricant, laws, range)};
  add_dilution_note(lubricant, T, at.eta_T, prepared.notes);
  const auto viscosity = [&](double at_T) { return models::oil_state(laws, at_T).eta_T; };
  add_thinning(lubricant, viscosity, models::kColdestOil, models::kHottestOil, prepared.setup);
  return prepared;
}

PreparedOil own_oil(const std::string& name, std::shared_ptr<const models::OilAtTemperature> law, double temperature,
                    double largest_mean_pressure) {
  if (!law) throw InputError("an own oil has no law", "give one, for example models::oil_of_functions");
  models::check_oil(*law, 0, range_of_fits(largest_mean_pressure));
  const double viscosity = law->viscosity(base::kAtmosphere), density = law->density(base::kAtmosphere);
  const std::string called = name.empty() ? "an oil without a name" : "\"" + name + "\"";
  auto oil = std::make_shared<models::OilOverTemperature>(std::move(law));
  return {{std::nullopt, oil, temperature, viscosity, density, temperature, {}, {}},
          oil,
          {{"own-oil",
            "density and viscosity follow a law of the caller's own, " + called +
                ": the keys under lubricant in the case were not used, and the case alone does not give this result",
            1}}};
}

void fit_properties(PreparedOil& oil, double largest_mean_pressure) {
  const double high = range_of_fits(largest_mean_pressure);
  if (oil.range->fit(high) || oil.range->fit(high / 2)) return;
  oil.notes.push_back(
      {"properties-exact",
       "no polynomials follow the oil's laws within a relative " + formatted("%.0e", models::kFitError) +
           ", as solver.properties = \"fitted\" requires: the laws themselves are used, which takes longer",
       1});
}

std::optional<double> viscosity_without_shear(const Lubricant& lubricant, double T) {
  if (!lubricant.table_file) return models::oil_state(oil_laws(lubricant), T).eta_T;
  const std::vector<double>& known = lubricant.table->temperature;
  if (T < known.front() || T > known.back()) return std::nullopt;
  return models::tabulated_oil(*lubricant.table, T)->viscosity(base::kAtmosphere);
}

std::optional<double> fresh_viscosity_without_shear(const Lubricant& lubricant, double T) {
  return viscosity_without_shear(fresh(lubricant), T);
}

std::optional<models::ShearThinning> shear_thinning(const Lubricant& lubricant) {
  if (!lubricant.thins()) return std::nullopt;
  const double usual = models::usual_exponent(lubricant.shear_thinning);
  return models::ShearThinning{lubricant.shear_thinning, lubricant.second_newtonian_ratio,
                               lubricant.shear_exponent.value_or(usual)};
}

PadOil pad_oil(const Case& c) {
  constexpr double kZeroOfPressures = 0;
  const Lubricant& lubricant = c.lubricant;
  models::DowsonHigginson compression{0, 0};
  if (lubricant.compressibility == Compressibility::kDowsonHigginson) compression = {lubricant.dh_a, lubricant.dh_b};
  compression.reference_pressure = kZeroOfPressures;
  PadOil oil;
  models::OilState at{};
  if (const auto walls = wall_temperatures(c.thermal)) {
    const double T = walls->film(0);
    const models::OilLaws laws = oil_laws(lubricant);
    at = models::oil_state(laws, T);
    oil.temperature = T;
    oil.notes = extrapolation_notes(lubricant, laws, {T, T});
    add_dilution_note(lubricant, T, at.eta_T, oil.notes);
    OilSetup setup{};
    const auto viscosity = [&](double at_T) { return models::oil_state(laws, at_T).eta_T; };
    add_thinning(lubricant, viscosity, models::kColdestOil, models::kHottestOil, setup);
    oil.thinning = setup.thinning;
    if (oil.thinning) oil.thinning->reference_pressure = kZeroOfPressures;
  } else {
    at = {lubricant.viscosity, lubricant.constant_density.value(), lubricant.viscosity};
    if (const auto law = shear_thinning(lubricant)) {
      oil.thinning = {*law, lubricant.critical_shear_rate.value() * lubricant.viscosity, kZeroOfPressures};
    }
  }
  oil.viscosity = at.eta_T;
  oil.density = at.rho_T;
  oil.law = models::closed_form_oil(models::viscosity_law(lubricant.viscosity_pressure),
                                    {at.eta_T, at.eta_0, lubricant.law_parameters}, at.rho_T, compression);
  return oil;
}

}  // namespace ringfilm::cycle
