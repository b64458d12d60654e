#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"

namespace ringfilm::cycle::table {
namespace {

bool has_laws(const Case& c) { return !c.lubricant.table_file; }

bool has_temperature(const Case& c) { return c.problem == Problem::kCycle || c.thermal.is_stated(); }

/// Does the oil follow laws of temperature? That of a pad without walls has one viscosity.
bool has_laws_of_temperature(const Case& c) { return has_laws(c) && has_temperature(c); }

constexpr When kLaws{has_laws, "no lubricant.table"};
constexpr When kLawsOfTemperature{has_laws_of_temperature,
                                  "no lubricant.table; in a pad thermal.ring or thermal.liner is stated"};
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
          .example = parameter.example};
}

}  // namespace

void append_lubricant_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field("lubricant.file", OptionalTextKind{member<&Case::lubricant, &Lubricant::file>}, kNoUnit, {},
                Need::kOptional, kTemperature,
                {"TOML file with the keys of this section; a key given in both is an error",
                 "\"data/lubricants/styles2014.toml\""}),
          field(
              "lubricant.grade", OptionalTextKind{member<&Case::lubricant, &Lubricant::grade>}, kNoUnit, {},
              Need::kOptional, kTemperature,
              {"SAE grade of a shipped oil (`ringfilm oils` lists them), instead of lubricant.file", "\"SAE 10W-40\""}),
          field("lubricant.name", TextKind{member<&Case::lubricant, &Lubricant::name>}, kNoUnit, {}, Need::kDefault, {},
                {"what the oil is called, for people", "\"my oil\""}),
          field(
              "lubricant.kinematic_viscosity",
              TemperatureValuesKind{member<&Case::lubricant, &Lubricant::kinematic_viscosity>}, {"m2/s", "mm2/s"},
              above(0, 1), Need::kRequired, kLawsOfTemperature,
              {"kinematic viscosity nu at two or more temperatures; houpert: one at the reference temperature will do",
               "[{ temperature = \"40 degC\", value = \"59.99 mm2/s\" }, "
               "{ temperature = \"100 degC\", value = \"9.590 mm2/s\" }]"}),
          field("lubricant.viscosity", NumberKind{member<&Case::lubricant, &Lubricant::viscosity>}, {"Pa s", "mPa s"},
                above(0, 1e6), Need::kRequired, kOneViscosity,
                {"dynamic viscosity eta of a pad's oil at the zero of its pressures, in place of temperatures",
                 "\"39 mPa s\""}),
          field("lubricant.density",
                ConstantOrTemperatureValuesKind{member<&Case::lubricant, &Lubricant::constant_density>,
                                                member<&Case::lubricant, &Lubricant::density>},
                {"kg/m3", "kg/m3"}, above(0, 30000), Need::kRequired, kLaws,
                {"density rho at atmospheric pressure, one value or values at temperatures; of a pad one value, at the "
                 "zero of its pressures",
                 "[{ temperature = \"15 degC\", value = \"849.7 kg/m3\" }, "
                 "{ temperature = \"40 degC\", value = \"833.8 kg/m3\" }]"}),
          field("lubricant.table", OptionalFileKind{member<&Case::lubricant, &Lubricant::table_file>}, kNoUnit, {},
                Need::kOptional, {},
                {"CSV file temperature [degC],pressure [Pa],viscosity [Pa s],density [kg/m3], instead of all laws",
                 "\"oil_table.csv\""}),
          field("lubricant.viscosity_temperature",
                choice<&Case::lubricant, &Lubricant::viscosity_temperature>({"walther", "houpert"}), kNoUnit, {},
                Need::kDefault, kLawsOfTemperature,
                {"viscosity against temperature: ASTM D341 through the points, or Houpert's term", "\"walther\""}),
          field("lubricant.viscosity_pressure", choice<&Case::lubricant, &Lubricant::viscosity_pressure>(law_names()),
                kNoUnit, {}, Need::kDefault, kLaws, {law_meanings(), "\"roelands\""}),
      });
  for (const auto& parameter : models::law_parameters()) fields.push_back(law_field(parameter));
  fields.insert(
      fields.end(),
      {
          field("lubricant.temperature_viscosity_coefficient",
                NumberKind{member<&Case::lubricant, &Lubricant::temperature_viscosity_coefficient>}, {"K-1", "K-1"},
                between(0, 1), Need::kDefault, kHoupert, {"temperature-viscosity coefficient, beta_0", "\"0.04 K-1\""}),
          field("lubricant.reference_temperature",
                NumberKind{member<&Case::lubricant, &Lubricant::reference_temperature>}, {"K", "degC"},
                strictly_between(200, 600), Need::kDefault, kReferenceTemperature,
                {"where eta_0 and rho_0 are taken, theta_0", "\"40 degC\""}),
          field("lubricant.density_temperature",
                choice<&Case::lubricant, &Lubricant::density_temperature>({"table", "thermal-expansivity"}), kNoUnit,
                {}, Need::kDefault, kLawsOfTemperature,
                {"density against temperature: linear through the points and beyond, or by the expansivity",
                 "\"table\""}),
          field("lubricant.thermal_expansivity", NumberKind{member<&Case::lubricant, &Lubricant::thermal_expansivity>},
                {"K-1", "K-1"}, between(0, 1e-2), Need::kDefault, kThermalExpansivity,
                {"thermal expansivity, gamma", "\"7.5e-4 K-1\""}),
          field("lubricant.compressibility",
                choice<&Case::lubricant, &Lubricant::compressibility>({"dowson-higginson", "none"}), kNoUnit, {},
                Need::kDefault, kLaws, {"density against pressure", "\"dowson-higginson\""}),
          field("lubricant.dh_a", NumberKind{member<&Case::lubricant, &Lubricant::dh_a>}, {"Pa-1", "Pa-1"},
                between(0, 1e-6), Need::kDefault, kDowsonHigginson,
                {"a of the density rho_0 [1 + a p/(1 + b p)]", "\"6e-10 Pa-1\""}),
          field("lubricant.dh_b", NumberKind{member<&Case::lubricant, &Lubricant::dh_b>}, {"Pa-1", "Pa-1"},
                between(0, 1e-6), Need::kDefault, kDowsonHigginson, {"b of the same law", "\"1.7e-9 Pa-1\""}),
          field("lubricant.thermal_conductivity",
                NumberKind{member<&Case::lubricant, &Lubricant::thermal_conductivity>}, {"W/(m K)", "W/(m K)"},
                between(0.01, 10), Need::kDefault, {},
                {"thermal conductivity of the oil, k, for the viscous heating; typical of mineral oils, assumed",
                 "\"0.14 W/(m K)\""}),
          field("lubricant.specific_heat", NumberKind{member<&Case::lubricant, &Lubricant::specific_heat>},
                {"J/(kg K)", "J/(kg K)"}, between(100, 10000), Need::kDefault, {},
                {"specific heat of the oil, c_p; typical of mineral oils, assumed", "\"2100 J/(kg K)\""}),
          field("lubricant.shear_thinning",
                choice<&Case::lubricant, &Lubricant::shear_thinning>({"none", "cross", "carreau"}), kNoUnit, {},
                Need::kDefault, {},
                {"viscosity against the shear rate: none, eta times R + (1 - R)/(1 + (g/g_c)^m), or eta times "
                 "R + (1 - R)(1 + (g/g_c)^2)^((n - 1)/2)",
                 "\"cross\""}),
          field("lubricant.second_newtonian_ratio",
                NumberKind{member<&Case::lubricant, &Lubricant::second_newtonian_ratio>}, kPlainNumber, above(0, 1),
                Need::kDefault, kThinning,
                {"viscosity at the highest shear rates over that without shear, R; typical of multigrade oils, assumed",
                 "0.7"}),
          field("lubricant.critical_shear_rate",
                OptionalNumberKind{member<&Case::lubricant, &Lubricant::critical_shear_rate>}, {"s-1", "s-1"},
                above(0, 1e15), Need::kOptional, kThinning,
                {"shear rate g_c of the law, in place of lubricant.hths_viscosity", "\"2.4e6 s-1\""}),
          field("lubricant.critical_shear_rate_temperature",
                OptionalNumberKind{member<&Case::lubricant, &Lubricant::critical_shear_rate_temperature>},
                {"K", "degC"}, strictly_between(models::kColdestOil, models::kHottestOil), Need::kRequired,
                kCriticalShearRate,
                {"temperature at which the oil has that g_c; at others g_c goes with the inverse of the viscosity",
                 "\"120 degC\""}),
          field("lubricant.shear_exponent", OptionalNumberKind{member<&Case::lubricant, &Lubricant::shear_exponent>},
                kPlainNumber, above(0, 2), Need::kOptional, kThinning,
                {"m of \"cross\", 1 if omitted, or n of \"carreau\", below 1, 0.5 if omitted", "1.0"}),
          field("lubricant.hths_viscosity", OptionalNumberKind{member<&Case::lubricant, &Lubricant::hths_viscosity>},
                {"Pa s", "mPa s"}, above(0, 1e3), Need::kOptional, kHths,
                {"viscosity at 150 degC and 1e6 s-1 (HTHS, ASTM D4683), from which g_c follows", "\"2.9 mPa s\""}),
      });
}

}  // namespace ringfilm::cycle::table
