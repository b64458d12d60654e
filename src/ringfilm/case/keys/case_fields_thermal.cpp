#include "ringfilm/case/keys/case_fields_table.hpp"
#include "ringfilm/models/oil/oil_temperature.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kWallTemperatures{[](const Case& c) { return c.thermal.is_stated(); },
                                 "thermal.ring or thermal.liner is stated"};

}  // namespace

void append_thermal_fields(std::vector<Field>& fields) {
  const Unit kelvin{"K", "degC"};
  const Range temperature = strictly_between(models::kColdestOil, models::kHottestOil);
  fields.insert(
      fields.end(),
      {
          field("thermal.ring", OptionalNumberKind{member<&Case::thermal, &Thermal::ring>}, kelvin, temperature,
                Need::kOptional, {}, {"temperature of the ring's face, or of a pad", "\"190 degC\""}),
          field("thermal.liner", StrokeValuesKind{member<&Case::thermal, &Thermal::liner>}, kelvin, temperature,
                Need::kOptional, {},
                {"temperature of the liner: one, or [distance of the ring from its TDC position, temperature] at "
                 "increasing distances, linear between them and constant beyond; of the flat surface under a pad one",
                 "[[\"0 mm\", \"180 degC\"], [\"79.5 mm\", \"110 degC\"]]"}),
          field("thermal.film", choice<&Case::thermal, &Thermal::film>({"mean-of-walls", "liner", "ring"}), kNoUnit, {},
                Need::kDefault, kWallTemperatures,
                {"whose temperature the oil film has, in place of operating.oil_temperature or a pad's "
                 "lubricant.viscosity",
                 "\"mean-of-walls\""}),
          field("thermal.viscous_heating", choice<&Case::thermal, &Thermal::viscous_heating>({"none", "in-film"}),
                kNoUnit, {}, Need::kDefault, {},
                {"whether the oil of each step is warmer by the rise that its shear causes; the rise is reported in "
                 "both cases",
                 "\"in-film\""}),
      });
}

}  // namespace ringfilm::cycle::table
