#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"
#include "ringfilm/models/oil/viscosity_index.hpp"

namespace ringfilm::cycle::table {
namespace {

bool has_laws(const Case& c) { return !c.lubricant.table_file; }

bool has_temperature(const Case& c) { return c.problem == Problem::kCycle || c.thermal.is_stated(); }

/// Does the oil follow laws of temperature? That of a pad without walls has one viscosity.
bool has_laws_of_temperature(const Case& c) { return has_laws(c) && has_temperature(c); }

constexpr When kLaws{has_laws, "no lubricant.table"};
constexpr When kLawsOfTemperature{has_laws_of_temperature,
                                  "no lubricant.table; in a pad thermal.ring or thermal.liner is stated"};
constexpr When kFuelInOil{[](const Case& c) { return has_laws_of_temperature(c) && c.lubricant.fuel > 0; },
                          "lubricant.fuel is more than 0"};
constexpr When kTemperature{has_temperature, "the case is not a pad, or thermal.ring or thermal.liner is stated"};
constexpr When kOneViscosity{[](const Case& c) { return !c.thermal.is_stated(); },
                             "no thermal.ring or thermal.liner is stated"};
constexpr When kHoupert{[](const Case& c) {
                          return has_laws_of_temperature(c) &&
                                 c.lubricant.viscosity_temperature == ViscosityTemperature::kHoupert;
                        },
                        "lubricant.viscosity_temperature = \"houpert\""};
constexpr When kDowsonHigginson{
    [](const Case& c) { return has_laws(c) && c.lubricant.compressibility == Compressibility::kDowsonHigginson; },
    "lubricant.compressibility = \"dowson-higginson\""};
constexpr When kThermalExpansivity{[](const Case& c) {
                                     return has_laws_of_temperature(c) &&
                                            c.lubricant.density_temperature == DensityTemperature::kThermalExpansivity;
                                   },
                                   "lubricant.density_temperature = \"thermal-expansivity\""};
constexpr When kThinning{[](const Case& c) { return c.lubricant.shear_thinning != ShearThinning::kNone; },
                         "lubricant.shear_thinning = \"cross\" or \"carreau\""};
constexpr When kCriticalShearRate{[](const Case& c) {
                                    return kThinning.holds(c) && has_temperature(c) &&
                                           c.lubricant.critical_shear_rate.has_value();
                                  },
                                  "lubricant.critical_shear_rate is stated, in a pad with thermal.ring or "
                                  "thermal.liner"};
constexpr When kHths{
    [](const Case& c) { return kThinning.holds(c) && has_temperature(c) && !c.lubricant.critical_shear_rate; },
    "lubricant.shear_thinning = \"cross\" or \"carreau\", without lubricant.critical_shear_rate; in "
    "a pad with thermal.ring or thermal.liner"};
constexpr When kMeniscus{[](const Case& c) { return c.film.outlet == Outlet::kCapillary; },
                         "film.outlet = \"capillary\""};
constexpr When kReferenceTemperature{
    [](const Case& c) { return kHoupert.holds(c) || kThermalExpansivity.holds(c); },
    "lubricant.viscosity_temperature = \"houpert\" or lubricant.density_temperature = \"thermal-expansivity\""};

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const auto& law : models::viscosity_laws()) names.push_back(law.name);
  return names;
}

std::string law_meanings() {
  std::string text = "viscosity against pressure";
  for (const auto& law : models::viscosity_laws()) text += "; " + law.name + ": " + law.meaning;
  return text;
}

/// The key of a number that laws of viscosity take; in use where one of them is chosen.
Field law_field(const models::LawParameter& parameter) {
  std::string laws;
  for (const auto& law : models::viscosity_laws()) {
    if (models::takes(law, parameter.key)) laws += (laws.empty() ? "\"" : " or \"") + law.name + "\"";
  }
  const NumberRef value = [key = parameter.key](auto& c) -> auto& { return c.lubricant.law_parameters.at(key); };
  const auto is_taken = [key = parameter.key](const Case& c) {
    return has_laws(c) && models::takes(models::viscosity_law(c.lubricant.viscosity_pressure), key);
  };
  return {.key = "lubricant." + parameter.key,
          .kind = NumberKind{value},
          .unit = parameter.unit,
          .display_unit = parameter.display_unit,
          .range = between(parameter.low, parameter.high),
          .need = parameter.statement == models::Statement::kRequired ? Need::kRequired : Need::kDefault,
          .active = is_taken,
          .active_when = "lubricant.viscosity_pressure = " + laws,
          .help = parameter.meaning,
          .example = parameter.example,
          .uses = {.pad = true}};
}

}  // namespace

