#include "ringfilm/cycle/advice/oil_plausibility.hpp"

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"

namespace ringfilm::cycle {
namespace {

/// Two points of the line (ASTM D341) of an oil [m2/s].
struct GradeLine {
  const char* name;
  double at_40, at_100;
};
/// The thickest and the thinnest grade of SAE J300: the bounds at 100 degC are those of the standard, the values at
/// 40 degC those of oils with a viscosity index of about 100.
constexpr GradeLine kThickest{"SAE 60", 350e-6, 26.1e-6}, kThinnest{"SAE 8", 16e-6, 4e-6};
/// Oils of other use, from gear and cylinder oils to fuels, stay within this factor of the grades.
constexpr double kOtherOils = 5;

double viscosity_of_grade(const GradeLine& grade, double temperature, double density) {
  models::OilLaws laws;
  laws.viscosity_temperature = {base::kZeroCelsius + 40, base::kZeroCelsius + 100};
  laws.kinematic_viscosity = {grade.at_40, grade.at_100};
  laws.density = {{temperature}, {density}};
  return models::oil_state(laws, temperature).eta_T;
}

}  // namespace

void append_viscosity_notes(const OilSetup& oil, std::vector<Note>& notes) {
  const auto range =
      oil.walls ? oil.walls->film_range() : models::WallTemperatures::Range{oil.temperature, oil.temperature};
  for (const double T : {range.low, range.high}) {
    const bool is_stated = T == oil.temperature;
    const auto at = oil.range->at(T);
    const double viscosity = is_stated ? oil.viscosity : at->viscosity(base::kAtmosphere);
    const double density = is_stated ? oil.density : at->density(base::kAtmosphere);
    const double highest = kOtherOils * viscosity_of_grade(kThickest, T, density);
    const double lowest = viscosity_of_grade(kThinnest, T, density) / kOtherOils;
    if (viscosity >= lowest && viscosity <= highest) continue;
    const bool high = viscosity > highest;
    notes.push_back({high ? "viscosity-high" : "viscosity-low",
                     formatted("the oil has %.4g mPa s at %s, %s %.3g mPa s, %s %s at this temperature: %s",
                               number_in(viscosity, kMillipascalSecond), celsius(T).c_str(), high ? "above" : "below",
                               number_in(high ? highest : lowest, kMillipascalSecond),
                               high ? "5 times that of" : "a fifth of that of", high ? kThickest.name : kThinnest.name,
                               "is the unit of its viscosity right?"),
                     1});
    return;
  }
}

}  // namespace ringfilm::cycle
