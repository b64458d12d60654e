#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kWallTemperatures{[](const Case& c) { return c.thermal.is_stated(); },
                                 "thermal.ring or thermal.liner is stated"};

}  // namespace

void append_thermal_fields(std::vector<Field>& fields) {
  const Range temperature = strictly_between(models::kColdestOil, models::kHottestOil);
  fields.insert(
      fields.end(),
      {
          field({.key = "thermal.ring",
                 .kind = OptionalNumberKind{member<&Case::thermal, &Thermal::ring>},
                 .unit = kCelsius,
                 .range = temperature,
                 .need = Need::kOptional,
                 .help = "temperature of the ring's face, or of a pad",
                 .example = "\"190 degC\"",
                 .uses = {.pad = true}}),
          field(
              {.key = "thermal.liner",
               .kind = StrokeValuesKind{member<&Case::thermal, &Thermal::liner>},
               .unit = kCelsius,
               .range = temperature,
               .need = Need::kOptional,
               .help =
                   "temperature of the liner: one, or [distance of the ring from its TDC position, temperature] at "
                   "increasing distances, linear between them and constant beyond; of the flat surface under a pad one",
               .example = "[[\"0 mm\", \"180 degC\"], [\"79.5 mm\", \"110 degC\"]]",
               .uses = {.pad = true, .gas = true}}),
          field({.key = "thermal.film",
                 .kind = choice<&Case::thermal, &Thermal::film>({{"mean-of-walls", FilmTemperature::kMeanOfWalls},
                                                                 {"liner", FilmTemperature::kLiner},
                                                                 {"ring", FilmTemperature::kRing}}),
                 .when = kWallTemperatures,
                 .help = "whose temperature the oil film has, in place of operating.oil_temperature or a pad's "
                         "lubricant.viscosity",
                 .example = "\"mean-of-walls\"",
                 .uses = {.pad = true}}),
          field(
              {.key = "thermal.viscous_heating",
               .kind = choice<&Case::thermal, &Thermal::viscous_heating>(
                   {{"none", ViscousHeating::kNone}, {"in-film", ViscousHeating::kInFilm}}),
               .help =
                   "whether the oil of each step is warmer by the rise that its shear causes; the rise is reported in "
                   "both cases",
               .example = "\"in-film\""}),
      });
}

}  // namespace ringfilm::cycle::table