void append_lubricant_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field({.key = "lubricant.file",
                 .kind = OptionalTextKind{member<&Case::lubricant, &Lubricant::file>},
                 .need = Need::kOptional,
                 .when = kTemperature,
                 .help = "TOML file with the keys of this section; a key given in both is an error",
                 .example = "\"data/lubricants/styles2014.toml\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.grade",
                 .kind = OptionalTextKind{member<&Case::lubricant, &Lubricant::grade>},
                 .need = Need::kOptional,
                 .when = kTemperature,
                 .help = "SAE grade of a shipped oil (`ringfilm oils` lists them), instead of lubricant.file",
                 .example = "\"SAE 10W-40\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.name",
                 .kind = TextKind{member<&Case::lubricant, &Lubricant::name>},
                 .help = "what the oil is called, for people",
                 .example = "\"my oil\"",
                 .uses = {.pad = true},
                 .is_for_record = true}),
          field({.key = "lubricant.kinematic_viscosity",
                 .kind = TemperatureValuesKind{member<&Case::lubricant, &Lubricant::kinematic_viscosity>},
                 .unit = kSquareMillimetrePerSecond,
                 .range = above(0, 1),
                 .need = Need::kRequired,
                 .when = kLawsOfTemperature,
                 .help = "kinematic viscosity nu at two or more temperatures; houpert: one at the reference "
                         "temperature will do",
                 .example = "[{ temperature = \"40 degC\", value = \"59.99 mm2/s\" }, "
                            "{ temperature = \"100 degC\", value = \"9.590 mm2/s\" }]",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.viscosity_index",
                 .kind = OptionalNumberKind{member<&Case::lubricant, &Lubricant::viscosity_index>},
                 .unit = kPlainNumber,
                 .range = between(0, models::kMaxViscosityIndex),
                 .need = Need::kOptional,
                 .when = kLawsOfTemperature,
                 .help = "viscosity index (ASTM D2270), with one kinematic viscosity, at 40 or 100 degC",
                 .example = "160",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.fuel",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::fuel>},
                 .unit = kPlainNumber,
                 .range = between(0, 1),
                 .when = kLawsOfTemperature,
                 .help = "fuel dissolved in the oil, share of the mass; viscosities mix by ASTM D7152",
                 .example = "0.03",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.fuel_viscosity",
                 .kind = TemperatureValuesKind{member<&Case::lubricant, &Lubricant::fuel_viscosity>},
                 .unit = kSquareMillimetrePerSecond,
                 .range = above(3e-7, 1e-3),
                 .when = kFuelInOil,
                 .help = "kinematic viscosity of that fuel at two or more temperatures; of diesel fuel, typical, "
                         "assumed",
                 .example = "[{ temperature = \"40 degC\", value = \"2.7 mm2/s\" }, "
                            "{ temperature = \"100 degC\", value = \"1.1 mm2/s\" }]",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.water",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::water>},
                 .unit = kPlainNumber,
                 .range = between(0, 0.1),
                 .when = kLawsOfTemperature,
                 .help = "water dispersed in the oil as drops, share of the mass; viscosity after Taylor (1932)",
                 .example = "0.02",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.viscosity",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::viscosity>},
                 .unit = kMillipascalSecond,
                 .range = above(0, 1e6),
                 .need = Need::kRequired,
                 .when = kOneViscosity,
                 .help = "dynamic viscosity eta of a pad's oil at the zero of its pressures, in place of temperatures",
                 .example = "\"39 mPa s\"",
                 .uses = {.cycle = false, .pad = true}}),
          field({.key = "lubricant.density",
                 .kind = ConstantOrTemperatureValuesKind{member<&Case::lubricant, &Lubricant::constant_density>,
                                                         member<&Case::lubricant, &Lubricant::density>},
                 .unit = si_unit("kg/m3"),
                 .range = above(0, 30000),
                 .need = Need::kRequired,
                 .when = kLaws,
                 .help = "density rho at atmospheric pressure, one value or values at temperatures; of a pad one "
                         "value, at the "
                         "zero of its pressures",
                 .example = "[{ temperature = \"15 degC\", value = \"849.7 kg/m3\" }, "
                            "{ temperature = \"40 degC\", value = \"833.8 kg/m3\" }]",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.table",
                 .kind = OptionalFileKind{member<&Case::lubricant, &Lubricant::table_file>},
                 .need = Need::kOptional,
                 .help =
                     "CSV file temperature [degC],pressure [Pa],viscosity [Pa s],density [kg/m3], instead of all laws",
                 .example = "\"oil_table.csv\""}),
          field({.key = "lubricant.viscosity_temperature",
                 .kind = choice<&Case::lubricant, &Lubricant::viscosity_temperature>(
                     {{"walther", ViscosityTemperature::kWalther}, {"houpert", ViscosityTemperature::kHoupert}}),
                 .when = kLawsOfTemperature,
                 .help = "viscosity against temperature: ASTM D341 through the points, or Houpert's term",
                 .example = "\"walther\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.viscosity_pressure",
                 .kind = choice_in_order<&Case::lubricant, &Lubricant::viscosity_pressure>(law_names()),
                 .when = kLaws,
                 .help = law_meanings(),
                 .example = "\"roelands\"",
                 .uses = {.pad = true}}),
      });
  for (const auto& parameter : models::law_parameters()) fields.push_back(law_field(parameter));
  fields.insert(
      fields.end(),
      {
          field({.key = "lubricant.temperature_viscosity_coefficient",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::temperature_viscosity_coefficient>},
                 .unit = si_unit("K-1"),
                 .range = between(0, 1),
                 .when = kHoupert,
                 .help = "temperature-viscosity coefficient, beta_0",
                 .example = "\"0.04 K-1\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.reference_temperature",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::reference_temperature>},
                 .unit = kCelsius,
                 .range = strictly_between(200, 600),
                 .when = kReferenceTemperature,
                 .help = "where eta_0 and rho_0 are taken, theta_0",
                 .example = "\"40 degC\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.density_temperature",
                 .kind = choice<&Case::lubricant, &Lubricant::density_temperature>(
                     {{"table", DensityTemperature::kTable},
                      {"thermal-expansivity", DensityTemperature::kThermalExpansivity}}),
                 .when = kLawsOfTemperature,
                 .help = "density against temperature: linear through the points and beyond, or by the expansivity",
                 .example = "\"table\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.thermal_expansivity",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::thermal_expansivity>},
                 .unit = si_unit("K-1"),
                 .range = between(0, 1e-2),
                 .when = kThermalExpansivity,
                 .help = "thermal expansivity, gamma",
                 .example = "\"7.5e-4 K-1\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.compressibility",
                 .kind = choice<&Case::lubricant, &Lubricant::compressibility>(
                     {{"dowson-higginson", Compressibility::kDowsonHigginson}, {"none", Compressibility::kNone}}),
                 .when = kLaws,
                 .help = "density against pressure",
                 .example = "\"dowson-higginson\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.dh_a",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::dh_a>},
                 .unit = si_unit("Pa-1"),
                 .range = between(0, 1e-6),
                 .when = kDowsonHigginson,
                 .help = "a of the density rho_0 [1 + a p/(1 + b p)]",
                 .example = "\"6e-10 Pa-1\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.dh_b",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::dh_b>},
                 .unit = si_unit("Pa-1"),
                 .range = between(0, 1e-6),
                 .when = kDowsonHigginson,
                 .help = "b of the same law",
                 .example = "\"1.7e-9 Pa-1\"",
                 .uses = {.pad = true}}),
          field(
              {.key = "lubricant.thermal_conductivity",
               .kind = NumberKind{member<&Case::lubricant, &Lubricant::thermal_conductivity>},
               .unit = si_unit("W/(m K)"),
               .range = between(0.01, 10),
               .help = "thermal conductivity of the oil, k, for the viscous heating; typical of mineral oils, assumed",
               .example = "\"0.14 W/(m K)\"",
               .uses = {.pad = true}}),
          field({.key = "lubricant.specific_heat",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::specific_heat>},
                 .unit = si_unit("J/(kg K)"),
                 .range = between(100, 10000),
                 .help = "specific heat of the oil, c_p; typical of mineral oils, assumed",
                 .example = "\"2100 J/(kg K)\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.surface_tension",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::surface_tension>},
                 .unit = si_unit("N/m"),
                 .range = between(0.001, 1),
                 .when = kMeniscus,
                 .help = "surface tension of the oil against gas; typical of mineral oils, assumed",
                 .example = "\"0.03 N/m\""}),
          field({.key = "lubricant.shear_thinning",
                 .kind = choice<&Case::lubricant, &Lubricant::shear_thinning>({{"none", ShearThinning::kNone},
                                                                               {"cross", ShearThinning::kCross},
                                                                               {"carreau", ShearThinning::kCarreau}}),
                 .help = "viscosity against the shear rate: none, eta times R + (1 - R)/(1 + (g/g_c)^m), or eta times "
                         "R + (1 - R)(1 + (g/g_c)^2)^((n - 1)/2)",
                 .example = "\"cross\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.second_newtonian_ratio",
                 .kind = NumberKind{member<&Case::lubricant, &Lubricant::second_newtonian_ratio>},
                 .unit = kPlainNumber,
                 .range = above(0, 1),
                 .when = kThinning,
                 .help = "viscosity at the highest shear rates over that without shear, R; typical of multigrade oils, "
                         "assumed",
                 .example = "0.7",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.critical_shear_rate",
                 .kind = OptionalNumberKind{member<&Case::lubricant, &Lubricant::critical_shear_rate>},
                 .unit = si_unit("s-1"),
                 .range = above(0, 1e15),
                 .need = Need::kOptional,
                 .when = kThinning,
                 .help = "shear rate g_c of the law, in place of lubricant.hths_viscosity",
                 .example = "\"2.4e6 s-1\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.critical_shear_rate_temperature",
                 .kind = OptionalNumberKind{member<&Case::lubricant, &Lubricant::critical_shear_rate_temperature>},
                 .unit = kCelsius,
                 .range = strictly_between(models::kColdestOil, models::kHottestOil),
                 .need = Need::kRequired,
                 .when = kCriticalShearRate,
                 .help =
                     "temperature at which the oil has that g_c; at others g_c goes with the inverse of the viscosity",
                 .example = "\"120 degC\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.shear_exponent",
                 .kind = OptionalNumberKind{member<&Case::lubricant, &Lubricant::shear_exponent>},
                 .unit = kPlainNumber,
                 .range = above(0, 2),
                 .need = Need::kOptional,
                 .when = kThinning,
                 .help = "m of \"cross\", 1 if omitted, or n of \"carreau\", below 1, 0.5 if omitted",
                 .example = "1.0",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.hths_viscosity",
                 .kind = OptionalNumberKind{member<&Case::lubricant, &Lubricant::hths_viscosity>},
                 .unit = kMillipascalSecond,
                 .range = above(0, 1e3),
                 .need = Need::kOptional,
                 .when = kHths,
                 .help = "viscosity at 150 degC and 1e6 s-1 (HTHS, ASTM D4683), from which g_c follows",
                 .example = "\"2.9 mPa s\"",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.distillation",
                 .kind = DistillationKind{member<&Case::lubricant, &Lubricant::distillation>},
                 .need = Need::kOptional,
                 .when = kOilFollowed,
                 .help = "fractions of the oil by boiling point at 1.01325 bar, for its evaporation; if omitted, "
                         "those of lubricant.noack; without both nothing evaporates",
                 .example = "[{ share = 0.3, boiling_point = \"440 degC\", molar_mass = \"380 g/mol\" }, "
                            "{ share = 0.7, boiling_point = \"540 degC\" }]",
                 .uses = {.pad = true}}),
          field({.key = "lubricant.noack",
                 .kind = OptionalNumberKind{member<&Case::lubricant, &Lubricant::noack>},
                 .unit = kPlainNumber,
                 .range = between(models::kMinNoackLoss, models::kMaxNoackLoss),
                 .need = Need::kOptional,
                 .when = kOilFollowed,
                 .help = "loss of mass in the Noack test (ASTM D5800), in place of lubricant.distillation: typical "
                         "fractions, shifted to lose as much; assumed",
                 .example = "0.12",
                 .uses = {.pad = true}}),
      });
}

}  // namespace ringfilm::cycle::table
